"""Scenic: each thing uniform in the room and over its yaws, each constraint a requirement; rejection sampling until the
time is over. Scenic samples from a distribution, and is no solver; this says how far that carries.

Scenic's own frame has z up and headings counter-clockwise; things that stand on others are left out of its 2D mode, so
only problems without them can be tried.
"""

import math
import os
import random
import signal
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from quarter import run

LIVE = {}


def holds(index, *things):
    """Whether a stated constraint holds of sampled things; called by the Scenic program."""
    import kinds
    from geometry import Box

    problem = LIVE["problem"]
    c = problem.stated[index]
    names = [c[k] for k in ("a", "b") if k in c]
    boxes = {}
    for name, thing in zip(names, things):
        pos = (thing.position.x, 0.0, thing.position.y)
        boxes[name] = Box(problem.size[name], pos, -math.degrees(thing.heading))
    return kinds.margin(c, kinds.Place(problem.facts, boxes)) >= 0


def program(problem):
    x0, z0, x1, z1 = problem.room
    lines = ["from scenic_run import holds", f"room = RectangularRegion(({(x0 + x1) / 2}, {(z0 + z1) / 2}), 0, {x1 - x0}, {z1 - z0})", "workspace = Workspace(room)"]
    for i, (w, h, d) in problem.size.items():
        yaws = ", ".join(f"{-y} deg" for y in problem.yaws[i])
        lines.append(f"{i} = new Object in room, with width {w}, with length {d}, with height {h}, with requireVisible False, facing Uniform({yaws})")
    for k, c in enumerate(problem.stated):
        lines.append(f"require holds({k}, {', '.join(c[m] for m in ('a', 'b') if m in c)})")
    return "\n".join(lines) + "\n"


class Over(Exception):
    pass


def over(*_):
    raise Over


def solve(problem, limit, core):
    import scenic
    from scenic.core.distributions import RejectionException

    if core or any(problem.bottom.values()):
        return "cannot be said", None
    sys.modules["scenic_run"] = sys.modules["__main__"]
    LIVE["problem"] = problem
    random.seed(0)
    signal.signal(signal.SIGALRM, over)
    signal.setitimer(signal.ITIMER_REAL, limit)
    try:
        scenario = scenic.scenarioFromString(program(problem), mode2D=True)
        while True:
            try:
                scene, _ = scenario.generate(maxIterations=500, verbosity=0)
                break
            except RejectionException:
                continue
    except Over:
        return "timeout", None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    things = zip(problem.size, scene.objects)
    return "solved", {i: (t.position.x, t.position.y, round(-math.degrees(t.heading) / 90) * 90 % 360) for i, t in things}


if __name__ == "__main__":
    run("Scenic 3.1.1", solve)
