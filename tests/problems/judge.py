#!/usr/bin/env python3
"""An independent judge: judge.py FACTS.json LAYOUT.json… prints a verdict per layout, one JSON object a line.

It shares no code with the solver or the verifier. What must hold: every object is there, upright, of its size; nothing
collides; everything is in a room and rests on something; and every stated constraint. Lengths may be off by 2 mm, angles
by 0.2 degrees. Exit 0: all valid; 1: some are not; 2: something could not be read.
"""

import json
import math
import sys

import kinds
from geometry import Box, apart, hull, overlap, within, depth, holds, to_segment, edges

LENGTH, ANGLE = 0.002, 0.2
REST = 0.005  # heights of what rests on each other


def boxes_of(facts, layout):
    """The boxes of a layout, and what is wrong with objects by themselves."""
    boxes, wrong = {}, []
    # A door, or an exit, consists of a frame and a leaf, which fill its box. Nothing is said of gaps to it.
    doors = {c["a"] for c in facts["constraints"] if c["kind"] == "connects"}
    doors |= {thing["id"] for thing in facts["objects"] if thing["id"].startswith(("entry", "exit"))}
    for thing in facts["objects"]:
        name = thing["id"]
        found = layout.get("objects", {}).get(name)
        if found is None:
            wrong.append(f"{name} is missing")
            continue
        pos, scale, rot = found["pos"], found["scale"], found.get("rot", [0, 0, 0])
        if not all(isinstance(v, int | float) and math.isfinite(v) for v in (*pos, *scale, *rot)):
            wrong.append(f"{name} has no place")
            continue
        if any(abs((r + 180) % 360 - 180) > ANGLE for r in (rot[0], rot[2])):
            wrong.append(f"{name} is tilted")
        if any(abs(a - b) > 1e-3 for a, b in zip(scale, thing["size"])):
            wrong.append(f"{name} has another size")
        parts = found.get("asset", {}).get("parts", [])
        if name not in doors and parts and not (len(parts) == 1 and parts[0]["shape"] == "box" and math.dist(parts[0]["size"], scale) < 1e-3):
            wrong.append(f"{name} is no plain box")
        boxes[name] = Box(thing["size"], pos, rot[1])
    return boxes, wrong


def regions_wrong(facts, layout):
    """Regions are given: the layout must say the same of them."""
    wrong = []
    for region in facts["regions"]:
        found = layout.get("regions", {}).get(region["id"])
        if found is None:
            wrong.append(f"{region['id']} is missing")
            continue
        if found.get("vertices"):
            corners = found["vertices"]
        else:
            (x, _, z), (w, _, d) = found["pos"], found["scale"]
            corners = [(x + s * w / 2, z + t * d / 2) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        off = max(min(math.dist(a, b) for b in corners) for a in region["polygon"])
        if off > LENGTH or len(corners) != len(region["polygon"]) or abs(found["pos"][1] - region["floor"]) > LENGTH:
            wrong.append(f"{region['id']} is another room")
    return wrong


def supported(name, boxes, place):
    """Whether an object rests on a floor or on others, and its middle over where it does."""
    box, contacts = boxes[name], []
    for room in place.rooms():
        if abs(box.bottom - room["floor"]) <= REST + LENGTH and holds(room["polygon"], box.at):
            contacts += box.corners
    for other, carrier in boxes.items():
        if other != name and abs(box.bottom - carrier.top) <= REST + LENGTH:
            contacts += overlap(box.corners, carrier.corners)
    if not contacts:
        return False
    base = hull([tuple(p) for p in contacts])
    if len(base) < 3:
        return min(to_segment(box.at, a, b) for a, b in edges(base)) <= LENGTH
    return depth(base, box.at) >= -LENGTH


def physical(facts, boxes, place):
    """What breaks the rules that every scene has."""
    wrong, names = [], list(boxes)
    for i, a in enumerate(names):
        for b in names[:i]:
            p, q = boxes[a], boxes[b]
            if math.dist(p.at, q.at) < p.radius + q.radius and max(p.bottom - q.top, q.bottom - p.top) < -LENGTH:
                if apart(p.corners, q.corners) < -LENGTH:
                    wrong.append(f"{b} and {a} collide")
    for name, box in boxes.items():
        if name in place.doors:
            continue
        rooms = place.rooms()
        held = any(
            within(r["polygon"], box.corners) >= -LENGTH and r["floor"] - LENGTH <= box.bottom and box.top <= r["floor"] + r["height"] + LENGTH
            for r in rooms
        )
        if not held:
            wrong.append(f"{name} is in no room")
        if not supported(name, boxes, place):
            wrong.append(f"{name} rests on nothing")
    return wrong


def judge(facts, layout):
    """The verdict on one layout."""
    boxes, wrong = boxes_of(facts, layout)
    wrong += regions_wrong(facts, layout)
    place = kinds.Place(facts, boxes)
    margins, broken, preferences = {}, [], [0, 0]
    for constraint in facts["constraints"]:
        slack = ANGLE if constraint["kind"] in kinds.DEGREES else LENGTH
        try:
            found = kinds.margin(constraint, place)
        except KeyError:
            found = -math.inf  # an object is missing
        held = found >= -slack
        margins[constraint["id"]] = round(found, 5) if math.isfinite(found) else None
        if constraint.get("weight"):
            preferences[0] += constraint["weight"] if held else 0
            preferences[1] += constraint["weight"]
        elif not held:
            broken.append(constraint["id"])
    complete = len(boxes) == len(facts["objects"])
    wrong += physical(facts, boxes, place) if complete else []
    hard = [c for c in facts["constraints"] if not c.get("weight")]
    return {
        "problem": facts["id"],
        "valid": not wrong and not broken,
        "constraints": len(hard),
        "satisfied": len(hard) - len(broken),
        "broken": broken,
        "wrong": wrong,
        "preferences": {"held": preferences[0], "of": preferences[1]},
        "margins": margins,
    }


def main():
    worst = 0
    try:
        facts = json.load(open(sys.argv[1], encoding="utf-8"))
        for name in sys.argv[2:]:
            verdict = judge(facts, json.load(open(name, encoding="utf-8")))
            print(json.dumps({"layout": name, **verdict}))
            worst = max(worst, 0 if verdict["valid"] else 1)
    except (IndexError, OSError, ValueError, KeyError, TypeError) as error:
        print(f"cannot be judged: {type(error).__name__}: {error}", file=sys.stderr)
        worst = 2
    sys.exit(worst)


if __name__ == "__main__":
    main()
