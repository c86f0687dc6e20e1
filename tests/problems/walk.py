"""Whether a disc can move on the floor from one thing to another.

The clearance of a point (how far it is from what blocks) changes no faster than the point moves. So squares can be told
to be free, blocked, or mixed from the clearance of their centres, and mixed ones are cut in four until the answer is
sure: two things are joined by free squares alone, or not even by free and mixed ones.
"""

import math
from geometry import dot, edges, holds, minus, to_segment, depth

STEP, HEAD, NEAR = 0.05, 2.0, 0.05  # what reaches between STEP and HEAD above the floor blocks; NEAR is there (metres)
FIRST, LAST = 0.24, 0.0005  # half the side of the first and the last squares (metres)
ROOT2 = math.sqrt(2)


def walls_of(floors):
    """The outline of a union of polygons; where there is more than one, they are convex."""
    out = []
    for i, floor in enumerate(floors):
        for a, b in edges(floor):
            pieces = [(0.0, 1.0)]
            for other in floors[:i] + floors[i + 1:]:
                cut = shadow(a, b, other)
                if cut[0] >= cut[1]:
                    continue
                pieces = [p for lo, hi in pieces for p in ((lo, min(hi, cut[0])), (max(lo, cut[1]), hi)) if p[1] - p[0] > 1e-9]
            out += [tuple((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])) for t in piece) for piece in pieces]
    return out


def shadow(a, b, convex):
    """The part of a segment in a convex polygon, as an interval of its parameter (empty: (1, 0))."""
    lo, hi = 0.0, 1.0
    along, turn = minus(b, a), 1 if sum(p[0] * q[1] - p[1] * q[0] for p, q in edges(convex)) > 0 else -1
    for p, q in edges(convex):
        inward = (-(q[1] - p[1]) * turn, (q[0] - p[0]) * turn)
        start, rate = dot(minus(a, p), inward), dot(along, inward)
        if rate == 0:
            if start <= 0:
                return 1.0, 0.0
        elif rate > 0:
            lo = max(lo, -start / rate)
        else:
            hi = min(hi, -start / rate)
    return (lo, hi) if lo < hi else (1.0, 0.0)


class Floor:
    """Floors (polygons) with what blocks on them (convex polygons), for a disc of one radius."""

    def __init__(self, floors, blocks, radius, last=LAST):
        self.floors, self.radius, self.last = floors, radius, last
        self.things = [("wall", list(w)) for w in walls_of(floors)] + [("block", b) for b in blocks]
        xs, zs = [p[0] for f in floors for p in f], [p[1] for f in floors for p in f]
        self.origin = (min(xs), min(zs))
        self.count = tuple(math.ceil((max(v) - min(v)) / (2 * FIRST)) for v in (xs, zs))
        self.leaves = {}  # (level, i, j): (free, centre, half, what is near)
        every = range(len(self.things))
        for i in range(self.count[0]):
            for j in range(self.count[1]):
                self.look(0, i, j, every)

    def square(self, level, i, j):
        half = FIRST / 2**level
        return (self.origin[0] + (2 * i + 1) * half, self.origin[1] + (2 * j + 1) * half), half

    def distance(self, thing, p):
        kind, points = thing
        return to_segment(p, *points) if kind == "wall" else -depth(points, p)

    def look(self, level, i, j, near):
        """Puts a square among the leaves, unless it is blocked."""
        centre, half = self.square(level, i, j)
        found = [(self.distance(self.things[k], centre), k) for k in near]
        nearest = min(found)[0]
        clearance, reach = nearest, half * ROOT2
        if not any(holds(f, centre) for f in self.floors):
            clearance = -abs(clearance)
        if clearance < self.radius - reach:
            return
        # Whatever decides anywhere in the square is no farther than this from its centre.
        near = [k for d, k in found if d <= nearest + 2 * reach]
        self.leaves[(level, i, j)] = (clearance >= self.radius + reach, centre, half, near)

    def refine(self, keys):
        for key in keys:
            level, i, j = key
            near = self.leaves.pop(key)[3]
            for a in (0, 1):
                for b in (0, 1):
                    self.look(level + 1, 2 * i + a, 2 * j + b, near)

    def neighbours(self, key):
        """Leaves of the same or a larger size that share a side."""
        level, i, j = key
        for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            k, x, z = level, i + a, j + b
            while k >= 0:
                if (k, x, z) in self.leaves:
                    yield (k, x, z)
                    break
                k, x, z = k - 1, x >> 1, z >> 1

    def parts(self, mixed):
        """The number of the connected part that each leaf belongs to."""
        parent = {}
        def top(k):
            while parent[k] != k:
                parent[k] = parent[parent[k]]
                k = parent[k]
            return k
        for key, leaf in self.leaves.items():
            if leaf[0] or mixed:
                parent[key] = key
        for key in list(parent):
            for other in self.neighbours(key):
                if other in parent:
                    parent[top(key)] = top(other)
        return {key: top(key) for key in parent}

    def joined(self, a, b, slack=0.0):
        """Whether the disc can move from within NEAR of one footprint to within NEAR of the other."""
        reach = self.radius + NEAR + slack
        while True:
            sure = self.parts(False)
            def touched(parts, corners, spare):
                found, middle = set(), [sum(v) / len(corners) for v in zip(*corners)]
                far = reach + max(math.dist(middle, c) for c in corners)
                for key, part in parts.items():
                    _, centre, half, _ = self.leaves[key]
                    if math.dist(centre, middle) > far + half * ROOT2:
                        continue
                    if -depth(corners, centre) <= reach + spare * half * ROOT2:
                        found.add(part)
                return found
            if touched(sure, a, 0) & touched(sure, b, 0):
                return True
            perhaps = self.parts(True)
            common = touched(perhaps, a, 1) & touched(perhaps, b, 1)
            # Only what might join the two is worth a closer look.
            mixed = [k for k, part in perhaps.items() if part in common and not self.leaves[k][0]]
            mixed = [k for k in mixed if self.leaves[k][2] > self.last]
            if not mixed:
                return False
            self.refine(mixed)
