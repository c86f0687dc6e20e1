"""Constraints that a hidden layout satisfies, drawn at random in given proportions."""

import json
import math

import kinds
from geometry import dot, minus
from hidden import bounds, rectangle, region

# By how much a sampled constraint holds at least in the hidden layout, where that is not its own 1 cm.
SLACK = {"aligned": 0.004, "inline": 0.0, "parallel": 0.3, "turned": 1.0, "heading": 0.5, "against_wall": 0.003, "in_corner": 0.003, "reachable": 0.0}
DIRECTIONS = ("left_of", "right_of", "in_front_of", "behind")

# How often each kind is tried.
FLAT = {"order": 18, "bound": 6, "distance": 18, "inside": 10, "direction": 25, "aligned": 7, "against_wall": 8, "facing": 8}
TURNED = {**FLAT, "gap": 14, "heading": 10, "turned": 8, "parallel": 4, "between": 4, "beside": 5, "in_corner": 4}
# Zones are regions, too, and `clear` asks for room in the region that holds a thing best; so it goes without zones.
UNZONED = {**{k: v for k, v in TURNED.items() if k != "inside"}, "clear": 8}


def zones(hidden, count):
    """Rectangular zones, each around one thing."""
    rng, rooms = hidden.rng, hidden.place.rooms()
    names = [i for i, b in hidden.boxes.items() if b.bottom < 0.01 and i not in hidden.place.doors]
    for k in range(count):
        box = hidden.boxes[rng.choice(names)]
        x0, z0, x1, z1 = bounds(box.corners)
        room = next(r for r in rooms if kinds.within(r["polygon"], box.corners) > -1e-6)
        # In a room that is no rectangle a zone around a thing may not fit; then there is none.
        rect = bounds(room["polygon"])
        grown = max(rect[0], x0 - rng.uniform(0.1, 1.2)), max(rect[1], z0 - rng.uniform(0.1, 1.2))
        grown += min(rect[2], x1 + rng.uniform(0.1, 1.2)), min(rect[3], z1 + rng.uniform(0.1, 1.2))
        zone = region(f"zone{k}", rectangle(*grown), zone=True)
        if kinds.within(room["polygon"], [tuple(p) for p in zone["polygon"]]) > -1e-6:
            hidden.facts["regions"].append(zone)
            hidden.place.regions[zone["id"]] = zone


def candidate(hidden, kind, a, b):
    """One constraint of a kind on a (and b) that is likely to hold, or None."""
    rng, A, B = hidden.rng, hidden.boxes[a], hidden.boxes[b]
    axis = rng.choice("xz")
    i = "xyz".index(axis)
    if kind == "order":
        off = B.pos[i] - A.pos[i]
        low, high = (a, b) if off > 0 else (b, a)
        return {"kind": kind, "a": low, "b": high, "axis": axis, "by": round(abs(off) * rng.uniform(0.2, 0.9), 2)}
    if kind == "bound":
        up, slack = rng.random() < 0.5, rng.uniform(0.1, 1.0)
        return {"kind": kind, "a": a, "axis": axis, "op": "<=" if up else ">=", "value": round(A.pos[i] + (slack if up else -slack), 2)}
    if kind in ("distance", "gap"):
        found = math.dist(A.middle, B.middle) if kind == "distance" else kinds.gap(A, B)
        near, slack = rng.random() < 0.6, rng.uniform(0.05, 0.4)
        value = found * (1 + slack) + 0.02 if near else found * (1 - slack) - 0.02
        return {"kind": kind, "a": a, "b": b, "op": "<=" if near else ">=", "value": round(value, 2)} if value > 0 else None
    if kind == "inside":
        names = [r["id"] for r in hidden.facts["regions"] if r.get("zone")]
        return {"kind": kind, "a": a, "region": rng.choice(names)} if names else None
    if kind == "direction":
        off = minus(A.at, B.at)
        return {"kind": max(DIRECTIONS, key=lambda k: dot(off, way(B, k))), "a": a, "b": b}
    if kind == "heading":
        value = rng.choice((5, 8, 12, 20, 30))
        return {"kind": kind, "a": a, "yaw": round(A.yaw + rng.uniform(-0.6, 0.6) * value) % 360, "value": value}
    if kind == "turned":
        found, more = kinds.between_angles(A.yaw, B.yaw), rng.random() < 0.4
        value = math.floor(found - rng.uniform(2, 20)) if more else math.ceil(found + rng.uniform(2, 20))
        return {"kind": kind, "a": a, "b": b, "op": ">=" if more else "<=", "value": value} if 5 < value < 175 else None
    if kind == "between":
        others = [n for n, c in hidden.boxes.items() if n not in (a, b) and dot(minus(c.at, A.at), minus(B.at, A.at)) < 0]
        return {"kind": kind, "a": a, "b": b, "c": rng.choice(others)} if others else None
    if kind in ("against_wall", "in_corner"):
        return {"kind": kind, "a": a, "region": rng.choice(hidden.place.rooms())["id"]}
    if kind == "clear":
        return {"kind": kind, "a": a, "side": "front", "value": rng.choice((0.3, 0.4, 0.5, 0.6))}
    return {"kind": kind, "a": a, "b": b}


def way(box, direction):
    """The direction as a vector of the plan."""
    axis = box.right if direction in ("left_of", "right_of") else box.front
    return axis if direction in ("right_of", "in_front_of") else (-axis[0], -axis[1])


def sample(hidden, total, menu, pool=None, weight=None, truth=None):
    """States `total` constraints in all on the things of `pool`, each thing getting one before any gets two.

    With `weight`, a list to draw from, they are preferences. `truth` is the layout in which they hold, if that is not
    the hidden one.
    """
    rng = hidden.rng
    pool = list(pool or hidden.boxes)
    world = hidden if truth is None else truth
    seen = {key(c) for c in hidden.facts["constraints"]}
    waiting, tries, stated = list(pool), 0, 0
    rng.shuffle(waiting)
    while stated < total and tries < 300 * total:
        tries += 1
        a = waiting[-1] if waiting else rng.choice(pool)
        others = [n for n in pool if n != a]
        if not others:
            return
        if rng.random() < 0.5:
            others.sort(key=lambda n: math.dist(world.boxes[n].at, world.boxes[a].at))
            others = others[:5]
        kind = rng.choices(list(menu), list(menu.values()))[0]
        found = candidate(world, kind, a, rng.choice(others))
        if found is None or key(found) in seen:
            continue
        if kinds.margin(found, world.place) < SLACK.get(found["kind"], 0.01):
            continue
        seen.add(key(found))
        if weight:
            found["weight"] = rng.choice(weight)
        hidden.state(found.pop("kind"), **found)
        stated += 1
        if waiting:
            waiting.pop()


def key(constraint):
    return json.dumps({k: v for k, v in constraint.items() if k not in ("id", "value", "by", "weight")}, sort_keys=True)
