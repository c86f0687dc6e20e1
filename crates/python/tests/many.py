"""A room of twenty objects in many environments: the margins do not depend on how the work is split. How long it takes is
printed, not judged.

    many.py [ENVIRONMENTS]
"""

import random
import sys
import time
from array import array

import scenelang as sl

SCENE = """
region room;
room.scale <- vec3(9, 2.7, 8);
object desk[5]; desk.category <- "desk";
object chair[5]; chair.category <- "office chair";
object cabinet[3]; cabinet.category <- "cabinet";
object plant[2]; plant.category <- "plant";
object table; table.category <- "table";
object sofa; sofa.category <- "sofa";
object lamp; lamp.category <- "floor lamp";
object shelf; shelf.category <- "bookshelf";
object door; door.category <- "door";

assert forall i in 0..5: near(chair[i], desk[i], 0.4) and inFrontOf(chair[i], desk[i]) and facing(chair[i], desk[i]);
assert forall d in desk: inside(d, room) and clear(d, front, 0.7);
assert forall i in 0..5: forall j in 0..5: i < j implies gap(desk[i], desk[j]) >= 0.3;
assert forall c in cabinet: againstWall(c, room);
assert forall p in plant: inCorner(p, room);
assert gap(sofa, table) >= 0.3 and gap(sofa, table) <= 0.8;
assert near(lamp, sofa, 1);
assert againstWall(shelf, room);
assert connects(door, room);
assert count(d in desk: visible(d, shelf)) >= 1;
prefer distance(sofa, door) >= 3;
prefer forall d in desk: againstWall(d, room);
"""

environments = int(sys.argv[1]) if len(sys.argv) > 1 else 200
program = sl.compile(SCENE)
assert len(program.objects) == 20, program.objects
layout = sl.solve(program).layout
evaluator = sl.Evaluator(program, layout)
home = evaluator.poses().tolist()
dice = random.Random(7)
flat = array("d")
for _ in range(environments):
    for x, y, z, *turn in home:
        flat.extend([x + dice.gauss(0, 0.3), y, z + dice.gauss(0, 0.3), *turn])
poses = memoryview(flat).cast("B").cast("d", (environments, 20, 7))


def timed(threads):
    begun = time.perf_counter()
    margins = evaluator.margins(poses, threads=threads)
    return margins, time.perf_counter() - begun


alone, slow = timed(1)
both, fast = timed(2)
assert tuple(both.shape) == (environments, len(evaluator.columns))
assert bytes(memoryview(alone)) == bytes(memoryview(both))
print(f"{environments} environments, {len(evaluator.columns)} constraints: {slow:.3f} s on one thread, {fast:.3f} s on two")
