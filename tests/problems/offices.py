"""Families of rooms with rows in them: desks with chairs, storage racks, seats before a screen."""

import math

from furnished import EVERY, along_walls, before, door, in_row, in_wall, packer_of, stand, turned_room, ways
from geometry import minus
from hidden import FREE, Hidden, bounds, rectangle, region
from sampling import sample

MORE = {"bound": 6, "distance": 8, "gap": 8, "direction": 6, "order": 6, "against_wall": 14, "facing": 4, "inline": 0}


def room_of(rng, w, d):
    """A room of w by d in a frame of its own, and its bounds."""
    (x, z), frame = turned_room(rng, w, d)
    hidden = Hidden(rng, [region("room", rectangle(0, 0, x, z))])
    return hidden, frame, (0, 0, x, z)


def gate(hidden, packer, rect, free):
    """A door in a wall, with free floor before it."""
    at, yaw = in_wall(rect, hidden.rng.randrange(4), hidden.rng.random())
    door(hidden, "portal", at, yaw, ["room"], wide=1.0)
    packer.keep.append(before(at, yaw, free + 0.1, free))


def desk_clusters(rng, n, paths):
    """Desks with a chair each in groups, side by side or face to face, with aisles between the groups."""
    more = max(1, n // 10)
    left, groups = (n - 1 - more) // 2, []
    while left > 0:
        count = min(left, rng.choice((2, 3, 4, 4, 5, 6)))
        count = count if left - count != 1 else count - 1 if count > 2 else count + 1
        groups.append((count, count > 2 and rng.random() < 0.7))
        left -= count
    w, d, seat, off, aisle = rng.choice((1.2, 1.4, 1.6)), rng.choice((0.7, 0.8)), rng.choice((0.45, 0.5)), 0.1, 1.0
    # Shelves of groups, each with an aisle on every side.
    across = max(1, round(math.sqrt(len(groups))))
    shelves = [groups[i:i + across] for i in range(0, len(groups), across)]
    def extent(group):
        count, facing = group
        return (math.ceil(count / 2) if facing else count) * (w + 0.03), (2 if facing else 1) * (d + off + seat)
    wide = max(sum(extent(g)[0] + aisle for g in shelf) for shelf in shelves) + aisle
    deep = sum(max(extent(g)[1] for g in shelf) + aisle for shelf in shelves) + aisle
    hidden, frame, rect = room_of(rng, wide + 0.7, deep + 0.7)
    packer, ends, v, made = packer_of(hidden), [], -(deep + 0.7) / 2 + aisle, 0
    for shelf in shelves:
        u = -(wide + 0.7) / 2 + aisle
        for count, facing in shelf:
            gw, gd = extent((count, facing))
            rows = [math.ceil(count / 2), count // 2] if facing else [count]
            desks, seats = f"place{made}", f"sit{made}"
            chairs, firsts, k = [], [], 0
            for j, here in enumerate(rows):
                turn = 0 if (j or not facing) else 180
                sign = 1 if turn == 0 else -1
                line = v + gd / 2 + sign * d / 2 + (0.01 * sign if facing else -(off + seat) / 2)
                names = []
                for i in range(here):
                    at = u + (i + 0.5) * (w + 0.03)
                    name, chair = f"{desks}[{k}]", f"{seats}[{k}]"
                    stand(hidden, packer, name, (w, 0.74, d), frame.point(at, line), frame.yaw + turn, array=desks)
                    near = off + rng.uniform(-0.06, 0.02)
                    spot = frame.point(at + rng.uniform(-0.1, 0.1), line + sign * (d / 2 + near + seat / 2))
                    stand(hidden, packer, chair, (seat, 0.9, seat), spot, frame.yaw + turn + 180, array=seats)
                    hidden.state("in_front_of", a=chair, b=name)
                    hidden.state("facing", a=chair, b=name)
                    hidden.state("gap", a=chair, b=name, op="<=", value=0.2)
                    names.append(name)
                    chairs.append(chair)
                    k += 1
                in_row(hidden, names if turn == 0 else names[::-1])
                firsts.append(names[0])
            if facing:
                hidden.state("behind", a=firsts[1], b=firsts[0])
                hidden.state("gap", a=firsts[1], b=firsts[0], op="<=", value=0.1)
                hidden.state("turned", a=firsts[1], b=firsts[0], op=">=", value=175)
            packer.keep.append(frame.rectangle(u + gw / 2, v + gd / 2, gw + 2 * aisle - 0.02, gd + 2 * aisle - 0.02))
            ends += chairs if paths == EVERY else chairs[:1]
            made += 1
            u += gw + aisle
        v += max(extent(g)[1] for g in shelf) + aisle
    gate(hidden, packer, rect, 0.9)
    others = along_walls(hidden, packer, rect, n - len(hidden.boxes), "o")
    if not ways(hidden, "portal", ends, 0.9):
        return None
    if others:
        sample(hidden, 2 * len(others), MORE, others)
    return hidden


def rack_rows(rng, n, paths):
    """Rows of racks back to back, with aisles of two metres."""
    more = max(1, n // 12)
    racks, w, d = n - 1 - more, rng.choice((1.8, 2.2, 2.7)), rng.choice((0.8, 0.9, 1.1))
    columns = max(2, round(math.sqrt(racks * (2 * d + 2.15) / (2 * w))))
    blocks, left = [], racks
    while left > 0:
        pair = left >= columns + 2 and rng.random() < 0.8
        count = min(left, 2 * columns if pair else columns)
        # A row of one would be no row.
        count += 1 if left - count == 1 else 0
        blocks.append((math.ceil(count / 2), count // 2) if pair else (count,))
        left -= count
    aisle = 2.12
    depths = [len(b) * d + (len(b) - 1) * 0.04 for b in blocks]
    wide = max(max(b) for b in blocks) * (w + 0.03) + 2 * aisle + 0.7
    deep = sum(depths) + (len(blocks) + 1) * aisle
    hidden, frame, rect = room_of(rng, wide, deep)
    packer, v, made, ends, previous = packer_of(hidden), -deep / 2 + aisle, 0, [], None
    for block, thick in zip(blocks, depths):
        rows = []
        for j, here in enumerate(block):
            turn = 0 if j else 180
            if len(block) == 1:
                turn = rng.choice((0, 180))
            names, line = f"bay{made}", v + d / 2 + j * (d + 0.04)
            made += 1
            row = [f"{names}[{i}]" for i in range(here)]
            for i, name in enumerate(row):
                u = -wide / 2 + aisle + (i + 0.5) * (w + 0.03)
                stand(hidden, packer, name, (w, 2.4, d), frame.point(u, line), frame.yaw + turn, array=names)
            in_row(hidden, row if turn == 0 else row[::-1])
            rows.append(row)
        if len(rows) == 2:
            for a, b in zip(*rows):
                hidden.state("behind", a=b, b=a)
                hidden.state("gap", a=b, b=a, op="<=", value=0.1)
            hidden.state("turned", a=rows[1][0], b=rows[0][0], op=">=", value=175)
        if previous:
            for a, b in zip(previous, rows[0]):
                hidden.state("gap", a=b, b=a, op=">=", value=2)
        previous = rows[-1]
        for row in rows:
            ends += row if paths == EVERY else row[:1]
        long = len(rows[0]) * (w + 0.03)
        packer.keep.append(frame.rectangle(-wide / 2 + aisle + long / 2, v + thick / 2, long + 2 * aisle - 0.02, thick + 2 * aisle - 0.02))
        v += thick + aisle
    gate(hidden, packer, rect, 2.1)
    others = along_walls(hidden, packer, rect, n - len(hidden.boxes), "o", sizes=((0.4, 1.0), (0.3, 0.6)))
    if not ways(hidden, "portal", ends, 2.0):
        return None
    if others:
        sample(hidden, 2 * len(others), MORE, others)
    return hidden


def screen_seats(rng, n, paths):
    """Rows of seats before a screen: each sees it from near enough, and not from the side; a path leads to each row."""
    more = max(1, n // 10)
    seats, seat = n - 2 - more, rng.choice((0.5, 0.55))
    pitch, step, aisle = 0.75, seat + 1.15, 1.05
    across = min(8, max(2, round(math.sqrt(seats * 1.6))))
    counts = [across] * (seats // across)
    if seats % across:
        counts.append(seats % across)
    wide, deep = across * pitch + 2 * aisle + 0.6, 2.2 + len(counts) * step + 0.6
    hidden, frame, rect = room_of(rng, wide, deep)
    packer, top = packer_of(hidden), deep / 2
    broad = round(rng.uniform(1.8, min(3.0, wide - 1)), 2)
    stand(hidden, packer, "head", (broad, 1.7, 0.12), frame.point(0, top - 0.06 - FREE - 0.004), frame.yaw + 180)
    hidden.state("against_wall", a="head", region="room")
    screen, ends = hidden.boxes["head"], []
    packer.keep.append(frame.rectangle(0, top - 1, broad, 2))
    for j, here in enumerate(counts):
        names, v = f"row{j}", top - 2.2 - j * step
        for i in range(here):
            at = frame.point((i + 0.5 - here / 2) * pitch, v - seat / 2)
            off = minus(screen.at, at)
            yaw = 5 * round(math.degrees(math.atan2(*off)) / 5)
            stand(hidden, packer, f"{names}[{i}]", (seat, 0.9, seat), at, yaw, array=names)
        row = [f"{names}[{i}]" for i in range(here)]
        axis = "z" if frame.yaw % 180 == 0 else "x"
        for i, name in enumerate(row):
            hidden.state("facing", a=name, b="head")
            hidden.state("looks", a=name, b="head", value=15)
            hidden.state("looks", a="head", b=name, value=55)
            if i:
                hidden.state("gap", a=name, b=row[i - 1], op="<=", value=0.35)
                hidden.state("inline", a=name, b=row[i - 1], axis=axis, value=0.1)
        far = max(math.dist(hidden.boxes[i].middle, screen.middle) for i in row)
        for name in row:
            hidden.state("distance", a=name, b="head", op="<=", value=math.ceil(2 * far + 0.4) / 2)
        if j:
            for a in row:
                hidden.state("gap", a=a, b=min((f"row{j - 1}[{i}]" for i in range(counts[j - 1])), key=lambda b: math.dist(hidden.boxes[a].at, hidden.boxes[b].at)), op=">=", value=0.9)
        else:
            hidden.state("distance", a=row[0], b="head", op=">=", value=1.8)
        packer.keep.append(frame.rectangle(0, v - seat / 2, here * pitch + 2 * aisle, step + aisle))
        ends += row if paths == EVERY else row[:1]
    gate(hidden, packer, rect, 0.9)
    others = along_walls(hidden, packer, bounds(hidden.place.rooms()[0]["polygon"]), n - len(hidden.boxes), "o")
    if not ways(hidden, "portal", ends, 0.9):
        return None
    if others:
        sample(hidden, 2 * len(others), MORE, others)
    return hidden


OFFICES = {"desk-clusters": desk_clusters, "rack-rows": rack_rows, "screen-seats": screen_seats}
