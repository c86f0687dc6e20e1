"""Problems without a solution, and the one minimal set of statements that is to blame.

Eight alike things stand in two rows; no statement of the rest speaks of them. A few statements about some of them are
planted that cannot hold together. Since the eight may change places, each of the planted statements is missing from some
layout that satisfies all others: so every minimal contradictory set has all of them, and there is only one.
"""

import itertools

import kinds
from families import boxes_by_quarters, zones
from geometry import Box
from hidden import MEAN, Hidden, rectangle, region, sides
from sampling import FLAT, sample

PLANTS = ("order-cycle", "distance-triangle", "align-gap", "crowded-zone")
EDGE, APART = 0.5, 0.12  # of the alike things: their edge and what is between them (metres)


def contradictory(rng, n, plant):
    step, height = EDGE + APART, round(rng.uniform(0.5, 1.2), 2)
    w, d = sides(rng, (n * MEAN + 8 * step * step) / 0.35)
    w, d = max(w, 5 * step), max(d, 4.5 * step)
    hidden = Hidden(rng, [region("room", rectangle(0, 0, w, d))])
    names = boxes_by_quarters(hidden, (0, 0, w, d - 2.2 * step), n, 0.45)
    zones(hidden, max(2, n // 8))
    sample(hidden, 3 * n, FLAT, names)
    alike = [f"twin{i}" for i in range(8)]
    x, z = rng.uniform(0.4, w - 4 * step), d - 1.7 * step
    for i, name in enumerate(alike):
        hidden.add(name, (EDGE, height, EDGE), (x + i % 4 * step, 0, z + i // 4 * step), 0)
        hidden.floor(name)
        hidden.state("yaw", given=True, a=name, yaws=[0])
    a, b, c, e = rng.sample(alike, 4)
    if plant == "order-cycle":
        ring = [a, b, c, e][: rng.choice((3, 4))]
        planted = [{"kind": "order", "a": p, "b": q, "axis": "x", "by": 0.1} for p, q in zip(ring, ring[1:] + ring[:1])]
    elif plant == "distance-triangle":
        near = round(1.2 * step, 2)
        planted = [{"kind": "distance", "a": p, "b": q, "op": "<=", "value": near} for p, q in ((a, b), (b, c))]
        planted.append({"kind": "distance", "a": a, "b": c, "op": ">=", "value": round(2 * near + 0.2, 2)})
    elif plant == "align-gap":
        planted = [{"kind": "inline", "a": p, "b": q, "axis": "z", "value": 0.05} for p, q in ((a, b), (b, c))]
        planted.append({"kind": "order", "a": a, "b": c, "axis": "z", "by": 0.4})
    else:
        # Room for two of the three: too narrow for three side by side, too shallow for one behind another.
        spare = rng.choice((0.04, 0.1))
        zone = region("tight", rectangle(x - EDGE / 2 - spare, z - EDGE / 2 - spare, x + step + EDGE / 2 + spare, z + EDGE / 2 + spare), zone=True)
        hidden.facts["regions"].append(zone)
        hidden.place.regions["tight"] = zone
        planted = [{"kind": "inside", "a": p, "region": "tight"} for p in (a, b, c)]
    stated = [hidden.state(p.pop("kind"), **p) for p in planted]
    hidden.facts["contradiction"] = [s["id"] for s in stated]
    hidden.facts["certificates"] = {s["id"]: certificate(hidden, alike, stated, s) for s in stated}
    # In an order that tells nothing.
    rng.shuffle(hidden.facts["constraints"])
    return hidden


def certificate(hidden, alike, planted, without):
    """Which of the alike things stands where in a layout that satisfies all but one of the planted statements."""
    poses = [hidden.boxes[i].pos for i in alike]
    kept = [p for p in planted if p is not without]
    members = sorted({m for p in planted for m in (p["a"], p.get("b")) if m})
    for places in itertools.permutations(range(len(alike)), len(members)):
        boxes = {m: Box(hidden.boxes[m].size, poses[k], 0) for m, k in zip(members, places)}
        place = kinds.Place(hidden.facts, boxes)
        if all(kinds.margin(p, place) >= -1e-9 for p in kept):
            rest = [k for k in range(len(alike)) if k not in places]
            others = [m for m in alike if m not in members]
            return dict(sorted({**dict(zip(members, places)), **dict(zip(others, rest))}.items()))
    raise AssertionError(f"no certificate without {without}")


def certified(hidden, order):
    """The hidden layout with the alike things in another order."""
    moved = {name: hidden.boxes[f"twin{place}"].pos for name, place in order.items()}
    boxes = {i: Box(b.size, moved.get(i, b.pos), b.yaw) for i, b in hidden.boxes.items()}
    return boxes
