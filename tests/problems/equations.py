"""A family of equations: places on all axes and turns that are given from one thing to the next."""

from families import extras
from furnished import packer_of, stand
from hidden import FREE, MEAN, Hidden, rectangle, region, sides
from sampling import TURNED, sample

GRID = 0.05  # lengths in equations are as people write them (metres)


def equations(rng, n, cover):
    """Chains of three to six things, each with its place given by the one before it, some things on others, and the rest free."""
    w, d = sides(rng, n * MEAN / 0.25)
    hidden = Hidden(rng, [region("room", rectangle(0, 0, w, d))])
    packer, heads = packer_of(hidden), []
    small = max(1, n // 10)
    for k in range(max(1, round((n - small) * 0.5 / 4.5))):
        chain(hidden, packer, (w, d), k, heads)
    hosts = [i for i in hidden.boxes if hidden.boxes[i].h < 2]
    rest = extras(hidden, packer, n - small - len(hidden.boxes))
    for k, host in enumerate(rng.sample(hosts, min(small, len(hosts)))):
        top(hidden, f"top{k}", host)
    sample(hidden, max(0, 3 * n - len(hidden.counted())), {k: v for k, v in TURNED.items() if k != "inside"}, rest + heads)
    return hidden


def chain(hidden, packer, room, k, heads):
    """Three to six alike things in a line, along an axis or stepping along both."""
    rng, w, d = hidden.rng, *room
    for _ in range(500):
        size = [round(rng.uniform(*s) / GRID) * GRID for s in ((0.4, 0.9), (0.4, 1.6), (0.4, 0.8))]
        count, yaw = rng.randint(3, 6), rng.choice((0, 90, 180, 270, 30, 45))
        axis = rng.randrange(2)
        step = [0.0, 0.0]
        step[axis] = round((max(size[0], size[2]) * (1.3 if yaw % 90 else 1.05) + rng.uniform(0.05, 0.4)) / GRID) * GRID
        step[1 - axis] = rng.choice((0, 0, round(rng.uniform(-0.4, 0.4) / GRID) * GRID))
        at = [round(rng.uniform(0.3, v - 0.3) / GRID) * GRID for v in (w, d)]
        other = rng.choice(heads) if heads and rng.random() < 0.6 else None
        same = rng.randrange(2)
        if other:
            at[same] = hidden.boxes[other].at[same]
        spots = [tuple(at[i] + j * step[i] for i in (0, 1)) for j in range(count)]
        if all(packer.fits(-1, size[0], size[2], spot, yaw) for spot in spots):
            break
    else:
        return
    names = [f"line{k}[{j}]" for j in range(count)]
    for name, spot in zip(names, spots):
        stand(hidden, packer, name, size, spot, yaw, array=f"line{k}")
    for a, b in zip(names[1:], names):
        hidden.state("equal", a=a, b=b, axis="x", by=round(step[0], 2))
        hidden.state("equal", a=a, b=b, axis="z", by=round(step[1], 2))
        hidden.state("same_turn", a=a, b=b)
    if other:
        hidden.state("centred", a=names[0], b=other, axis="xz"[same])
    elif rng.random() < 0.7:
        hidden.state("fixed", a=names[0], axis="xz"[same], value=round(at[same], 2))
    heads.append(names[0])


def top(hidden, name, host):
    """A small thing on another: on its middle, or given height and a place off its middle."""
    rng, base = hidden.rng, hidden.boxes[host]
    size, off = (0.2, 0.25, 0.2), (0, 0)
    if rng.random() < 0.5:
        off = tuple(rng.choice((-0.05, 0, 0.05)) for _ in range(2))
    hidden.add(name, size, (base.pos[0] + off[0], base.top, base.pos[2] + off[1]), base.yaw)
    if off == (0, 0):
        hidden.state("on", a=name, b=host)
        for axis in "xz":
            hidden.state("centred", a=name, b=host, axis=axis)
    else:
        for axis, by in zip("xyz", (off[0], base.h, off[1])):
            hidden.state("equal", a=name, b=host, axis=axis, by=round(by, 2))
    if rng.random() < 0.5:
        hidden.state("same_turn", a=name, b=host)


EQUATIONS = {"equations": equations}
