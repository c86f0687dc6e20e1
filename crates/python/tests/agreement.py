"""What the module says of a layout is what the command line says, to the last bit: reports, layouts and margins, on every
example and on layouts of it that are drawn, shaken, tilted and thrown about.

    agreement.py BINARY EXAMPLES [NAME...]

Names choose among the examples.
"""

import json
import math
import random
import struct
import subprocess
import sys
import time
from pathlib import Path

import scenelang as sl

BINARY, EXAMPLES, CHOSEN = sys.argv[1], Path(sys.argv[2]), sys.argv[3:]
# Solving takes long, and is the same code for all.
SOLVED = ("bedroom", "meeting-room")


def command(*args):
    done = subprocess.run([BINARY, *args], capture_output=True, text=True, encoding="utf-8")
    assert done.returncode in (0, 1), (args, done.returncode, done.stderr)
    return done.stdout


def bits(value):
    return struct.pack("<d", value)


def same(row, margin, holds, what):
    """A row of a report and what an array says of it."""
    if row["satisfied"] is None:
        assert math.isnan(margin) and not holds, what
    elif row["margin"] is None:
        assert margin == (math.inf if row["satisfied"] else -math.inf) and holds is row["satisfied"], what
    else:
        assert bits(row["margin"]) == bits(margin) and holds is row["satisfied"], (what, row["margin"], margin)


def quaternion(dice):
    """An orientation: upright as often as not."""
    if dice.random() < 0.5:
        half = math.radians(dice.uniform(0, 360)) / 2
        return [math.cos(half), 0.0, math.sin(half), 0.0]
    return [dice.gauss(0, 1) for _ in range(4)]


def moved(poses, dice, how):
    out = []
    for x, y, z, *turn in poses:
        if how == "shaken":
            out.append([x + dice.gauss(0, 0.05), y, z + dice.gauss(0, 0.05), *turn])
        else:
            out.append([dice.uniform(-5, 5), dice.uniform(0, 2), dice.uniform(-5, 5), *quaternion(dice)])
    return out


def judge(name, base, environments, layouts):
    """Margins of environments, and what the command line says of their layout files; how many were compared."""
    files = [f"{name}-{index}.layout.json" for index in range(len(layouts))]
    for file, layout in zip(files, layouts):
        Path(file).write_text(layout.text, encoding="utf-8")
    reports = [json.loads(line) for line in command("check", "--format", "json", *files).splitlines()]
    assert [report["file"] for report in reports] == files
    ids = [column["id"] for column in base.columns]
    margins, holds = base.margins(environments).tolist(), base.holds(environments).tolist()
    for file, layout, report, own, truths in zip(files, layouts, reports, margins, holds):
        rows = [row for row in report["constraints"] if row["rule"] is None]
        assert [row["id"] for row in rows] == ids, file
        for row, margin, truth in zip(rows, own, truths):
            same(row, margin, truth, f"{file}: {row['id']}")
    # What such a file says of its poses are other numbers, which mean the same.
    last = sl.Evaluator(base.program, layouts[-1])
    assert list(map(bits, last.margins(last.poses(euler=True)).tolist())) == list(map(bits, margins[-1])), name
    return len(ids) * len(files)


compared = 0
for scene in sorted(EXAMPLES.glob("*.scene")):
    name = scene.stem
    if CHOSEN and name not in CHOSEN:
        continue
    dice = random.Random(name)
    Path(scene.name).write_text(scene.read_text(encoding="utf-8"), encoding="utf-8")
    program = sl.compile(scene.name)
    solution = sl.solve(program, seed=1)
    layout = sl.Layout(solution.layout.text, f"{name}.layout.json", program)
    Path(layout.name).write_text(layout.text, encoding="utf-8")
    if name in SOLVED:
        command("solve", scene.name, "-o", f"again-{name}.layout.json", "--seed", "1")
        theirs = sl.Layout.read(f"again-{name}.layout.json").to_dict()
        theirs.pop("written", None)  # the mark of a file of ours
        assert theirs == layout.to_dict(), f"{name}: another layout"
    # The reports, whole.
    said = command("check", "--format", "json", f"{name}.layout.json")
    assert json.loads(said) == sl.check(program, layout).data, f"{name}: another report"
    assert json.loads(command("check", "--format", "json", scene.name)) == sl.check(program).data, name

    base = sl.Evaluator(program, layout)
    poses = base.poses().tolist()
    # A layout comes back from its quaternions, but for whole turns.
    back = base.layout_of(poses).objects
    for object, placed in layout.objects.items():
        assert back[object]["pos"] == placed["pos"], (name, object)
        assert back[object]["rot"] == [angle % 360 for angle in placed["rot"]], (name, object, placed["rot"])
    assert base.margins(poses).tolist() == base.margins(base.poses(euler=True)).tolist(), name
    environments = [poses] + [moved(poses, dice, how) for how in ("shaken", "thrown")]
    layouts = [base.layout_of(environment) for environment in environments]
    compared += judge(name, base, environments, layouts)
    print(f"{name}: {time.process_time():.1f} s", flush=True)
assert compared > (100 if CHOSEN else 1_000), compared
print(f"{compared} margins are the same")
