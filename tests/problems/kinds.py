"""The kinds of constraints of a problem: what each means, as a number, and how it is written as a program.

A meaning is a signed margin, negative where the constraint fails, in metres (degrees where `DEGREES` says so). It was
written from the language's book, not from the code of the verifier or of the solver.
"""

import math
from geometry import apart, depth, dot, edges, footprint, front, gap, minus, to_segment, within
from walk import Floor

WALL = 0.03  # thickness of the walls of a room
STEP = 0.05  # lower than this above something's base, nothing is in the way before it
MEANS, WRITES = {}, {}
DEGREES = {"heading", "turned", "parallel", "yaw", "same_turn", "looks"}


class Place:
    """A layout with the facts of its problem, so that constraints can be measured."""

    def __init__(self, facts, boxes):
        self.facts, self.boxes = facts, boxes
        self.regions = {r["id"]: r for r in facts["regions"]}
        self.doors = [c["a"] for c in facts["constraints"] if c["kind"] == "connects"]
        self.walked = {}  # floors that were looked at: what one way found out of them the next one need not

    def rooms(self):
        return [r for r in self.facts["regions"] if not r.get("zone")]

    def obstacles(self):
        """Footprints of what blocks the way of someone on the floor."""
        standing = ((i, b) for i, b in self.boxes.items() if i not in self.doors)
        return [b.corners for _, b in standing if b.bottom < 2.0 and b.top > STEP]

    def floor(self, width):
        """The floor for someone of a width."""
        key = (width, tuple((i, b.pos, b.yaw) for i, b in self.boxes.items()))
        if key not in self.walked:
            self.walked[key] = Floor(self.floors(), self.obstacles(), width / 2)
        return self.walked[key]

    def floors(self):
        through = [self.boxes[d] for d in self.doors]
        return [r["polygon"] for r in self.rooms()] + [footprint(b.at, b.w, b.d + 2 * (2 * WALL + 0.01), b.yaw) for b in through]


def margin(constraint, place):
    """By how much a constraint holds."""
    return MEANS[constraint["kind"]](place, constraint)


def sentence(constraint):
    """A constraint as a formula of the language."""
    return WRITES[constraint["kind"]](constraint)


def number(value):
    return f"{value:.6g}"


def kind(name, text):
    """Adds a kind: its meaning is the function, its formula a text with the members of the constraint."""
    def add(meaning):
        MEANS[name] = meaning
        WRITES[name] = text if callable(text) else lambda c: text.format(**{k: number(v) if isinstance(v, float | int) else v for k, v in c.items()})
        return meaning
    return add


def compared(op, left, value):
    return value - left if op == "<=" else left - value


def pair(place, c):
    return place.boxes[c["a"]], place.boxes[c["b"]]


def between_angles(a, b):
    return abs((a - b + 180) % 360 - 180)


@kind("order", "{a}.pos.{axis} + {by} <= {b}.pos.{axis}")
def _(place, c):
    a, b = pair(place, c)
    i = "xyz".index(c["axis"])
    return b.pos[i] - a.pos[i] - c["by"]


@kind("bound", "{a}.pos.{axis} {op} {value}")
def _(place, c):
    return compared(c["op"], place.boxes[c["a"]].pos["xyz".index(c["axis"])], c["value"])


@kind("inline", "abs({a}.pos.{axis} - {b}.pos.{axis}) <= {value}")
def _(place, c):
    a, b = pair(place, c)
    i = "xyz".index(c["axis"])
    return c["value"] - abs(a.pos[i] - b.pos[i])


@kind("fixed", "{a}.pos.{axis} = {value}")
def _(place, c):
    return -abs(place.boxes[c["a"]].pos["xyz".index(c["axis"])] - c["value"])


def equation(c):
    """One place by another, as one writes it: nothing is added where nothing is between them."""
    off = "" if not c["by"] else f" {'+' if c['by'] > 0 else '-'} {number(abs(c['by']))}"
    return f"{c['a']}.pos.{c['axis']} = {c['b']}.pos.{c['axis']}{off}"


@kind("equal", equation)
def _(place, c):
    a, b = pair(place, c)
    i = "xyz".index(c["axis"])
    return -abs(a.pos[i] - b.pos[i] - c["by"])


@kind("centred", "{a}.center.{axis} = {b}.center.{axis}")
def _(place, c):
    a, b = pair(place, c)
    i = "xyz".index(c["axis"])
    return -abs(a.middle[i] - b.middle[i])


@kind("same_turn", "{a}.rot = {b}.rot")
def _(place, c):
    return -between_angles(*(b.yaw for b in pair(place, c)))


@kind("distance", "distance({a}, {b}) {op} {value}")
def _(place, c):
    a, b = pair(place, c)
    return compared(c["op"], math.dist(a.middle, b.middle), c["value"])


@kind("gap", "gap({a}, {b}) {op} {value}")
def _(place, c):
    return compared(c["op"], gap(*pair(place, c)), c["value"])


@kind("inside", "inside({a}, {region})")
def _(place, c):
    a, region = place.boxes[c["a"]], place.regions[c["region"]]
    upright = min(a.bottom - region["floor"], region["floor"] + region["height"] - a.top)
    return min(within(region["polygon"], a.corners), upright)


@kind("floor", "onFloor({a}, {region})")
def _(place, c):
    a, region = place.boxes[c["a"]], place.regions[c["region"]]
    return min(0.005 - abs(a.bottom - region["floor"]), within(region["polygon"], a.corners))


@kind("yaw", lambda c: " or ".join(f"{c['a']}.rot = rot(0, {number(y)}, 0)" for y in c["yaws"]))
def _(place, c):
    return -min(between_angles(place.boxes[c["a"]].yaw, y) for y in c["yaws"])


def cone(a, b, along, across, half, side):
    """How far the centre of a is beyond a face of b, in the zone that widens by 45 degrees."""
    off = minus(a.at, b.at)
    return dot(off, along) - half - max(0.0, abs(dot(off, across)) - side / 2)


@kind("left_of", "leftOf({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    return cone(a, b, (-b.right[0], -b.right[1]), b.front, b.w / 2, b.d)


@kind("right_of", "rightOf({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    return cone(a, b, b.right, b.front, b.w / 2, b.d)


@kind("in_front_of", "inFrontOf({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    return cone(a, b, b.front, b.right, b.d / 2, b.w)


@kind("behind", "behind({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    return cone(a, b, (-b.front[0], -b.front[1]), b.right, b.d / 2, b.w)


@kind("beside", "beside({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    side = max(cone(a, b, b.right, b.front, b.w / 2, b.d), cone(a, b, (-b.right[0], -b.right[1]), b.front, b.w / 2, b.d))
    return min(side, 0.5 - gap(a, b))


@kind("between", "between({a}, {b}, {c})")
def _(place, c):
    a, b, other = (place.boxes[c[k]].middle for k in "abc")
    return 1.1 * math.dist(b, other) - math.dist(a, b) - math.dist(a, other)


@kind("facing", "facing({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    off = minus(b.at, a.at)
    return dot(off, a.front) - 0.8660254 * math.hypot(*off)


@kind("looks", "angle({a}.front, vec3({b}.center.x - {a}.center.x, 0, {b}.center.z - {a}.center.z)) <= {value}")
def _(place, c):
    a, b = pair(place, c)
    return c["value"] - between_angles(a.yaw, math.degrees(math.atan2(*minus(b.at, a.at))))


@kind("aligned", "aligned({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    off = minus(a.at, b.at)
    return 0.05 - min(abs(dot(off, b.right)), abs(dot(off, b.front)))


@kind("parallel", "parallel({a}, {b})")
def _(place, c):
    turned = between_angles(*(b.yaw for b in pair(place, c)))
    return 5 - min(turned, 180 - turned)


@kind("turned", "angle({a}.front, {b}.front) {op} {value}")
def _(place, c):
    return compared(c["op"], between_angles(*(b.yaw for b in pair(place, c))), c["value"])


@kind("heading", lambda c: "angle({}.front, vec3({:.6f}, 0, {:.6f})) <= {}".format(c["a"], *front(c["yaw"]), number(c["value"])))
def _(place, c):
    return c["value"] - between_angles(place.boxes[c["a"]].yaw, c["yaw"])


def behind_back(a, polygon, step):
    """How far a step back from both ends and the middle of the back of a leads out of a room."""
    points = (a.point(u, -a.d / 2 - step) for u in (-a.w / 2, 0, a.w / 2))
    return -max(depth(polygon, p) for p in points)


@kind("against_wall", "againstWall({a}, {region})")
def _(place, c):
    a, polygon = place.boxes[c["a"]], place.regions[c["region"]]["polygon"]
    return min(within(polygon, a.corners), behind_back(a, polygon, 0.05))


@kind("in_corner", "inCorner({a}, {region})")
def _(place, c):
    a, polygon = place.boxes[c["a"]], place.regions[c["region"]]["polygon"]
    back = -depth(polygon, a.point(0, -a.d / 2 - 0.15))
    sides = max(-depth(polygon, a.point(s * (a.w / 2 + 0.15), 0)) for s in (-1, 1))
    return min(within(polygon, a.corners), back, sides)


@kind("on", "on({a}, {b})")
def _(place, c):
    a, b = pair(place, c)
    off = minus(a.at, b.at)
    return min(0.005 - abs(a.bottom - b.top), b.w / 2 - abs(dot(off, b.right)), b.d / 2 - abs(dot(off, b.front)))


@kind("around", lambda c: f"around({c['set']}, {c['b']}, {number(c['value'])})")
def _(place, c):
    b, things = place.boxes[c["b"]], [place.boxes[a] for a in c["a"]]
    found = [c["value"] - gap(a, b) for a in things]
    for axis, half in ((b.right, b.w / 2), (b.front, b.d / 2)):
        along = [dot(minus(a.at, b.at), axis) for a in things]
        found += [half - min(along), max(along) + half]
    return min(found)


@kind("connects", lambda c: f"connects({c['a']}, {', '.join(c['regions'])})")
def _(place, c):
    door, regions = place.boxes[c["a"]], [place.regions[r] for r in c["regions"]]
    points = [door.at, door.point(-door.w / 2, 0), door.point(door.w / 2, 0)]
    off = max(min(to_segment(p, *e) for e in edges(r["polygon"])) for r in regions for p in points)
    low, high = max(r["floor"] for r in regions), min(r["floor"] + r["height"] for r in regions)
    return min(2 * WALL - off, door.bottom - low, high - door.top) + 0.01


@kind("clear", "clear({a}, {side}, {value})")
def _(place, c):
    a, depth_ = place.boxes[c["a"]], c["value"]
    sign = 1 if c["side"] == "front" else -1
    space = footprint(a.point(0, sign * (a.d / 2 + depth_ / 2)), a.w, depth_, a.yaw)
    low, high = a.bottom + STEP, a.top
    least = math.inf
    for name, b in place.boxes.items():
        if name == c["a"]:
            continue
        flat, upright = apart(space, b.corners), max(low - b.top, b.bottom - high)
        least = min(least, max(flat, upright))
    if c["a"] in place.doors:
        # The first step is still in the wall.
        wall = 2 * WALL + 0.01
        beyond = a.point(0, sign * (a.d / 2 + wall))
        space = footprint(a.point(0, sign * (a.d / 2 + (wall + depth_) / 2)), a.w, depth_ - wall, a.yaw)
        rooms = [r for r in place.rooms() if depth(r["polygon"], beyond) >= -0.001]
    else:
        fit = {r["id"]: within(r["polygon"], a.corners) for r in place.facts["regions"]}
        rooms = [max(place.facts["regions"], key=lambda r: (min(fit[r["id"]] + 0.001, 0), fit[r["id"]]))]
    return min(least, max((within(r["polygon"], space) for r in rooms), default=math.inf))


@kind("reachable", "reachable({a}, {b}, {value})")
def _(place, c):
    """No length is to be had: 1 where there is a way, -1 where there is none. A way may be 4 mm narrower than asked for."""
    a, b = pair(place, c)
    floor = place.floor(c["value"] - 0.004)
    return 1.0 if floor.joined(a.corners, b.corners, 0.002) else -1.0
