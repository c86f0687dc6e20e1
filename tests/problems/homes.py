"""Families of homes: kitchens, rooms in the shape of an L, flats."""

import math

from families import around_table
from furnished import EVERY, Frame, along_walls, before, door, in_row, in_wall, packer_of, stand, ways
from geometry import edges, holds, minus
from hidden import FREE, HEIGHT, MEAN, Hidden, bounds, rectangle, region, sides
from kinds import WALL
from sampling import sample

OPEN = {"bound": 5, "distance": 14, "gap": 10, "direction": 14, "order": 10, "facing": 6, "between": 3}
ENTRY = (0.9, 2.0, 0.05)  # of a thing at a wall that stands for the way in


def entry(hidden, packer, rect, side, share):
    """A door leaf against a wall, with free floor before it."""
    at, yaw = in_wall(rect, side, share)
    spot = Frame(at, yaw).point(0, WALL + ENTRY[2] / 2 + FREE + 0.003)
    stand(hidden, packer, "entry", ENTRY, spot, yaw)
    hidden.state("against_wall", a="entry", region="room")
    packer.keep.append(before(spot, yaw, 1.0, 0.9))


def tables(hidden, packer, rect, count):
    """Tables with seats at their long sides, wherever they fit with a way around them."""
    rng, made = hidden.rng, []
    x0, z0, x1, z1 = rect
    while count > 2:
        seats = min(count - 1, rng.choice((4, 4, 6)))
        w, d, seat = rng.choice((1.2, 1.4)), 0.8, 0.42
        for _ in range(600):
            at, yaw = (rng.uniform(x0, x1), rng.uniform(z0, z1)), rng.choice((0, 90))
            frame = Frame(at, yaw)
            if packer.fits(-1, w + 2.2, d + 2.3, at, yaw):
                break
        else:
            break
        name, set_ = f"hub{len(made)}", f"side{len(made)}"
        stand(hidden, packer, name, (w, 0.75, d), at, yaw)
        ring = []
        for k, (sw, sd, spot, turn) in enumerate(around_table(at, w, d, yaw, seat, seats, rng)):
            ring.append(f"{set_}[{k}]")
            stand(hidden, packer, ring[-1], (sw, 0.85, sd), spot, turn, array=set_)
        hidden.state("around", a=ring, b=name, set=set_, value=0.2)
        for chair in ring:
            hidden.state("facing", a=chair, b=name)
        packer.keep.append(frame.rectangle(0, 0, w + 2.2, d + 2.3))
        made.append(name)
        count -= seats + 1
    return made


def kitchen(rng, n, paths):
    """Counters and tall units along two walls, islands before them, tables with chairs."""
    hubs = max(1, round((n - 6) / 14))
    islands = max(1, n // 16)
    seated = 3 if n < 14 else 5 * hubs
    units = n - 1 - islands - seated
    w, d = rng.choice((0.5, 0.6)), 0.6
    back = max(3, round(units * rng.uniform(0.5, 0.65)))
    side = units - back
    size = lambda i, of: 0.6 if i >= of - max(1, of // 4) else w
    wide = max(back * 0.62 + 1.2, 4.4)
    long = side * 0.62 + 1.0
    deep = max(long, 3.2 + 3.4 * math.ceil(hubs / max(1, math.floor(wide / 3.8))))
    wide, deep = round(wide, 2), round(deep, 2)
    hidden = Hidden(rng, [region("room", rectangle(0, 0, wide, deep))])
    rect, packer = (0, 0, wide, deep), packer_of(hidden)
    runs = []
    for name, count, yaw, first in (("run", back, 0, 0.75), ("wing", side, 90, 0.75)):
        row, u = [], first
        for i in range(count):
            broad = size(i, count)
            tall = i >= count - max(1, count // 4)
            here = d / 2 + FREE + 0.004
            at = (u + broad / 2, here) if yaw == 0 else (here, u + broad / 2)
            # The first of the wing stands beside the end of the other run, not in its corner.
            thing = f"{name}Tall{i}" if tall else f"{name}[{i}]"
            stand(hidden, packer, thing, (broad, 2.1 if tall else 0.9, d), at, yaw, array=None if tall else name)
            hidden.state("against_wall", a=thing, region="room")
            row.append(thing)
            u += broad + 0.015
        in_row(hidden, row if yaw == 0 else row[::-1], near=0.05)
        runs.append(row)
    # Islands in a line before the longer run.
    u, names = 2.0, []
    for k in range(islands):
        broad, thick = rng.choice((1.2, 1.5, 1.8)), rng.choice((0.7, 0.9))
        at = (u + broad / 2, 0.65 + 1.15 + thick / 2)
        if at[0] + broad / 2 > wide - 0.6:
            break
        name = f"isle{k}"
        stand(hidden, packer, name, (broad, 0.9, thick), at, rng.choice((0, 180)))
        packer.keep.append(Frame(at, 0).rectangle(0, 0, broad + 1.8, thick + 2.1))
        names.append(name)
        u += broad + 1.0
    entry(hidden, packer, rect, 2, rng.uniform(0.1, 0.9))
    packer.keep += [Frame((wide / 2, 0.65), 0).rectangle(0, 0.5, wide, 1.0), Frame((0.65, deep / 2), 0).rectangle(0.5, 0, 1.0, deep)]
    for name in names:
        hidden.state("clear", a=name, side="front", value=1.0)
        hidden.state("clear", a=name, side="behind", value=0.9)
        hidden.state("parallel", a=name, b=runs[0][0])
        nearest = min(runs[0], key=lambda i: math.dist(hidden.boxes[i].at, hidden.boxes[name].at))
        hidden.state("gap", a=name, b=nearest, op="<=", value=1.5)
    for a, b in zip(names[1:], names):
        hidden.state("gap", a=a, b=b, op=">=", value=0.9)
    hidden.state("gap", a=runs[1][0], b=runs[0][0], op="<=", value=0.6)
    found = tables(hidden, packer, rect, seated)
    for name in found:
        for isle in names[:1]:
            hidden.state("gap", a=name, b=isle, op=">=", value=0.9)
    others = along_walls(hidden, packer, rect, n - len(hidden.boxes), "o")
    ends = found + names + (runs[0] + runs[1] if paths == EVERY else [runs[0][0], runs[1][-1]])
    if not ways(hidden, "entry", ends, 0.8):
        return None
    if others:
        sample(hidden, 2 * len(others), {**OPEN, "against_wall": 20}, others)
    return hidden


def l_rooms(rng, n, paths):
    """An L with things in its corners, along its walls and free, and ways from one leg to the other."""
    w, d = sides(rng, n * MEAN / 0.25 * 1.3)
    w, d = max(w, 4.2), max(d, 4.2)
    a, b = round(w * rng.uniform(0.42, 0.6), 2), round(d * rng.uniform(0.42, 0.6), 2)
    flip = rng.randrange(4)
    def turn(p):
        return round(w - p[0] if flip & 1 else p[0], 3), round(d - p[1] if flip & 2 else p[1], 3)
    corners = [turn(p) for p in [(0, 0), (w, 0), (w, b), (a, b), (a, d), (0, d)]]
    if flip in (1, 2):
        corners.reverse()
    hidden = Hidden(rng, [region("room", corners)])
    packer = packer_of(hidden)
    # A way through both legs, and the entry at the end of one of them.
    middle = turn((a / 2, b / 2))
    ends = [turn((w - 0.1, b / 2)), turn((a / 2, d - 0.1))]
    for end in ends:
        along = minus(end, middle)
        yaw = math.degrees(math.atan2(*along))
        long = math.hypot(*along)
        packer.keep.append(Frame(middle, yaw).rectangle(0, long / 2 - 0.45, 0.9, long + 0.9))
    yaw = math.degrees(math.atan2(*minus(middle, ends[0]))) % 360
    spot = Frame(turn((w, b / 2)), yaw).point(0, ENTRY[2] / 2 + FREE + 0.003)
    stand(hidden, packer, "entry", ENTRY, spot, yaw)
    hidden.state("against_wall", a="entry", region="room")
    polygon, cornered, walled, free = hidden.place.rooms()[0]["polygon"], [], [], []
    for k in range(n - 1):
        kind = "corner" if k < 3 else rng.choice(("wall", "wall", "free"))
        for _ in range(800):
            tw, td = round(rng.uniform(0.4, 1.5), 2), round(rng.uniform(0.35, 0.8), 2)
            if kind == "free":
                x0, z0, x1, z1 = bounds(polygon)
                at, yaw = (rng.uniform(x0, x1), rng.uniform(z0, z1)), rng.choice((0, 90, 180, 270, rng.uniform(0, 360)))
            else:
                p, q = rng.choice(edges(polygon))
                along = minus(q, p)
                long = math.hypot(*along)
                if long < tw + 0.1:
                    continue
                yaw = round(math.degrees(math.atan2(along[1], -along[0]))) % 360
                unit = (along[0] / long, along[1] / long)
                inward = Frame((0, 0), yaw).front
                u = rng.uniform(tw / 2 + 0.02, long - tw / 2 - 0.02)
                if kind == "corner":
                    u = rng.choice((tw / 2 + 0.03, long - tw / 2 - 0.03))
                off = td / 2 + FREE + 0.004
                at = tuple(p[i] + u * unit[i] + off * inward[i] for i in (0, 1))
                if not holds(polygon, at):
                    yaw = (yaw + 180) % 360
                    at = tuple(p[i] + u * unit[i] - off * inward[i] for i in (0, 1))
            if packer.fits(-1, tw, td, at, yaw):
                name = f"o{k}"
                stand(hidden, packer, name, (tw, round(rng.uniform(0.4, 1.9), 2), td), at, yaw)
                {"corner": cornered, "wall": walled, "free": free}[kind].append(name)
                break
    before_ = len(hidden.counted())
    sample(hidden, len(cornered), {"in_corner": 1}, cornered)
    for name in walled:
        hidden.state("against_wall", a=name, region="room")
    x_leg = [i for i in cornered + walled + free if turn(hidden.boxes[i].at)[0] > a]
    z_leg = [i for i in cornered + walled + free if turn(hidden.boxes[i].at)[1] > b]
    if not x_leg or not z_leg or before_ > 1:
        return None
    if not ways(hidden, "entry", [rng.choice(z_leg)] if paths != EVERY else rng.sample(z_leg, min(4, len(z_leg))), 0.8):
        return None
    if not ways(hidden, rng.choice(x_leg), [rng.choice(z_leg)], 0.7):
        return None
    sample(hidden, round(1.5 * n), OPEN, cornered + walled + free)
    return hidden


def cut(rng, rect, n):
    """Cuts a rectangle into n rooms with walls between them; none narrower than 2.4 m, else None."""
    x0, z0, x1, z1 = rect
    if n == 1:
        return [rect] if min(x1 - x0, z1 - z0) >= 2.4 else None
    m = n // 2 if rng.random() < 0.5 else n - n // 2
    share = m / n + rng.uniform(-0.06, 0.06)
    if x1 - x0 >= z1 - z0:
        c = round(x0 + (x1 - x0) * share, 2)
        first, second = cut(rng, (x0, z0, c - WALL, z1), m), cut(rng, (c + WALL, z0, x1, z1), n - m)
    else:
        c = round(z0 + (z1 - z0) * share, 2)
        first, second = cut(rng, (x0, z0, x1, c - WALL), m), cut(rng, (x0, c + WALL, x1, z1), n - m)
    return first + second if first and second else None


def shared(p, q):
    """Where two rooms share a wall: the axis across it, its middle, and how far it goes; or None."""
    for i in (0, 1):
        lo, hi = max(p[1 - i], q[1 - i]), min(p[3 - i], q[3 - i])
        for a, b in ((p, q), (q, p)):
            if abs(b[i] - a[i + 2] - 2 * WALL) < 0.005 and hi - lo >= 1.4:
                return i, (a[i + 2] + b[i]) / 2, lo, hi
    return None


ROOMS = ("hall", "living", "kitchen", "bedroom", "study", "bath")


def flats(rng, n, paths):
    """Rooms that share walls, doors between them, and a way from the entrance to something in each."""
    count = 4 if n < 20 else 5 if n < 36 else 6
    w, d = sides(rng, max(n * 0.9 / 0.22, count * 11))
    rects = cut(rng, (0, 0, w, d), count)
    if not rects:
        return None
    rooms = ROOMS[:count]
    rects.sort(key=lambda r: (r[2] - r[0]) * (r[3] - r[1]))
    # The hall is the room that shares most walls.
    hall = max(rects, key=lambda r: sum(shared(r, o) is not None for o in rects if o != r))
    rects.remove(hall)
    rng.shuffle(rects)
    rects.insert(0, hall)
    hidden = Hidden(rng, [region(i, rectangle(*r)) for i, r in zip(rooms, rects)])
    packer = packer_of(hidden)
    outer = [s for s, at in ((0, hall[1] == 0), (1, hall[0] == 0), (2, hall[3] == d), (3, hall[2] == w)) if at]
    if not outer:
        return None
    at, yaw = in_wall(hall, rng.choice(outer), rng.random())
    door(hidden, "entrance", at, yaw, ["hall"])
    hidden.state("clear", a="entrance", side="front", value=0.8)
    packer.keep.append(before(at, yaw, 1.0, 1.0))
    joined, waiting = [0], list(range(1, count))
    while waiting:
        pairs = [(i, j, shared(rects[i], rects[j])) for i in joined for j in waiting if shared(rects[i], rects[j])]
        if not pairs:
            return None
        i, j, (axis, middle, lo, hi) = pairs[0]
        u = rng.uniform(lo + 0.6, hi - 0.6)
        at = (middle, u) if axis == 0 else (u, middle)
        name, yaw = f"way{len(joined)}", (90 if axis == 0 else 0) + rng.choice((0, 180))
        door(hidden, name, at, yaw, [rooms[i], rooms[j]], wide=0.9)
        hidden.state("clear", a=name, side="front", value=0.8)
        hidden.state("clear", a=name, side="behind", value=0.8)
        packer.keep.append(Frame(at, yaw).rectangle(0, 0, 1.0, 2.0))
        waiting.remove(j)
        joined.append(j)
    floors = [(r[2] - r[0]) * (r[3] - r[1]) for r in rects]
    things, pools = n - count, []
    for k, (room, rect) in enumerate(zip(rooms, rects)):
        here = things - sum(len(p) for p in pools) if k == count - 1 else max(1, round(things * floors[k] / sum(floors)))
        names = along_walls(hidden, packer, rect, here - (here > 3), f"{room[0]}{k}n", room=room, sizes=((0.4, 1.8), (0.3, 0.7)))
        for name in names:
            if rng.random() < 0.8:
                hidden.state("against_wall", a=name, region=room)
        # One thing in the middle where there is room to walk around it.
        x0, z0, x1, z1 = rect
        for _ in range(60):
            size, spot = (round(rng.uniform(0.6, 1.6), 2), 0.5, round(rng.uniform(0.5, 0.9), 2)), (rng.uniform(x0, x1), rng.uniform(z0, z1))
            if len(names) > 2 and packer.fits(-1, size[0] + 1.7, size[2] + 1.7, spot, 0):
                name = f"mid{k}"
                stand(hidden, packer, name, size, spot, rng.choice((0, 90, 180, 270)) if size[0] < 1.2 else 0, room=room)
                names.append(name)
                break
        pools.append(names)
    if not all(pools):
        return None
    ends = [name for names in pools for name in (rng.sample(names, min(3, len(names))) if paths == EVERY else names[:1])]
    if not ways(hidden, "entrance", ends, 0.8):
        return None
    for names in pools:
        if len(names) > 1:
            sample(hidden, round(1.5 * len(names)), OPEN, names)
    return hidden


HOMES = {"kitchen": kitchen, "l-rooms": l_rooms, "flats": flats}
