"""What the families of furnished rooms share: a frame to lay things out in, doors, and ways that must be free."""

from geometry import footprint, front, right
from hidden import FREE, Packer
from kinds import WALL
from walk import Floor

EVERY = "each"  # ways to each thing, not only to one of a group
SPARE = 0.03  # a way of the hidden layout is so much wider than asked for (metres)


class Frame:
    """A frame of the plan: u along its right, v along its front."""

    def __init__(self, at, yaw):
        self.at, self.yaw = at, yaw
        self.right, self.front = right(yaw), front(yaw)

    def point(self, u, v):
        (rx, rz), (fx, fz) = self.right, self.front
        return self.at[0] + u * rx + v * fx, self.at[1] + u * rz + v * fz

    def rectangle(self, u, v, w, d):
        """The footprint of w by d about a point."""
        return footprint(self.point(u, v), w, d, self.yaw)


def turned_room(rng, w, d):
    """Sides of a room of w by d in a frame that is turned by quarters, and that frame at its middle."""
    yaw = rng.choice((0, 90, 180, 270))
    x, z = (w, d) if yaw % 180 == 0 else (d, w)
    x, z = round(x, 2), round(z, 2)
    return (x, z), Frame((x / 2, z / 2), yaw)


def stand(hidden, packer, name, size, at, yaw, array=None, room="room"):
    """Puts a thing on the floor, and where nothing else may be put."""
    hidden.add(name, size, (at[0], 0, at[1]), yaw, array=array)
    hidden.floor(name, room)
    packer.things.append([size[0], size[2], at, yaw, False])


def packer_of(hidden):
    return Packer(hidden.rng, [r["polygon"] for r in hidden.place.rooms()])


def in_wall(rect, side, share):
    """The middle of a door in a side (0 south, 1 west, 2 north, 3 east) of a room, and the yaw that looks into the room."""
    x0, z0, x1, z1 = rect
    u = 0.7 + share * ((x1 - x0 if side % 2 == 0 else z1 - z0) - 1.4)
    at = {0: (x0 + u, z0 - WALL), 1: (x0 - WALL, z0 + u), 2: (x0 + u, z1 + WALL), 3: (x1 + WALL, z0 + u)}[side]
    return at, 90 * side


def door(hidden, name, at, yaw, regions, wide=0.9):
    hidden.add(name, (wide, 2.05, 0.06), (at[0], 0, at[1]), yaw)
    hidden.state("connects", a=name, regions=regions)
    hidden.state("fixed", a=name, axis="y", value=0)


def before(at, yaw, wide, deep):
    """The floor before a door."""
    return Frame(at, yaw).rectangle(0, deep / 2, wide, deep)


def ways(hidden, start, ends, width):
    """States that each of the ends can be reached from the start; whether the hidden layout lets one."""
    floor = Floor(hidden.place.floors(), hidden.place.obstacles(), (width + SPARE) / 2, last=0.008)
    for end in ends:
        if not floor.joined(hidden.boxes[start].corners, hidden.boxes[end].corners, -0.005):
            return False
        hidden.state("reachable", a=start, b=end, value=width)
    return True


def in_row(hidden, names, near=0.1, back_to=None):
    """States that things stand side by side, each at the right of the one before it."""
    for a, b in zip(names[1:], names):
        hidden.state("right_of", a=a, b=b)
        hidden.state("gap", a=a, b=b, op="<=", value=near)
        hidden.state("aligned", a=a, b=b)
        hidden.state("parallel", a=a, b=b)


def along_walls(hidden, packer, rect, count, prefix, room="room", sizes=((0.4, 1.4), (0.3, 0.6)), heights=(0.4, 2.0)):
    """Things with their backs to the walls of a room; their names."""
    rng, names = hidden.rng, []
    x0, z0, x1, z1 = rect
    for _ in range(1500):
        if len(names) >= count:
            break
        w, d = (round(rng.uniform(*s), 2) for s in sizes)
        side, share, back = rng.randrange(4), rng.random(), d / 2 + FREE + 0.004
        along = (x1 - x0 if side % 2 == 0 else z1 - z0) - w - 2 * FREE - 0.004
        if along <= 0:
            continue
        u = w / 2 + FREE + 0.002 + share * along
        at = {0: (x0 + u, z0 + back), 1: (x0 + back, z0 + u), 2: (x0 + u, z1 - back), 3: (x1 - back, z0 + u)}[side]
        if packer.fits(-1, w, d, at, 90 * side):
            name = f"{prefix}{len(names)}"
            stand(hidden, packer, name, (w, round(rng.uniform(*heights), 2), d), at, 90 * side, room=room)
            names.append(name)
    return names
