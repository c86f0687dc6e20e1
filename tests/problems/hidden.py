"""Hidden layouts: rooms with things in them that stand free of each other, from which satisfiable problems are made."""

import math

import kinds
from geometry import Box, apart, area, footprint, within

FREE = 0.012  # things of a hidden layout stand at least so far apart, and from the walls unless they are against one (metres)
HEIGHT = 2.8  # of rooms (metres)
MEAN = 0.55  # floor that a thing takes on average (square metres)


class Hidden:
    """Facts of a problem in the making, with a layout that satisfies all of them."""

    def __init__(self, rng, regions):
        self.rng, self.boxes = rng, {}
        self.facts = {"format": "scenelang.problem/1", "regions": regions, "objects": [], "constraints": []}
        self.place = kinds.Place(self.facts, self.boxes)

    def add(self, name, size, pos, yaw, array=None):
        """Puts a thing somewhere, rounded as a person would write it down."""
        size, pos = [round(v, 3) for v in size], [round(v, 3) + 0.0 for v in pos]
        thing = {"id": name, "size": size}
        if array:
            thing["array"] = array
        self.facts["objects"].append(thing)
        self.boxes[name] = Box(size, pos, round(yaw % 360, 1))

    def state(self, kind, given=False, **members):
        """States something; what is `given` (what a thing stands on, how it may be turned) is not counted."""
        constraint = {"id": f"{'g' if given else 'c'}{len(self.facts['constraints'])}", "kind": kind, **members}
        if given:
            constraint["given"] = True
        if kind == "connects":
            self.place.doors.append(members["a"])
        self.facts["constraints"].append(constraint)
        return constraint

    def floor(self, name, room="room"):
        self.state("floor", given=True, a=name, region=room)

    def counted(self):
        return [c for c in self.facts["constraints"] if not c.get("given")]

    def layout(self, scene):
        """The layout as a file."""
        objects = {
            i: {"pos": list(b.pos), "rot": [0, b.yaw, 0], "scale": list(b.size)} for i, b in self.boxes.items()
        }
        regions = {}
        for region in self.facts["regions"]:
            (x0, z0, x1, z1), corners = bounds(region["polygon"]), region["polygon"]
            found = {"pos": [(x0 + x1) / 2, region["floor"], (z0 + z1) / 2], "scale": [x1 - x0, region["height"], z1 - z0]}
            found = {k: [round(v, 6) for v in vs] for k, vs in found.items()}
            regions[region["id"]] = found if len(corners) == 4 else {**found, "vertices": corners}
        return {"format": "scenelang.layout/1", "scene": scene, "objects": objects, "regions": regions}


def region(name, corners, zone=False):
    found = {"id": name, "polygon": [[round(x, 3), round(z, 3)] for x, z in corners], "floor": 0, "height": HEIGHT}
    return {**found, "zone": True} if zone else found


def rectangle(x0, z0, x1, z1):
    return [(x0, z0), (x1, z0), (x1, z1), (x0, z1)]


def bounds(polygon):
    xs, zs = [p[0] for p in polygon], [p[1] for p in polygon]
    return min(xs), min(zs), max(xs), max(zs)


def sides(rng, floor):
    """Width and depth of a room of so much floor."""
    w = round(math.sqrt(floor * rng.uniform(0.8, 1.5)), 2)
    return w, round(floor / w, 2)


def cells(rng, rect, n, aisle=0.0):
    """Cuts a rectangle into n, leaving aisles between the larger parts."""
    x0, z0, x1, z1 = rect
    if n == 1:
        return [rect]
    m = max(1, min(n - 1, n // 2 + rng.choice((-1, 0, 0, 1))))
    share = m / n + rng.uniform(-0.08, 0.08) / math.sqrt(n)
    half = aisle / 2 if n > 3 else 0.0
    if x1 - x0 >= z1 - z0:
        c = x0 + (x1 - x0) * share
        return cells(rng, (x0, z0, c - half, z1), m, aisle) + cells(rng, (c + half, z0, x1, z1), n - m, aisle)
    c = z0 + (z1 - z0) * share
    return cells(rng, (x0, z0, x1, c - half), m, aisle) + cells(rng, (x0, c + half, x1, z1), n - m, aisle)


def filled(rng, cell, share, yaw):
    """A thing turned by quarters that takes up a share of a cell: width, depth, middle."""
    x0, z0, x1, z1 = cell
    u = rng.uniform(0.35, 0.65)
    ex, ez = (math.floor(v * 500) / 500 for v in ((x1 - x0) * share**u, (z1 - z0) * share ** (1 - u)))
    at = x0 + ex / 2 + rng.random() * (x1 - x0 - ex), z0 + ez / 2 + rng.random() * (z1 - z0 - ez)
    return (ex, ez, at) if yaw % 180 == 0 else (ez, ex, at)


class Packer:
    """Fills cells of rooms with rectangles turned as one likes, and lets them grow until they cover enough."""

    def __init__(self, rng, rooms, keep=()):
        self.rng, self.rooms, self.keep = rng, rooms, list(keep)
        self.things = []  # [width, depth, middle, yaw, against a wall]

    def put(self, cell, yaw, wall=False):
        x0, z0, x1, z1 = cell
        shape = self.rng.uniform(1.0, 1.9), 1.0
        turned = footprint((0, 0), *shape, yaw)
        ex, ez = max(p[0] for p in turned) * 2, max(p[1] for p in turned) * 2
        k = min((x1 - x0 - 2 * FREE) / ex, (z1 - z0 - 2 * FREE) / ez) * 0.98
        k = min(k, 1.6)
        u, v = self.rng.random(), self.rng.random()
        room_x, room_z = x1 - x0 - 2 * FREE - k * ex, z1 - z0 - 2 * FREE - k * ez
        at = [x0 + FREE + k * ex / 2 + u * room_x, z0 + FREE + k * ez / 2 + v * room_z]
        self.things.append([k * shape[0], k * shape[1], at, yaw, wall])

    def to_wall(self, cell, rect, chance):
        """The yaw of a thing with its back to a wall, if its cell is at one."""
        x0, z0, x1, z1 = cell
        at = [y for y, d in ((0, z0 - rect[1]), (90, x0 - rect[0]), (180, rect[3] - z1), (270, rect[2] - x1)) if abs(d) < 1e-6]
        return self.rng.choice(at) if at and self.rng.random() < chance else None

    def fits(self, index, w, d, at, yaw):
        corners, radius = footprint(at, w, d, yaw), math.hypot(w, d) / 2
        if max(within(room, corners) for room in self.rooms) < FREE:
            return False
        if any(apart(corners, k) < FREE for k in self.keep):
            return False
        for i, (ow, od, oat, oyaw, _) in enumerate(self.things):
            if i != index and math.dist(at, oat) < radius + math.hypot(ow, od) / 2 + FREE:
                if apart(corners, footprint(oat, ow, od, oyaw)) < FREE:
                    return False
        return True

    def settle(self, cover, floor):
        """Takes out what is in the way, then lets things grow and move a little until they cover their share."""
        ranks = [i for i, t in enumerate(self.things) if not self.fits(i, *t[:4])]
        for i in ranks:
            t = self.things[i]
            while not self.fits(i, *t[:4]) and t[0] > 0.1:
                t[0], t[1] = t[0] * 0.9, t[1] * 0.9
        self.things = [t for t in self.things if t[0] > 0.15 and t[1] > 0.15]
        for _ in range(80):
            if sum(t[0] * t[1] for t in self.things) >= cover * floor:
                break
            for i, (w, d, at, yaw, _) in enumerate(self.things):
                new = [w, d]
                axis = self.rng.randrange(2)
                new[axis] *= self.rng.uniform(1.02, 1.12)
                moved = [v + self.rng.uniform(-0.04, 0.04) for v in at]
                if new[axis] < 2.4 and max(new) < 3.2 * min(new) and self.fits(i, *new, moved, yaw):
                    self.things[i][:3] = [*new, moved]
        for t in self.things:
            t[0], t[1] = math.floor(t[0] * 100) / 100, math.floor(t[1] * 100) / 100

    def back_up(self, polygon):
        """Moves what belongs to a wall back to it, as far as it is free."""
        for i, (w, d, at, yaw, wall) in enumerate(self.things):
            if not wall:
                continue
            step = footprint((0, 0), 0, 2, yaw + 180)[2]
            for _ in range(60):
                moved = [at[0] + 0.02 * step[0], at[1] + 0.02 * step[1]]
                if not self.fits(i, w, d, moved, yaw):
                    break
                at = moved
            self.things[i][2] = at


def floor_of(regions):
    return sum(abs(area(r["polygon"])) for r in regions if not r.get("zone"))
