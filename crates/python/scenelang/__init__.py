"""Scenes as programs: check, solve and sample 3D scenes from their requirements.

The same formula is a verdict and a margin: by how many metres or degrees it holds (positive) or fails (negative). So a program
is a reset condition (`solve`, `sample`), a success predicate (`holds`) and a dense reward (`margins`).

Everything is in the frame of layout files: left-handed, y up, metres, degrees. Poses may be given as simulators have them
instead, see `Evaluator`.
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Mapping, Sequence, Union

from . import _native, _show
from ._arrays import flat, shaped
from ._errors import ContradictionError, SceneError

__all__ = [
    "ContradictionError",
    "Evaluator",
    "Formalized",
    "Layout",
    "Program",
    "Repair",
    "Report",
    "SceneError",
    "Solution",
    "check",
    "compile",
    "formalize",
    "holds",
    "margins",
    "repair",
    "sample",
    "solve",
]

Order = Literal["wxyz", "xyzw"]
Frame = Literal["scene", "z-up"]
Source = Union["Program", str, "os.PathLike[str]"]
Placed = Union["Layout", Mapping[str, Any], str, "os.PathLike[str]"]


class Program:
    """A program that compiles. `compile` makes one; it can be pickled."""

    __slots__ = ("_native",)

    def __init__(self, native: _native.Program) -> None:
        self._native = native

    @property
    def name(self) -> str:
        """What it is called in messages: its path as it was given, or ``program.scene``."""
        return self._native.name

    @property
    def text(self) -> str:
        """Its text as it was compiled."""
        return self._native.text

    @property
    def objects(self) -> list[str]:
        """Names of the objects, in the order of declaration; arrays as their elements: ``chair[0]``."""
        return self._native.objects

    @property
    def regions(self) -> list[str]:
        """Names of the regions."""
        return self._native.regions

    @property
    def constraints(self) -> list[dict[str, Any]]:
        """What it states, in the order of the columns of `margins`.

        Each has an ``id`` (as in reports), a ``kind`` (``"assert"``, ``"prefer"``, ``"pin"`` for an assignment), its
        ``text``, the ``weight`` of a preference or None, and its ``requirements``.
        """
        constraints: list[dict[str, Any]] = json.loads(self._native.constraints())
        return constraints

    @property
    def warnings(self) -> list[dict[str, Any]]:
        """What is suspicious in its text; `check` also says what is proved of it."""
        findings: list[dict[str, Any]] = json.loads(self._native.findings())
        return findings

    def __repr__(self) -> str:
        return f"<scenelang.Program {self.name}: {len(self.objects)} objects, {len(self.constraints)} constraints>"

    def __reduce__(self) -> Any:
        return _again, (self.name, os.fspath(self._native.path), self.text)

    def _repr_html_(self) -> str:
        return _show.program(self.name, self.text, self.warnings)


def _again(name: str, path: str, text: str) -> Program:
    return Program(_native.Program(name, path, text))


@dataclass(frozen=True)
class Layout:
    """A layout file: where everything is. `text` is its JSON; writing it to ``NAME.layout.json`` makes the file."""

    text: str
    name: str = "program.layout.json"
    #: The program it was made for, where that is known.
    program: Program | None = field(default=None, repr=False, compare=False)

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Layout:
        """Reads a layout file."""
        return cls(Path(path).read_text(encoding="utf-8"), os.fspath(path))

    def to_dict(self) -> dict[str, Any]:
        """The file as data: ``objects`` and ``regions`` by name, each with ``pos`` (metres), ``rot`` (degrees), ``scale``."""
        data: dict[str, Any] = json.loads(self.text)
        return data

    @property
    def objects(self) -> dict[str, Any]:
        """Placed objects by name. ``pos`` is the middle of the bottom face."""
        objects: dict[str, Any] = self.to_dict().get("objects", {})
        return objects

    def __repr__(self) -> str:
        return f"<scenelang.Layout {self.name}: {len(self.objects)} objects>"

    def _repr_html_(self) -> str | None:
        return None if self.program is None else check(self.program, self)._repr_html_()


class Report:
    """What holds, by how much, and why not: what ``scenelang check --format json`` prints."""

    __slots__ = ("data", "layout", "program")

    def __init__(self, data: dict[str, Any], program: Program | None = None, layout: Layout | None = None) -> None:
        #: The whole report.
        self.data = data
        self.program = program
        self.layout = layout

    @property
    def ok(self) -> bool:
        """Whether all that must hold does, and nothing stood in the way of judging it."""
        return bool(self.data["ok"])

    @property
    def summary(self) -> dict[str, dict[str, int]]:
        """How many of each kind there are and how many hold: ``assertions``, ``preferences``, ``physical``, ``pins``."""
        summary: dict[str, dict[str, int]] = self.data["summary"]
        return summary

    @property
    def constraints(self) -> list[dict[str, Any]]:
        """A row for each constraint, then one for each physical rule that fails."""
        rows: list[dict[str, Any]] = self.data["constraints"]
        return rows

    @property
    def violations(self) -> list[dict[str, Any]]:
        """The rows of what must hold and does not."""
        return [row for row in self.constraints if row["satisfied"] is False and row["kind"] != "prefer"]

    @property
    def diagnostics(self) -> list[dict[str, Any]]:
        """Findings about the files."""
        findings: list[dict[str, Any]] = self.data["diagnostics"]
        return findings

    def rows(self) -> list[dict[str, Any]]:
        """The constraints as flat rows, for ``pandas.DataFrame`` or ``csv.DictWriter``.

        Columns: ``id``, ``kind``, ``rule``, ``satisfied`` (None: cannot be checked), ``margin`` (metres or degrees; None where
        there is no measure), ``unit``, ``weight``, ``objects`` (joined by spaces), ``text``, ``message``.
        """
        columns = ("id", "kind", "rule", "satisfied", "margin", "unit", "weight", "objects", "text", "message")
        flat_rows = ({**row, "objects": " ".join(row["objects"])} for row in self.constraints)
        return [{column: row.get(column) for column in columns} for row in flat_rows]

    def __repr__(self) -> str:
        held = ", ".join(f"{t['satisfied']} of {t['total']} {kind}" for kind, t in self.summary.items() if t["total"])
        return f"<scenelang.Report {self.data['file']}: {'ok' if self.ok else 'not ok'}, {held or 'nothing checked'}>"

    def _repr_html_(self) -> str:
        plan = None
        if self.program is not None and self.layout is not None:
            try:
                plan = self.program._native.plan(self.layout.name, self.layout.text)
            except SceneError:
                pass  # the list says what is wrong with it
        return _show.report(self.data, plan)


@dataclass(frozen=True)
class Solution:
    """What came of `solve`."""

    #: The layout, or what comes closest to one.
    layout: Layout
    #: The judgement of it.
    report: Report
    #: Why the search ended: ``"solved"``, ``"budget"``, ``"time"``, ``"exhausted"``, ``"interrupted"``.
    end: str
    #: Statements without which the rest can hold, as ``id`` and ``text``; found by search, not proved.
    in_the_way: list[dict[str, str]]
    #: What had no usual size or no furniture of its own.
    warnings: list[str]

    @property
    def ok(self) -> bool:
        """Whether all that must hold does."""
        return self.report.ok

    def _repr_html_(self) -> str:
        return self.report._repr_html_()


@dataclass(frozen=True)
class Repair:
    """A way to repair a layout; `repair` gives the best first."""

    #: ``"move"``, ``"number"`` (a number of the program is relaxed), ``"drop"`` or ``"prefer"`` (a statement gives way).
    how: str
    #: The same in words.
    text: str
    #: By which ways of one kind are ordered.
    cost: float
    #: What is moved: ``object``, ``by`` (metres), ``turn`` (degrees), ``pos``, ``rot``.
    moves: list[dict[str, Any]]
    #: What is changed in the program: ``span``, ``old``, ``text``.
    edits: list[dict[str, Any]]
    #: The layout afterwards.
    layout: Layout
    #: The text of the program afterwards; None where it stays, or where the change is in a file that it imports.
    program_text: str | None


@dataclass(frozen=True)
class Formalized:
    """What came of a request in plain words."""

    #: The program.
    program: Program
    #: Whether anything was understood.
    understood: bool
    #: The clauses of the request: ``text`` and whether it was ``understood``.
    clauses: list[dict[str, Any]]
    #: Words that became no part of the program.
    unused: list[str]
    #: What was left out or changed: ``text`` of the request and ``reason``.
    notes: list[dict[str, str]]
    #: Whether a layout was ``"found"`` in the trial, ``"not found"``, is known not to fit (``"overfull"``), or ``"untried"``.
    layout: str

    def _repr_html_(self) -> str:
        return self.program._repr_html_()


class Evaluator:
    """Margins of a program in many environments that differ in where objects are.

    Sizes, parts, regions, variables and draws are those of `layout`. `objects` names those that poses are given for; the others
    stay where the layout has them. Without it, poses are given for all, in the order of `Program.objects`.

    A pose has 7 numbers: x, y, z of the middle of the bottom face (metres), and a unit quaternion, which is normalized.

    - `order` says where its real part is: ``"wxyz"`` (MuJoCo, Isaac, SAPIEN) or ``"xyzw"`` (ROS, Unity).
    - `frame` is ``"scene"``, the left-handed frame of layouts with y up, or ``"z-up"``, the right-handed frame with z up of the
      MJCF and SDF that scenelang writes: a point (x, y, z) of the one is (x, z, y) of the other, and likewise for the axes of
      objects.

    With 6 numbers the last three are the Euler angles of layouts (degrees). Layouts are judged by these: a quaternion is
    converted to them, rounded to a billionth of a degree.

    Nothing is kept between calls, so an evaluator can be used by several threads, and pickled.
    """

    __slots__ = ("_native", "layout", "program", "_objects")

    def __init__(self, program: Source, layout: Placed | None = None, *, objects: Sequence[str] | None = None) -> None:
        self.program = _program(program)
        self.layout = _layout(self.program, layout)
        self._objects = None if objects is None else list(objects)
        self._native = _native.Evaluator(self.program._native, (self.layout.name, self.layout.text), self._objects)

    @property
    def objects(self) -> list[str]:
        """The objects that poses are given for, in order."""
        return self._native.objects

    @property
    def columns(self) -> list[dict[str, Any]]:
        """What the columns of margins are: `Program.constraints`."""
        return self.program.constraints

    def poses(self, *, order: Order = "wxyz", frame: Frame = "scene", euler: bool = False) -> Any:
        """Where the layout has the objects: ``[objects, 7]``, or ``[objects, 6]`` with Euler angles (degrees)."""
        width = 6 if euler else 7
        return shaped(self._native.poses(width, order, frame), "d", (len(self.objects), width))

    def margins(self, poses: Any, *, order: Order = "wxyz", frame: Frame = "scene", threads: int = 0) -> Any:
        """By how much each constraint holds (> 0) or fails (< 0), tolerances included; metres or degrees.

        ``poses[environments, objects, 7]`` gives ``[environments, constraints]`` in float64; ``poses[objects, 7]`` gives
        ``[constraints]``. ±inf is a fact without a measure, NaN cannot be checked. An environment in which a pose is not finite
        is NaN altogether.

        `threads` is how many work at once, 0 as many as there are cores. The margins do not depend on it.
        """
        values, width, leading = flat(poses, len(self.objects))
        data = self._native.margins(values, width, order, frame, threads)
        return shaped(data, "d", (*leading, len(self.columns)))

    def holds(self, poses: Any, *, order: Order = "wxyz", frame: Frame = "scene", threads: int = 0) -> Any:
        """Which constraints hold, as `margins`, but bool. What cannot be checked does not hold."""
        values, width, leading = flat(poses, len(self.objects))
        data = self._native.holds(values, width, order, frame, threads)
        return shaped(data, "?", (*leading, len(self.columns)))

    def layout_of(self, poses: Any, *, order: Order = "wxyz", frame: Frame = "scene") -> Layout:
        """The layout file of one environment, ``poses[objects, 7]``: what `check` says of it is what `margins` says here."""
        values, width, leading = flat(poses, len(self.objects))
        if leading:
            raise ValueError("one environment at a time is a layout: give poses[i]")
        return Layout(self._native.layout(values, width, order, frame), self.layout.name, self.program)

    def __reduce__(self) -> Any:
        return _evaluator, (self.program, self.layout, self._objects)

    def __repr__(self) -> str:
        return f"<scenelang.Evaluator {self.program.name}: poses [n, {len(self.objects)}, 7], margins [n, {len(self.columns)}]>"


def _evaluator(program: Program, layout: Layout, objects: list[str] | None) -> Evaluator:
    return Evaluator(program, layout, objects=objects)


def _is_file(source: str | os.PathLike[str]) -> bool:
    """A text of a program is no name: it has a line feed or a semicolon, or does not end as one."""
    return not isinstance(source, str) or (source.endswith(".scene") and "\n" not in source and ";" not in source)


def compile(source: str | os.PathLike[str]) -> Program:
    """Compiles a program: a path (a ``Path``, or a string that ends with ``.scene``) or a text.

    What a text imports is looked for in the current folder, and so are the settings (``scenelang.toml``) that count for it.

    Raises `SceneError` where it does not compile.
    """
    if _is_file(source):
        return Program(_native.Program(os.fspath(source), source, None))
    return Program(_native.Program("program.scene", "program.scene", os.fspath(source)))


def _program(source: Source) -> Program:
    return source if isinstance(source, Program) else compile(source)


def _layout(program: Program, given: Placed | None) -> Layout:
    if isinstance(given, Layout):
        return given
    beside = os.path.splitext(program.name)[0] + ".layout.json"
    if given is None:
        path = Path(program._native.path).with_suffix(".layout.json")
        if not path.is_file():
            raise SceneError(f"there is no layout beside {program.name}: `solve` makes one")
        return Layout(path.read_text(encoding="utf-8"), beside, program)
    if isinstance(given, Mapping):
        return Layout(json.dumps(given), beside, program)
    if isinstance(given, str) and given.lstrip().startswith("{"):
        return Layout(given, beside, program)
    return Layout.read(given)


def _pair(layout: Layout) -> tuple[str, str]:
    return layout.name, layout.text


def check(program: Source, layout: Placed | None = None) -> Report:
    """Judges a layout, or a program by itself: what is proved of it.

    A layout is a `Layout`, a path, the text of a layout file, or its data. The report is what ``scenelang check --format json``
    prints. A layout that breaks something, or cannot be checked, is a report, too; `SceneError` is raised only where the
    program does not compile or a file cannot be read.
    """
    program = _program(program)
    placed = None if layout is None else _layout(program, layout)
    data = json.loads(program._native.check(None if placed is None else _pair(placed)))
    return Report(data, program, placed)


def margins(
    program: Source,
    poses: Any,
    layout: Placed | None = None,
    *,
    order: Order = "wxyz",
    frame: Frame = "scene",
    threads: int = 0,
) -> Any:
    """Margins of all constraints in many environments: ``poses[environments, objects, 7]`` → ``[environments, constraints]``.

    Sizes and all else that does not move come from `layout`, by default the one beside the program. Who asks again and again
    makes an `Evaluator`, whose `Evaluator.margins` this is.
    """
    return Evaluator(program, layout).margins(poses, order=order, frame=frame, threads=threads)


def holds(
    program: Source,
    poses: Any,
    layout: Placed | None = None,
    *,
    order: Order = "wxyz",
    frame: Frame = "scene",
    threads: int = 0,
) -> Any:
    """Which constraints hold in many environments: as `margins`, but bool."""
    return Evaluator(program, layout).holds(poses, order=order, frame=frame, threads=threads)


def solve(
    program: Source,
    *,
    seed: int = 0,
    start: Placed | None = None,
    lock: Sequence[str] = (),
    only: Sequence[str] = (),
    time: float | None = None,
    effort: int = 1,
    quality: int | None = None,
    threads: int = 0,
) -> Solution:
    """Looks for a layout in which everything holds that must, and as much as can be of what is preferred.

    - `seed` fixes draws and every random choice: the same program and seed give the same layout.
    - `start`: a layout to start from; `lock` names objects that stay where it has them, `only` the only ones that may move.
    - `time`: at most so many seconds; without it the work is bounded, and the result does not depend on the machine.
    - `effort`: how many times the usual work may be done; `quality`: what part of it may go into preferences, in percent.

    A layout that breaks something is a result, too: see `Solution.ok`. Raises `ContradictionError` where it is proved that
    there is none.
    """
    program = _program(program)
    first = None if start is None else _pair(_layout(program, start))
    data = json.loads(
        _native.solve(
            program._native,
            seed=seed,
            start=first,
            lock=list(lock),
            only=list(only),
            time=time,
            effort=effort,
            quality=quality,
            threads=threads,
        )
    )
    layout = Layout(data["layout"], data["report"]["file"], program)
    return Solution(layout, Report(data["report"], program, layout), data["end"], data["in_the_way"], data["warnings"])


def repair(
    program: Source,
    layout: Placed | None = None,
    *,
    constraint: str | None = None,
    lock: Sequence[str] = (),
    time: float | None = None,
) -> list[Repair]:
    """Ways to repair a layout, the best first: smallest moves, else a number relaxed, a preference given up.

    `constraint` is the id of the one that is to hold (as in reports); without it all that must hold is to. Objects and whole
    arrays named in `lock` stay where they are. An empty list means
    that nothing fails, or that no way was found, which does not prove that there is none.
    """
    program = _program(program)
    placed = _layout(program, layout)
    ways = json.loads(_native.repair(program._native, _pair(placed), constraint=constraint, lock=list(lock), time=time))
    return [
        Repair(
            way["how"],
            way["text"],
            way["cost"],
            way["moves"],
            way["edits"],
            Layout(way["layout"], placed.name, program if way["program"] is None else None),
            way["program"],
        )
        for way in ways
    ]


def formalize(request: str, *, literal: bool = False, tried: bool = True) -> Formalized:
    """Makes a program of a request in plain English, without a language model.

    `literal` adds nothing that the request does not say. `tried` lays the program out once, and gives up what no layout is
    found with.
    """
    data = json.loads(_native.formalize(request, literal=literal, tried=tried))
    return Formalized(
        compile(data["program"] or "\n"),
        data["understood"],
        data["clauses"],
        data["unused"],
        data["notes"],
        data["layout"],
    )


def sample(
    program: Source, number: int, *, seed: int = 0, first: int = 0, effort: int = 1, threads: int = 0
) -> list[Layout]:
    """Layouts drawn uniformly from all in which everything that must hold does, each of them verified.

    Those of the numbers from `first` on: the same number and seed give the same layout, however the work is split. A program
    with draws may have no layout for some of them; these are left out.
    """
    program = _program(program)
    lines = _native.sample(program._native, number, seed=seed, first=first, effort=effort, threads=threads)
    return [Layout(line, f"sample-{index:09}.layout.json", program) for index, line in lines]
