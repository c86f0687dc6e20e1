"""Every function of the module once, its errors, and what a notebook shows."""

import copy
import json
import pickle
import signal
import sys
import threading
from pathlib import Path

import scenelang as sl

try:
    import numpy
except ImportError:
    numpy = None

ROOM = """
region room;
room.scale <- vec3(4, 2.6, 3);
object desk; desk.category <- "desk";
object chair; chair.category <- "chair";
@req("one can work")
assert near(chair, desk, 0.3);
assert inside(desk, room);
prefer againstWall(desk, room) weight 2;
"""


def raises(kind, work):
    try:
        work()
    except kind as error:
        return error
    raise AssertionError(f"no {kind.__name__}")


def compiled():
    program = sl.compile(ROOM)
    assert program.objects == ["desk", "chair"] and program.regions == ["room"], program.objects
    kinds = [constraint["kind"] for constraint in program.constraints]
    assert kinds.count("assert") == 2 and kinds.count("prefer") == 1, kinds
    work = next(c for c in program.constraints if c["text"].startswith("near"))
    assert work["id"] == "program.scene:7:1" and work["requirements"] == ["one can work"], work
    assert program.name == "program.scene" and program.text == ROOM
    Path("room.scene").write_text(ROOM)
    assert sl.compile("room.scene").name == "room.scene"
    assert sl.compile(Path("room.scene")).constraints[0]["id"].startswith("room.scene:")
    again = pickle.loads(pickle.dumps(program))
    assert again.constraints == program.constraints and again.text == program.text
    assert "one can work" in program._repr_html_() and "<pre>" in program._repr_html_()


def refused():
    error = raises(sl.SceneError, lambda: sl.compile("object a; assert a.pos.x > b;"))
    assert isinstance(error, ValueError)
    assert error.diagnostics[0]["code"] == "E0201", error.diagnostics
    assert "[E0201] Error: `b` is not declared" in str(error) and "\x1b" not in str(error), str(error)
    other = pickle.loads(pickle.dumps(error))
    assert str(other) == str(error) and other.diagnostics == error.diagnostics
    assert "nowhere.scene" in str(raises(sl.SceneError, lambda: sl.compile("nowhere.scene")))
    proved = raises(sl.ContradictionError, lambda: sl.solve("object a; assert a.pos.x > 2; assert a.pos.x < 1;"))
    assert any(found["code"] == "E0401" for found in proved.diagnostics), proved.diagnostics
    raises(sl.SceneError, lambda: sl.margins(ROOM, [[[0.0] * 7] * 2]))  # there is no layout beside it
    raises(FileNotFoundError, lambda: sl.check(ROOM, "nowhere.layout.json"))


def solved():
    solution = sl.solve(ROOM, seed=3)
    assert solution.ok and solution.end == "solved", solution
    assert set(solution.layout.objects) == {"desk", "chair"}
    assert solution.layout.text == sl.solve(sl.compile(ROOM), seed=3, threads=1).layout.text
    report = sl.check(ROOM, solution.layout)
    assert report.ok and not report.violations and report.summary["assertions"]["total"] == 2
    assert report.data == solution.report.data
    for form in (solution.layout.text, solution.layout.to_dict()):
        assert sl.check(ROOM, form).constraints == report.constraints
    Path("kept.layout.json").write_text(solution.layout.text)
    assert sl.check(ROOM, "kept.layout.json").constraints == report.constraints
    assert sl.check(ROOM, sl.Layout.read("kept.layout.json")).data["file"] == "kept.layout.json"
    rows = report.rows()
    assert len(rows) == len(report.constraints) and set(rows[0]) >= {"id", "kind", "satisfied", "margin", "unit"}
    held = sl.solve(ROOM, seed=9, start=solution.layout, lock=["desk"]).layout
    assert held.objects["desk"]["pos"] == solution.layout.objects["desk"]["pos"]
    assert "desk" in raises(sl.SceneError, lambda: sl.solve(ROOM, start=solution.layout, lock=["dask"])).args[0]
    for shown in (report._repr_html_(), solution._repr_html_(), solution.layout._repr_html_()):
        assert "<svg" in shown and "near(chair, desk, 0.3)" in shown and "<?xml" not in shown
    return solution


def hostile_names_are_text():
    text = 'object a; assert a.pos.x > 1; @req("<script>alert(1)</script>") assert a.pos.y >= 0;'
    shown = sl.compile(text)._repr_html_() + sl.check(text)._repr_html_()
    assert "<script>" not in shown


def repaired(solution):
    bad = solution.layout.to_dict()
    bad["objects"]["chair"]["pos"][0] += 1.0
    report = sl.check(ROOM, bad)
    assert not report.ok and report.violations
    assert "fails" in report._repr_html_()
    ways = sl.repair(ROOM, bad)
    assert ways and ways[0].how == "move" and "chair" in ways[0].text, ways
    assert sl.check(ROOM, ways[0].layout).ok
    assert ways[0].program_text is None
    assert sl.repair(ROOM, solution.layout) == []
    numbers = [way for way in ways if way.program_text is not None]
    assert all(sl.check(way.program_text, way.layout).ok for way in numbers)
    failing = report.violations[0]["id"]
    assert sl.repair(ROOM, bad, constraint=failing)
    moved = {move["object"] for way in ways for move in way.moves}
    locked = sl.repair(ROOM, bad, lock=sorted(moved))
    assert not any(move["object"] in moved for way in locked for move in way.moves)
    raises(sl.SceneError, lambda: sl.repair(ROOM, bad, lock=["nothing"]))
    raises(sl.SceneError, lambda: sl.repair(ROOM, bad, constraint="program.scene:99:1"))


def formalized():
    made = sl.formalize("a study with a desk and a chair")
    assert made.understood and made.layout == "found" and not made.unused, made
    assert {"desk", "chair"} <= {name.split("[")[0] for name in made.program.objects}, made.program.objects
    nothing = sl.formalize("")
    assert not nothing.understood and nothing.layout == "untried"


def sampled():
    layouts = sl.sample(ROOM, 5, seed=2)
    assert len(layouts) == 5 and len({layout.text for layout in layouts}) == 5
    assert all(sl.check(ROOM, layout).ok for layout in layouts)
    assert sl.sample(ROOM, 2, seed=2, first=3, threads=1) == layouts[3:]
    raises(sl.ContradictionError, lambda: sl.sample("object a; assert a.pos.x > 2; assert a.pos.x < 1;", 1))


def evaluated(solution):
    evaluator = sl.Evaluator(ROOM, solution.layout)
    assert evaluator.objects == ["desk", "chair"]
    poses = evaluator.poses()
    one = evaluator.margins(poses)
    assert len(one) == len(evaluator.columns)
    data = poses.tolist()
    many = evaluator.margins([data, data])
    assert list(many.shape) == [2, len(one)] and many.tolist() == [one.tolist()] * 2
    assert all(map(all, evaluator.holds([data, data]).tolist()))
    # The chair goes away: it fails by what it is farther.
    away = copy.deepcopy(data)
    away[1][0] += 50.0
    near = [column["text"].startswith("near") for column in evaluator.columns].index(True)
    assert evaluator.margins([away]).tolist()[0][near] < -45.0
    assert evaluator.holds(away).tolist()[near] is False
    # Blown up: nothing is known of it, and the others are.
    broken = copy.deepcopy(data)
    broken[0][2] = float("nan")
    zeros = copy.deepcopy(data)
    zeros[0][3:] = [0.0] * 4
    got = evaluator.margins([broken, zeros, data]).tolist()
    assert all(value != value for row in got[:2] for value in row) and got[2] == one.tolist()
    assert not any(evaluator.holds([broken]).tolist()[0])
    # Only the chair moves.
    chair = sl.Evaluator(ROOM, solution.layout, objects=["chair"])
    assert chair.margins([data[1:], away[1:]]).tolist() == evaluator.margins([data, away]).tolist()
    raises(ValueError, lambda: sl.Evaluator(ROOM, solution.layout, objects=["sofa"]))
    # Other conventions say the same.
    for order, frame in (("xyzw", "scene"), ("wxyz", "z-up"), ("xyzw", "z-up")):
        other = evaluator.poses(order=order, frame=frame)
        assert evaluator.margins(other, order=order, frame=frame).tolist() == one.tolist(), (order, frame)
    euler = evaluator.poses(euler=True)
    assert evaluator.margins(euler).tolist() == one.tolist()
    for wrong in (lambda: evaluator.margins(poses, order="zyxw"), lambda: evaluator.margins(poses, frame="y-up"),
                  lambda: evaluator.margins(euler, frame="z-up"), lambda: evaluator.margins([data[0]]),
                  lambda: evaluator.margins([[row[:5] for row in data]]), lambda: evaluator.margins(1.0),
                  lambda: evaluator.layout_of([data])):
        raises(ValueError, wrong)
    again = pickle.loads(pickle.dumps(chair))
    assert again.objects == ["chair"] and again.margins([data[1:]]).tolist() == chair.margins([data[1:]]).tolist()
    assert sl.margins(ROOM, [data], solution.layout).tolist() == [one.tolist()]
    assert sl.holds(ROOM, [data], solution.layout).tolist() == evaluator.holds([data]).tolist()
    if numpy is not None:
        batch = numpy.stack([poses, poses])
        assert evaluator.margins(batch).dtype == numpy.float64 and evaluator.holds(batch).dtype == numpy.bool_
        assert evaluator.margins(batch[:0]).shape == (0, len(one))
        strided = numpy.stack([batch, batch], axis=-1)[..., 0]
        assert (evaluator.margins(strided) == many).all()
        assert (evaluator.margins(batch.astype(numpy.float32)) - many < 1e-4).all()


def frames_are_those_of_the_exports(solution):
    """A quarter turn to the left as seen from above: about z where z is up, and the other way round in the scene's frame."""
    evaluator = sl.Evaluator(ROOM, solution.layout, objects=["chair"])
    half = 0.5**0.5
    turned = evaluator.layout_of([[1.0, 2.0, 0.0, half, 0.0, 0.0, half]], frame="z-up").objects["chair"]
    assert turned["pos"] == [1.0, 0.0, 2.0] and turned["rot"] == [0, 270, 0], turned
    turned = evaluator.layout_of([[1.0, 0.0, 2.0, half, 0.0, half, 0.0]]).objects["chair"]
    assert turned["pos"] == [1.0, 0.0, 2.0] and turned["rot"] == [0, 90, 0], turned


def interrupted():
    """Ctrl-C ends what takes long, and other threads go on meanwhile."""
    if sys.platform == "win32":
        return
    ticks = []
    threading.Timer(0.5, lambda: (ticks.append(1), signal.raise_signal(signal.SIGINT))).start()
    raises(KeyboardInterrupt, lambda: sl.sample(ROOM, 1_000_000_000))
    assert ticks == [1]


compiled()
refused()
solution = solved()
hostile_names_are_text()
repaired(solution)
formalized()
sampled()
evaluated(solution)
frames_are_those_of_the_exports(solution)
interrupted()
json.dumps(solution.report.data)
