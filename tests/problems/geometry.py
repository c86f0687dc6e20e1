"""Geometry of upright boxes for the judge and the generator: written for them alone, in plain Python.

Frame: left-handed, y up, metres; a point of the plan is (x, z). Yaw is in degrees, clockwise seen from above: yaw 0 faces
+z, yaw 90 faces +x. `pos` is the centre of the bottom face; a size is (width, height, depth).
"""

import math


def front(yaw):
    """Where something faces, in the plan."""
    a = math.radians(yaw)
    return math.sin(a), math.cos(a)


def right(yaw):
    """Its right hand side, in the plan."""
    a = math.radians(yaw)
    return math.cos(a), -math.sin(a)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


class Box:
    """An upright box at a place."""

    def __init__(self, size, pos, yaw):
        self.size, self.pos, self.yaw = tuple(size), tuple(pos), yaw
        self.w, self.h, self.d = size
        self.at = (pos[0], pos[2])
        self.front, self.right = front(yaw), right(yaw)
        self.bottom, self.top = pos[1], pos[1] + self.h
        self.middle = (pos[0], pos[1] + self.h / 2, pos[2])
        self.radius = math.hypot(self.w, self.d) / 2
        self.corners = footprint(self.at, self.w, self.d, yaw)

    def point(self, along_right, along_front):
        """A point of the plan in the box's own frame, from its centre."""
        (rx, rz), (fx, fz) = self.right, self.front
        return self.at[0] + along_right * rx + along_front * fx, self.at[1] + along_right * rz + along_front * fz


def footprint(at, w, d, yaw):
    """Corners of a rectangle, counter-clockwise where x goes right and z goes up."""
    f, r = front(yaw), right(yaw)
    signs = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    return [(at[0] + s * w / 2 * r[0] + t * d / 2 * f[0], at[1] + s * w / 2 * r[1] + t * d / 2 * f[1]) for s, t in signs]


def edges(polygon):
    return [(polygon[i - 1], polygon[i]) for i in range(len(polygon))]


def area(polygon):
    """Signed: positive where the corners go counter-clockwise."""
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in edges(polygon)) / 2


def to_segment(p, a, b):
    """Distance of a point to a segment."""
    along, off = minus(b, a), minus(p, a)
    length = dot(along, along)
    t = max(0.0, min(1.0, dot(off, along) / length)) if length else 0.0
    return math.hypot(off[0] - t * along[0], off[1] - t * along[1])


def holds(polygon, p):
    """Whether a point is in a simple polygon (on its edge: either)."""
    inside = False
    for (ax, az), (bx, bz) in edges(polygon):
        if (az > p[1]) != (bz > p[1]) and p[0] < ax + (p[1] - az) / (bz - az) * (bx - ax):
            inside = not inside
    return inside


def depth(polygon, p):
    """Distance to the edges of a simple polygon, negative outside."""
    least = min(to_segment(p, a, b) for a, b in edges(polygon))
    return least if holds(polygon, p) else -least


def crossing(a, b, c, d):
    """Whether two segments cross in their inner points."""
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def segments_apart(a, b, c, d):
    """Distance of two segments."""
    if crossing(a, b, c, d):
        return 0.0
    return min(to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b))


def apart(p, q):
    """Signed gap of two convex polygons: their distance, or minus the least way that parts them."""
    deepest = -math.inf
    for polygon in (p, q):
        for a, b in edges(polygon):
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            if length == 0:
                continue
            normal = ((b[1] - a[1]) / length, (a[0] - b[0]) / length)
            of_p, of_q = [dot(normal, x) for x in p], [dot(normal, x) for x in q]
            deepest = max(deepest, min(of_q) - max(of_p), min(of_p) - max(of_q))
    if deepest <= 0:
        return deepest
    return min(segments_apart(a, b, c, d) for a, b in edges(p) for c, d in edges(q))


def gap(a, b):
    """Signed gap of two boxes between their surfaces."""
    flat, upright = apart(a.corners, b.corners), max(a.bottom - b.top, b.bottom - a.top)
    if flat > 0 or upright > 0:
        return math.hypot(max(flat, 0.0), max(upright, 0.0))
    return max(flat, upright)


def within(polygon, corners):
    """Clearance of a convex polygon in a simple one, negative if some of it is outside."""
    out = [-depth(polygon, c) for c in corners if not holds(polygon, c)]
    out += [depth(corners, v) for v in polygon if holds(corners, v)]
    if out and max(out) > 0:
        return -max(out)
    return min(segments_apart(a, b, c, d) for a, b in edges(polygon) for c, d in edges(corners))


def overlap(subject, convex):
    """What a convex polygon shares with another (corners of both counter-clockwise)."""
    out = list(subject)
    for a, b in edges(convex):
        def side(p):
            return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
        kept = []
        for p, q in edges(out):
            sp, sq = side(p), side(q)
            if (sp < 0) != (sq < 0):
                t = sp / (sp - sq)
                kept.append((p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])))
            if sq >= 0:
                kept.append(q)
        out = kept
        if not out:
            break
    return out


def hull(points):
    """Convex hull, counter-clockwise."""
    points = sorted(set(points))
    if len(points) < 3:
        return points
    def half(points):
        out = []
        for p in points:
            while len(out) > 1 and (out[-1][0] - out[-2][0]) * (p[1] - out[-2][1]) <= (out[-1][1] - out[-2][1]) * (p[0] - out[-2][0]):
                out.pop()
            out.append(p)
        return out[:-1]
    return half(points) + half(points[::-1])
