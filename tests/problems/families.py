"""The families of problems: what kind of room each has, what stands in it, and what is asked of it."""

import math

import sampling
from geometry import footprint
from hidden import FREE, HEIGHT, MEAN, Hidden, Packer, bounds, cells, filled, floor_of, rectangle, region, sides
from kinds import WALL, margin
from sampling import FLAT, TURNED, UNZONED, sample, zones
from walk import Floor

QUARTERS = [0, 90, 180, 270]
# Names are such that the library of furniture knows none of them: then a thing is the plain box that the judge takes it for.


def tall(rng):
    return round(rng.uniform(0.4, 1.6), 2)


def room_for(rng, n, cover):
    w, d = sides(rng, n * MEAN / cover)
    return [region("room", rectangle(0, 0, w, d))], (0, 0, w, d)


def place(hidden, packer, prefix="o", room=None):
    """Makes things of what was packed; their names."""
    names = []
    for w, d, at, yaw, _ in packer.things:
        name = f"{prefix}{len(names)}"
        hidden.add(name, (w, tall(hidden.rng), d), (at[0], 0, at[1]), yaw)
        hidden.floor(name, room or "room")
        names.append(name)
    return names


def packed(rng, regions, parts, n, cover, walls=0.3, aisle=0.0, keep=(), yaw=None):
    """Things at any yaw, some of them with their backs to a wall, in rectangles that make up a room."""
    packer = Packer(rng, [r["polygon"] for r in regions if not r.get("zone")], keep)
    floors = [(x1 - x0) * (z1 - z0) for x0, z0, x1, z1 in parts]
    left = n
    for i, rect in enumerate(parts):
        count = left if i == len(parts) - 1 else max(1, round(n * floors[i] / sum(floors)))
        left -= count
        for cell in cells(rng, rect, count, aisle):
            wall = packer.to_wall(cell, rect, walls)
            free = rng.uniform(0, 360) if yaw is None else yaw()
            packer.put(cell, free if wall is None else wall, wall is not None)
    packer.settle(cover, floor_of(regions))
    for room in packer.rooms:
        packer.back_up(room)
    return packer


def free_yaw(rng, n, cover):
    regions, rect = room_for(rng, n, cover)
    hidden = Hidden(rng, regions)
    place(hidden, packed(rng, regions, [rect], n, cover))
    zones(hidden, max(2, n // 8))
    sample(hidden, 3 * n, TURNED)
    return hidden


def l_room(rng, n, cover):
    """An L, its notch at one of the four corners."""
    w, d = sides(rng, n * MEAN / cover * 1.3)
    a, b = round(w * rng.uniform(0.4, 0.65), 2), round(d * rng.uniform(0.4, 0.65), 2)
    corners, parts = [(0, 0), (w, 0), (w, b), (a, b), (a, d), (0, d)], [(0, 0, w, b), (0, b, a, d)]
    flip = rng.randrange(4)
    def turn(p):
        return (w - p[0] if flip & 1 else p[0], d - p[1] if flip & 2 else p[1])
    parts = [bounds([turn((x0, z0)), turn((x1, z1))]) for x0, z0, x1, z1 in parts]
    regions = [region("room", [turn(p) for p in corners])]
    hidden = Hidden(rng, regions)
    def yaw():
        return rng.choice(QUARTERS) if rng.random() < 0.5 else rng.uniform(0, 360)
    place(hidden, packed(rng, regions, parts, n, cover, walls=0.5, yaw=yaw))
    zones(hidden, max(2, n // 8))
    sample(hidden, 3 * n, {**TURNED, "against_wall": 16, "in_corner": 8})
    return hidden


def reachables(hidden, starts, ends, count):
    """States that some of the ends can be reached from some of the starts, at widths that the hidden layout has."""
    rng, floors, done = hidden.rng, {}, set()
    for _ in range(12 * count):
        if len(done) >= count:
            return
        a, b, width = rng.choice(starts), rng.choice(ends), rng.choice((0.5, 0.55, 0.6, 0.7, 0.8))
        if (a, b) in done:
            continue
        if width not in floors:
            floors[width] = Floor(hidden.place.floors(), hidden.place.obstacles(), (width + 0.03) / 2, last=0.008)
        if floors[width].joined(hidden.boxes[a].corners, hidden.boxes[b].corners, -0.005):
            done.add((a, b))
            hidden.state("reachable", a=a, b=b, value=width)


def two_rooms(rng, n, cover):
    """Two rooms side by side with a door between them, which must open and be reached from both."""
    w, d = sides(rng, n * MEAN / cover + 2.5)
    split = round(w * rng.uniform(0.4, 0.6), 2)
    far = 2 * WALL
    rects = [(0, 0, split, d), (split + far, 0, w + far, d)]
    names = ["west", "east"]
    regions = [region(i, rectangle(*r)) for i, r in zip(names, rects)]
    hidden = Hidden(rng, regions)
    at = (split + WALL, rng.uniform(0.8, d - 0.8))
    before = footprint(at, 1.0, 2 * 0.85 + far, 90)
    packer = packed(rng, regions, rects, n - 1, cover, aisle=0.75, keep=[before])
    hidden.add("door", (0.9, 2.05, 0.06), (at[0], 0, at[1]), rng.choice((90, 270)))
    hidden.state("connects", a="door", regions=names)
    hidden.state("bound", a="door", axis="y", op="<=", value=0.005)
    hidden.state("clear", a="door", side="front", value=0.7)
    hidden.state("clear", a="door", side="behind", value=0.7)
    pools = {"west": [], "east": []}
    for k, (w_, d_, at_, yaw, _) in enumerate(packer.things):
        room = "west" if at_[0] < split else "east"
        hidden.add(f"o{k}", (w_, tall(rng), d_), (at_[0], 0, at_[1]), yaw)
        hidden.floor(f"o{k}", room)
        pools[room].append(f"o{k}")
    reachables(hidden, pools["west"], pools["east"], max(2, n // 10))
    left = 3 * n - len(hidden.counted())
    for room, pool in pools.items():
        sample(hidden, round(left * len(pool) / (n - 1)), UNZONED, pool)
    return hidden


def stacking(rng, n, cover):
    """Tables on the floor, trays on the tables, small things on the trays."""
    low, mid = max(3, round(n * 0.4)), max(3, round(n * 0.35))
    regions, rect = room_for(rng, low, cover)
    hidden = Hidden(rng, regions)
    packer = packed(rng, regions, [rect], low, cover)
    tables = place(hidden, packer, "big")
    def heap(prefix, hosts, count, share, heights):
        """Things on the tops of others, several on one where there are more than hosts."""
        names = []
        for i, host in enumerate(hosts):
            here = count // len(hosts) + (i < count % len(hosts))
            base = hidden.boxes[host]
            for cell in cells(rng, (-base.w / 2, -base.d / 2, base.w / 2, base.d / 2), here) if here else []:
                w, d, at, = filled(rng, cell, share, 0)
                top = base.pos[1] + base.h
                yaw = base.yaw + rng.choice((0, 90, 180, 270))
                w, d = (w, d) if round(yaw - base.yaw) % 180 == 0 else (d, w)
                name = f"{prefix}{len(names)}"
                x, z = base.point(*at)
                size = (math.floor(w * 1000) / 1000, round(rng.uniform(*heights), 2), math.floor(d * 1000) / 1000)
                hidden.add(name, size, (x, top, z), yaw)
                hidden.state("on", a=name, b=host)
                names.append(name)
        return names
    trays = heap("mid", sorted(tables, key=lambda t: -hidden.boxes[t].w * hidden.boxes[t].d), mid, 0.55, (0.05, 0.3))
    heap("top", sorted(trays, key=lambda t: -hidden.boxes[t].w * hidden.boxes[t].d), n - low - mid, 0.45, (0.05, 0.3))
    zones(hidden, max(2, n // 8))
    sample(hidden, 3 * n - len(hidden.counted()), TURNED)
    return hidden


def seating(rng, n, cover):
    """Tables at any yaw with seats around them that face them, and a few things along the walls."""
    count = max(1, n // 7)
    seats = [rng.choice((4, 5, 6)) for _ in range(count)]
    rest = max(1, n - sum(seats) - count)
    floor = (sum(seats) * 0.18 + count * 1.1 + rest * 0.4) / min(cover, 0.4)
    w, d = sides(rng, max(floor, 6))
    regions = [region("room", rectangle(0, 0, w, d))]
    hidden = Hidden(rng, regions)
    packer = Packer(rng, [regions[0]["polygon"]])
    # Islands first: a table with its seats takes the larger half of the cells.
    grid = sorted(cells(rng, (0, 0, w, d), count + max(1, rest // 3)), key=lambda c: -min(c[2] - c[0], c[3] - c[1]))
    made = []
    for k in range(count):
        x0, z0, x1, z1 = grid[k]
        middle = ((x0 + x1) / 2, (z0 + z1) / 2)
        tw, td, seat = rng.choice((1.2, 1.3, 1.4)), rng.choice((0.8, 0.9)), rng.choice((0.4, 0.42, 0.45))
        for _ in range(400):
            yaw = rng.uniform(0, 360) if k % 3 else rng.choice(QUARTERS)
            at = (middle[0] + rng.uniform(-0.6, 0.6), middle[1] + rng.uniform(-0.6, 0.6))
            spots = around_table(at, tw, td, yaw, seat, seats[k], rng)
            trial = [(tw, td, at, yaw)] + spots
            if all(packer.fits(-1, *t) for t in trial):
                packer.things += [[*t, False] for t in trial]
                made.append((tw, td, at, yaw, seat, spots))
                break
            middle = (rng.uniform(0.9, w - 0.9), rng.uniform(0.9, d - 0.9))
    for k, (tw, td, at, yaw, seat, spots) in enumerate(made):
        table, chairs = f"hub{k}", [f"side{k}[{i}]" for i in range(len(spots))]
        hidden.add(table, (tw, 0.75, td), (at[0], 0, at[1]), yaw)
        hidden.floor(table)
        for name, (sw, sd, sat, syaw) in zip(chairs, spots):
            hidden.add(name, (sw, 0.85, sd), (sat[0], 0, sat[1]), syaw, array=f"side{k}")
            hidden.floor(name)
        hidden.state("around", a=chairs, b=table, set=f"side{k}", value=0.2)
        for name in chairs:
            hidden.state("facing", a=name, b=table)
            if rng.random() < 0.6:
                hidden.state("gap", a=name, b=table, op=">=", value=0.03)
        sample(hidden, 2, {"bound": 3, "heading": 3, "against_wall": 1}, [table])
    others = extras(hidden, packer, max(1, n - len(hidden.boxes)))
    zones(hidden, max(2, n // 8))
    tables = [i for i in hidden.boxes if i.startswith("hub")]
    chairs = [i for i in hidden.boxes if i.startswith("side")]
    sample(hidden, 2 * len(others) + len(tables), TURNED, others + tables)
    sample(hidden, max(0, 3 * len(hidden.boxes) - len(hidden.counted())), {"direction": 5, "gap": 3, "turned": 2, "distance": 4}, chairs)
    return hidden


def around_table(at, w, d, yaw, seat, count, rng):
    """Places of seats around a table: long sides first, then the ends; each turned to its middle."""
    off = rng.uniform(0.05, 0.13) + seat / 2
    # As far from the middle of a side as a seat may be and still look at the middle of the table.
    reach = min(w / 2 - seat / 2, math.tan(math.radians(26)) * (d / 2 + off))
    reach = max(reach, seat / 2 + 0.03)
    local = [(-reach, d / 2 + off, 180), (reach, d / 2 + off, 180), (-reach, -d / 2 - off, 0), (reach, -d / 2 - off, 0)]
    local += [(w / 2 + off, 0, 270), (-w / 2 - off, 0, 90)]
    f, r = (math.sin(math.radians(yaw)), math.cos(math.radians(yaw))), (math.cos(math.radians(yaw)), -math.sin(math.radians(yaw)))
    out = []
    for u, v, turn in local[:count]:
        x, z = at[0] + u * r[0] + v * f[0], at[1] + u * r[1] + v * f[1]
        out.append((seat, seat, (x, z), yaw + turn + rng.uniform(-2, 2)))
    return out


def extras(hidden, packer, count):
    """Further things wherever there is room, along the walls first."""
    rng, names = hidden.rng, []
    x0, z0, x1, z1 = bounds(hidden.place.rooms()[0]["polygon"])
    for _ in range(4000):
        if len(names) >= count:
            break
        w, d = round(rng.uniform(0.4, 1.2), 2), round(rng.uniform(0.3, 0.6), 2)
        yaw = rng.choice(QUARTERS) if rng.random() < 0.7 else rng.uniform(0, 360)
        if yaw in QUARTERS:
            u, back = rng.random(), d / 2 + FREE + 0.005
            at = {0: (x0 + u * (x1 - x0), z0 + back), 180: (x0 + u * (x1 - x0), z1 - back),
                  90: (x0 + back, z0 + u * (z1 - z0)), 270: (x1 - back, z0 + u * (z1 - z0))}[yaw]
        else:
            at = rng.uniform(x0, x1), rng.uniform(z0, z1)
        if packer.fits(-1, w, d, at, yaw):
            packer.things.append([w, d, at, yaw, False])
            name = f"o{len(names)}"
            hidden.add(name, (w, tall(rng), d), (at[0], 0, at[1]), yaw)
            hidden.floor(name)
            names.append(name)
    return names


def rows(rng, n, cover):
    """Rows of seats before a stage, with an aisle between blocks; the whole at any yaw."""
    rest = max(2, n // 8)
    blocks = 2 if n >= 20 else 1
    seats = n - 1 - rest
    across = max(2, round(math.sqrt(seats * 1.3) / blocks))
    count = max(2, math.ceil(seats / (across * blocks)))
    w, d, pitch, step, aisle = 0.52, 0.55, 0.57, 0.95, 0.95
    wide, deep = blocks * across * pitch + (blocks - 1) * aisle, count * step + 1.5
    turn = rng.choice(QUARTERS) + (rng.uniform(-12, 12) if rng.random() < 0.5 else 0)
    c, s = abs(math.cos(math.radians(turn))), abs(math.sin(math.radians(turn)))
    x1, z1 = round(wide * c + deep * s + 0.9, 2), round(wide * s + deep * c + 0.9, 2)
    regions = [region("room", rectangle(0, 0, x1, z1))]
    hidden = Hidden(rng, regions)
    packer = Packer(rng, [regions[0]["polygon"]])
    f, r = (math.sin(math.radians(turn)), math.cos(math.radians(turn))), (math.cos(math.radians(turn)), -math.sin(math.radians(turn)))
    def at(u, v):
        return x1 / 2 + u * r[0] + v * f[0], z1 / 2 + u * r[1] + v * f[1]
    stage_wide = round(wide * 0.6, 2)
    stage = at(0, deep / 2 - 0.4)
    hidden.add("head", (stage_wide, 0.5, 0.8), (stage[0], 0, stage[1]), turn + 180)
    hidden.floor("head")
    packer.things.append([stage_wide, 0.8, stage, turn + 180, False])
    made = 0
    for j in range(count):
        for b in range(blocks):
            name, before = f"row{j}_{b}", f"row{j - 1}_{b}"
            here = min(across, seats - made)
            if here < 2:
                continue
            made += here
            for i in range(here):
                u = -wide / 2 + b * (across * pitch + aisle) + (i + 0.5) * pitch
                p = at(u, deep / 2 - 1.5 - j * step)
                hidden.add(f"{name}[{i}]", (w, 0.9, d), (p[0], 0, p[1]), turn, array=name)
                hidden.floor(f"{name}[{i}]")
                packer.things.append([w, d, p, turn, False])
                me = f"{name}[{i}]"
                if i:
                    hidden.state("aligned", a=me, b=f"{name}[{i - 1}]")
                    hidden.state("right_of", a=me, b=f"{name}[{i - 1}]")
                    hidden.state("gap", a=me, b=f"{name}[{i - 1}]", op="<=", value=0.12)
                    hidden.state("parallel", a=me, b=f"{name}[{i - 1}]")
            if j and f"{before}[0]" in hidden.boxes:
                hidden.state("behind", a=f"{name}[0]", b=f"{before}[0]")
                hidden.state("gap", a=f"{name}[0]", b=f"{before}[0]", op=">=", value=0.4)
                hidden.state("gap", a=f"{name}[0]", b=f"{before}[0]", op="<=", value=0.6)
            if b and f"row{j}_0[{across - 1}]" in hidden.boxes:
                hidden.state("gap", a=f"{name}[0]", b=f"row{j}_0[{across - 1}]", op=">=", value=0.8)
            if not j:
                hidden.state("turned", a=f"{name}[0]", b="head", op=">=", value=170)
                before_stage = [f"{name}[{i}]" for i in range(here)]
                stated = {"kind": "in_front_of", "b": "head"}
                found = max(before_stage, key=lambda i: margin({**stated, "a": i}, hidden.place))
                hidden.state(a=found, **stated)
    others = extras(hidden, packer, rest)
    zones(hidden, 2)
    sample(hidden, 3 * len(others), TURNED, others + ["head"])
    return hidden


def paths(rng, n, cover):
    """Furniture with ways between it: the exits must be reached from the stations."""
    exits = 2
    w, d = sides(rng, n * MEAN / min(cover, 0.35) * 1.05)
    regions, rect = [region("room", rectangle(0, 0, w, d))], (0, 0, w, d)
    hidden = Hidden(rng, regions)
    spots = [((rng.uniform(0.6, w - 0.6), 0.04), 0), ((rng.uniform(0.6, w - 0.6), d - 0.04), 180)]
    keep = [footprint((x, z + (0.4 if yaw == 0 else -0.4)), 1.0, 0.9, 0) for (x, z), yaw in spots]
    packer = packed(rng, regions, [rect], n - exits, min(cover, 0.33), aisle=0.8, keep=keep)
    for k, (at, yaw) in enumerate(spots):
        hidden.add(f"exit{k}", (0.9, 2.0, 0.05), (at[0], 0, at[1]), yaw)
        hidden.floor(f"exit{k}")
        hidden.state("against_wall", a=f"exit{k}", region="room")
    names = place(hidden, packer)
    reachables(hidden, names, [f"exit{k}" for k in range(exits)], max(3, n // 4))
    sample(hidden, 3 * n - len(hidden.counted()), UNZONED)
    return hidden


def soft(rng, n, cover):
    """Two hard constraints for each thing, and a preference: seven in ten hold in the hidden layout, the others in
    another one of the same things, so that not all can."""
    regions, rect = room_for(rng, n, cover)
    hidden = Hidden(rng, regions)
    names = place(hidden, packed(rng, regions, [rect], n, cover))
    zones(hidden, max(2, n // 8))
    sample(hidden, 2 * n, TURNED)
    sample(hidden, round(0.7 * n), TURNED, weight=[1, 1, 2, 3])
    other = Hidden(rng, hidden.facts["regions"])
    shuffled = rng.sample(names, len(names))
    for name, there in zip(names, shuffled):
        box, target = hidden.boxes[name], hidden.boxes[there]
        other.add(name, box.size, target.pos, target.yaw)
    sample(hidden, n - round(0.7 * n), TURNED, weight=[1, 1, 2, 3], truth=other)
    return hidden


def by_quarters(rng, names, hidden):
    for name in names:
        hidden.state("yaw", given=True, a=name, yaws=QUARTERS)


def boxes_by_quarters(hidden, rect, n, share, prefix="o"):
    """Things turned by quarters, each in a cell of its own; the larger first."""
    rng, names = hidden.rng, []
    found = sorted(cells(rng, rect, n), key=lambda c: -(c[2] - c[0]) * (c[3] - c[1]))
    for cell in found:
        x0, z0, x1, z1 = cell
        walls = [y for y, at in ((0, z0 == rect[1]), (90, x0 == rect[0]), (180, z1 == rect[3]), (270, x1 == rect[2])) if at]
        yaw = rng.choice(walls) if walls and rng.random() < 0.5 else rng.choice(QUARTERS)
        w, d, (x, z) = filled(rng, cell, share, yaw)
        ex, ez = (w, d) if yaw % 180 == 0 else (d, w)
        if yaw in walls and rng.random() < 0.8:
            x, z = {0: (x, z0 + ez / 2), 180: (x, z1 - ez / 2), 90: (x0 + ex / 2, z), 270: (x1 - ex / 2, z)}[yaw]
        # Rounding to millimetres must not leave the cell.
        x = min(max(x, math.ceil((x0 + ex / 2) * 1000 - 1e-6) / 1000), math.floor((x1 - ex / 2) * 1000 + 1e-6) / 1000)
        z = min(max(z, math.ceil((z0 + ez / 2) * 1000 - 1e-6) / 1000), math.floor((z1 - ez / 2) * 1000 + 1e-6) / 1000)
        name = f"{prefix}{len(names)}"
        hidden.add(name, (w, tall(rng), d), (x, 0, z), yaw)
        hidden.floor(name)
        names.append(name)
    by_quarters(rng, names, hidden)
    return names


def random_feasible(rng, n, cover, k=3):
    regions, rect = room_for(rng, n, cover)
    hidden = Hidden(rng, regions)
    names = boxes_by_quarters(hidden, rect, n, cover)
    zones(hidden, max(2, n // 8))
    sample(hidden, k * n, FLAT, names)
    return hidden


def tight_packing(rng, n, cover):
    regions, rect = room_for(rng, n, cover)
    hidden = Hidden(rng, regions)
    boxes_by_quarters(hidden, rect, n, cover)
    return hidden


def paper(rng, n, cover):
    """The published scale: 40 things, a quarter of them on others, and more than 100 constraints."""
    low = n - n // 4
    regions, rect = room_for(rng, low, cover)
    hidden = Hidden(rng, regions)
    names = boxes_by_quarters(hidden, rect, low, cover)
    hosts = sorted(names, key=lambda i: -hidden.boxes[i].w * hidden.boxes[i].d)
    small = []
    for k in range(n // 4):
        base = hidden.boxes[hosts[k]]
        w, d = (round(v * rng.uniform(0.25, 0.5), 2) for v in (base.w, base.d))
        name = f"s{k}"
        x, z = base.point(rng.uniform(-0.15, 0.15) * base.w, rng.uniform(-0.15, 0.15) * base.d)
        # Turned as what carries it, so that it lies on it whole.
        hidden.add(name, (w, round(rng.uniform(0.1, 0.3), 2), d), (x, base.h, z), base.yaw)
        hidden.state("on", a=name, b=hosts[k])
        small.append(name)
    by_quarters(rng, small, hidden)
    zones(hidden, n // 8)
    sample(hidden, rng.randint(105, 130) - len(hidden.counted()), FLAT)
    return hidden


FAMILIES = {
    "free-yaw": free_yaw,
    "l-room": l_room,
    "two-rooms": two_rooms,
    "stacking": stacking,
    "seating": seating,
    "rows": rows,
    "paths": paths,
    "soft": soft,
    "paper": paper,
    "random-feasible": random_feasible,
    "tight-packing": tight_packing,
}
