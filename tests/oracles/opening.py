"""Opens every door, drawer and lid of some layouts, and holds what was claimed of them against what it met.

usage: opening.py CASES.json

CASES is a list. Each case is a layout and what was claimed of its joints:
  {"layout": "000.layout.json", "eta": wall thickness, "contact": depth up to which solids only touch, "slack": how far a
   door may be from its wall, "doors": [names], "claims": [{"object", "joint", "free": degrees or metres, "opens": whether
   it opens as far as is useful, "walls": which region's walls count or null, "ignored": [names that are not in the way]}]}
Two judges look at each joint, and neither shares code with what claimed:
  MuJoCo is driven along the joint until the first contact; the claimed free range must not be wider, and at most 1° or
  5 mm narrower;
  a sweep in numpy looks at poses 0.1° or 0.5 mm apart with separating axes; where the least gap is 2 mm or more away from
  what decides, the verdict must be the same.
Prints one JSON object. Exit 0: all claims hold; 1: some do not; 2: cannot judge.
"""
import itertools
import json
import os
import sys

import mujoco
import numpy as np

from physics import CYLINDER_SIDES as SIDES, turn

NARROWER = {"hinge": 1.0, "slide": 0.005}
STEP = {"hinge": 0.1, "slide": 5e-4}  # of the sweep
DRIVE = {"hinge": 0.05, "slide": 2e-4}  # of the engine, before it is refined
REFINED = 24  # halvings of a step
BAND = 0.002
ROUNDING = 1e-6  # of numbers in double precision, degrees or metres
# Contacts of the engine, of meshes in single precision, are known to this.
SINGLE = {"hinge": 0.01, "slide": 1e-5}
NEAR = 0.02  # what is near the limit, for the statistics
SLAB = 0.4  # metres; walls have no thickness in the rule, and get one on the outside here
MOST = 2000  # poses looked at in one step of the sweep, times axes


def euler(rot):
    return turn("y", rot[1]) @ turn("z", rot[2]) @ turn("x", rot[0])


class Solid:
    """A convex solid: its corners, the normals of its faces and the directions of its edges."""

    def __init__(self, points, normals, edges):
        self.points, self.normals, self.edges = (np.array(a, float) for a in (points, normals, edges))
        self.center = self.points.mean(axis=0)
        self.radius = np.linalg.norm(self.points - self.center, axis=1).max()

    def moved(self, matrix, by):
        return Solid(self.points @ matrix.T + by, self.normals @ matrix.T, self.edges @ matrix.T)


def box(size):
    corners = np.array(list(itertools.product((-0.5, 0.5), repeat=3))) * size
    return Solid(corners, np.eye(3), np.eye(3))


def prism(radius, height):
    angles = np.arange(SIDES) * 2 * np.pi / SIDES
    ring = np.stack([radius * np.cos(angles), np.zeros(SIDES), radius * np.sin(angles)], axis=1)
    up = np.array([0, 1.0, 0])
    points = np.concatenate([ring - up * height / 2, ring + up * height / 2])
    middles = ring + np.roll(ring, -1, axis=0)
    half = middles[: SIDES // 2]
    sides = half / np.linalg.norm(half, axis=1, keepdims=True)
    return Solid(points, np.vstack([sides, up]), np.vstack([np.cross(sides, up), up]))


def hull(points):
    """Faces of a hull, found by trying every plane through three of its points."""
    points = np.unique(np.round(np.array(points, float), 9), axis=0)
    normals = []
    for i, j, k in itertools.combinations(range(len(points)), 3):
        normal = np.cross(points[j] - points[i], points[k] - points[i])
        length = np.linalg.norm(normal)
        if length < 1e-12:
            continue
        heights = (points - points[i]) @ (normal / length)
        if heights.max() < 1e-9 or heights.min() > -1e-9:
            normal = normal / length * (1 if heights.max() < 1e-9 else -1)
            if not any(normal @ known > 1 - 1e-12 for known in normals):
                normals.append(normal)
    edges = []
    for a, b in itertools.combinations(normals, 2):
        edge = np.cross(a, b)
        tops = [points @ n >= (points @ n).max() - 1e-9 for n in (a, b)]
        if np.linalg.norm(edge) > 1e-9 and (tops[0] & tops[1]).sum() >= 2:
            edge = edge / np.linalg.norm(edge)
            if not any(abs(edge @ known) > 1 - 1e-12 for known in edges):
                edges.append(edge)
    return Solid(points, normals, edges)


def solids(thing):
    """The parts of an object, in the world."""
    matrix, pos = euler(thing.get("rot", [0, 0, 0])), np.array(thing["pos"], float)
    w, h, d = thing["scale"]
    whole = [{"shape": "box", "pos": [0, h / 2, 0], "size": [w, h, d]}]
    found = []
    for part in (thing.get("asset") or {}).get("parts") or whole:
        if part["shape"] == "hull":
            own = hull(part["points"])
        else:
            own = box(part["size"]) if part["shape"] == "box" else prism(part["radius"], part["height"])
            own = own.moved(euler(part.get("rot", [0, 0, 0])), np.array(part["pos"], float))
        found.append(own.moved(matrix, pos))
    return found, matrix, pos


def outline(region):
    """Corners of the floor of a region, and which way it runs: 1 where the inside is to the left in (x, z)."""
    if region.get("vertices"):
        corners = np.array(region["vertices"], float)
    else:
        w, _, d = region["scale"]
        around = [[-w / 2, -d / 2], [w / 2, -d / 2], [w / 2, d / 2], [-w / 2, d / 2]]
        turned = euler(region.get("rot", [0, 0, 0])) @ np.array([[x, 0, z] for x, z in around]).T
        corners = turned.T[:, [0, 2]] + [region["pos"][0], region["pos"][2]]
    x, z = corners.T
    return corners, np.sign(np.sum(x * np.roll(z, -1) - np.roll(x, -1) * z))


def without(a, b, door, reach):
    """The pieces of a wall from a to b that are not in the opening of a door."""
    if door is None:
        return [(a, b)]
    matrix, pos, (w, _, d) = door
    local = lambda p: (matrix.T @ (np.array([p[0], 0, p[1]]) - pos))[[0, 2]]
    (p, q), half = (local(a), local(b)), np.array([w / 2, d / 2 + reach])
    enter, leave = 0.0, 1.0
    for k in range(2):
        step = q[k] - p[k]
        if abs(step) < 1e-12:
            if abs(p[k]) >= half[k]:
                return [(a, b)]
            continue
        ends = sorted(((-half[k] - p[k]) / step, (half[k] - p[k]) / step))
        enter, leave = max(enter, ends[0]), min(leave, ends[1])
    if enter >= leave:
        return [(a, b)]
    pieces = [(a, a + (b - a) * enter), (a + (b - a) * leave, b)]
    return [(s, t) for s, t in pieces if np.linalg.norm(t - s) > 1e-6]


def walls(region, door, reach):
    """Slabs along the outside of a region, very high."""
    corners, way = outline(region)
    found = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        for s, t in without(a, b, door, reach):
            length = np.linalg.norm(t - s)
            along = (t - s) / length
            outside = np.array([along[1], -along[0]]) * way
            middle = (s + t) / 2 + outside * SLAB / 2
            axes = np.array([[along[0], 0, outside[0]], [0, 1, 0], [along[1], 0, outside[1]]])
            found.append(box([length, 20, SLAB]).moved(axes, np.array([middle[0], 0, middle[1]])))
    return found


class Joint:
    """What moves, in the world."""

    def __init__(self, told, parts, matrix, pos):
        self.hinge = told["motion"] == "hinge"
        self.kind, self.limit, self.useful = told["motion"], told["limits"][1], told["useful"]
        self.axis = matrix @ np.array(told["axis"], float)
        self.axis /= np.linalg.norm(self.axis)
        self.anchor = matrix @ np.array(told["anchor"], float) + pos
        self.bodies = [parts[i] for i in told["parts"]]

    def turned(self, vectors, amounts, free):
        """Points (or free vectors) at many amounts: an array by amount, point and coordinate."""
        amounts = np.asarray(amounts)[:, None, None]
        if not self.hinge:
            moved = np.broadcast_to(vectors[None], (len(amounts), *vectors.shape))
            return moved if free else moved + amounts * self.axis
        arm = vectors[None] - (0 if free else self.anchor)
        angle = np.radians(amounts)
        along = (arm @ self.axis)[..., None] * self.axis
        moved = arm * np.cos(angle) + np.cross(self.axis, arm) * np.sin(angle) + along * (1 - np.cos(angle))
        return moved + (0 if free else self.anchor)


def gaps(joint, body, solid, amounts):
    """The widest separation of two solids over all separating axes, at each amount; less than 0 is a depth."""
    points = joint.turned(body.points, amounts, False)
    own = joint.turned(body.normals, amounts, True)
    count = len(amounts)
    best = np.full(count, -np.inf)

    def look(axes):
        """Axes by amount; those without a length are passed over."""
        nonlocal best
        length = np.linalg.norm(axes, axis=2, keepdims=True)
        unit = axes / np.where(length < 1e-9, 1, length)
        a, b = np.einsum("kpc,kac->kap", points, unit), np.einsum("pc,kac->kap", solid.points, unit)
        apart = np.maximum(b.min(axis=2) - a.max(axis=2), a.min(axis=2) - b.max(axis=2))
        apart = np.where(length[..., 0] < 1e-9, -np.inf, apart)
        best = np.maximum(best, apart.max(axis=1))

    look(own)
    look(np.broadcast_to(solid.normals[None], (count, *solid.normals.shape)))
    edges = joint.turned(body.edges, amounts, True)
    for edge in solid.edges:
        look(np.cross(edges, edge))
    return best


def refined(free, met, meets):
    """The last amount before something is met, between one at which nothing is and one at which something is."""
    free = max(free, 0.0)
    for _ in range(REFINED):
        middle = (free + met) / 2
        free, met = (free, middle) if meets(middle) else (middle, met)
    return met


def sweep(joint, solids_, contact):
    """The least gap up to the useful amount, and the first amount at which solids are deeper than contact."""
    step = STEP[joint.kind]
    amounts = np.linspace(0, joint.limit, int(np.ceil(joint.limit / step)) + 1)
    amounts = np.union1d(amounts, [joint.useful])
    least, first = np.inf, np.inf
    for body in joint.bodies:
        centers = joint.turned(body.center[None], amounts, False)[:, 0]
        for solid in solids_:
            # Boxes and not balls, since walls are long.
            low, high = solid.points.min(axis=0) - body.radius - 0.05, solid.points.max(axis=0) + body.radius + 0.05
            near = ((centers > low) & (centers < high)).all(axis=1)
            if not near.any():
                continue
            some = amounts[near]
            found = np.concatenate([gaps(joint, body, solid, part) for part in np.array_split(some, len(some) // MOST + 1)])
            asked = found[some <= joint.useful]
            least = min(least, asked.min(initial=np.inf))
            deep = some[found < -contact].min(initial=np.inf)
            if deep < first:
                first = refined(deep - step, deep, lambda at: gaps(joint, body, solid, np.array([at]))[0] < -contact)
    return least, first


def engine(joint, solids_):
    """A model of what moves, on its joint, and of what it may meet; the frame is that of the layout, about the joint: meshes
    are kept in single precision."""
    spec = mujoco.MjSpec()
    spec.option.gravity = [0, 0, 0]
    spec.option.ccd_tolerance, spec.option.ccd_iterations = 1e-10, 200
    for index, solid in enumerate(solids_):
        spec.add_mesh(name=f"s{index}", uservert=(solid.points - joint.anchor).ravel())
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"s{index}", contype=0, conaffinity=1)
    body = spec.worldbody.add_body(name="moving")
    kind = mujoco.mjtJoint.mjJNT_HINGE if joint.hinge else mujoco.mjtJoint.mjJNT_SLIDE
    body.add_joint(name="joint", type=kind, axis=joint.axis, pos=[0, 0, 0])
    for index, solid in enumerate(joint.bodies):
        spec.add_mesh(name=f"m{index}", uservert=(solid.points - joint.anchor).ravel())
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"m{index}", contype=1, conaffinity=0)
    model = spec.compile()
    return model, mujoco.MjData(model)


def drive(joint, solids_, contact):
    """How far the engine opens it before something is deeper than contact; infinity where nothing is up to the limit."""
    if not solids_:
        return np.inf
    model, data = engine(joint, solids_)

    def meets(amount):
        data.qpos[0] = np.radians(amount) if joint.hinge else amount
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_collision(model, data)
        return data.ncon > 0 and data.contact.dist.min() < -contact

    if meets(0.0):
        return 0.0
    count = int(np.ceil(joint.limit / DRIVE[joint.kind]))
    before = 0.0
    for at in np.linspace(0, joint.limit, count + 1)[1:]:
        if meets(at):
            return refined(before, at, meets)
        before = at
    return np.inf


def near(joint, solids_):
    """Those whose box the motion may come into."""
    amounts = np.linspace(0, joint.limit, 200)
    points = np.concatenate([joint.turned(body.points, amounts, False).reshape(-1, 3) for body in joint.bodies])
    low, high = points.min(axis=0) - 0.05, points.max(axis=0) + 0.05
    return [s for s in solids_ if (s.points.max(axis=0) > low).all() and (s.points.min(axis=0) < high).all()]


def judge(case, folder, total):
    with open(os.path.join(folder, case["layout"]), encoding="utf-8") as file:
        layout = json.load(file)
    things = {name: solids(thing) for name, thing in layout["objects"].items()}
    for claim in case["claims"]:
        name, contact = claim["object"], case["contact"]
        told = next(j for j in layout["objects"][name]["asset"]["joints"] if j["name"] == claim["joint"])
        joint = Joint(told, *things[name])
        others = [s for other, (found, *_) in things.items() if other != name and other not in claim["ignored"] for s in found]
        if claim["walls"] is not None:
            door = (*things[name][1:], layout["objects"][name]["scale"]) if name in case["doors"] else None
            others += walls(layout["regions"][claim["walls"]], door, 2 * case["eta"] + case["slack"])
        others = near(joint, others)
        least, first = sweep(joint, others, contact)
        driven = min(drive(joint, others, contact), joint.limit)
        where = f"{case['layout']} {name}/{claim['joint']}"
        wrong = []
        wider = claim["free"] - driven
        unit = "°" if joint.hinge else " m"
        if wider > SINGLE[joint.kind]:
            wrong.append(f"{where}: {claim['free']:.5f}{unit} claimed, MuJoCo comes {driven:.5f}{unit}")
        if -wider > NARROWER[joint.kind]:
            wrong.append(f"{where}: only {claim['free']:.5f}{unit} claimed, MuJoCo comes {driven:.5f}{unit}")
        missed = claim["opens"] and driven < joint.useful - SINGLE[joint.kind]
        if missed:
            wrong.append(f"{where}: said to open {joint.useful}{unit}, MuJoCo comes {driven:.5f}{unit}")
        margin = least + contact
        if abs(margin) > BAND and claim["opens"] != bool(margin > 0):
            wrong.append(f"{where}: said to open: {claim['opens']}; the least of sampled gaps is {least:.5f} m")
        if claim["free"] > min(first, joint.limit) + ROUNDING:
            wrong.append(f"{where}: {claim['free']:.5f}{unit} claimed, deeper than contact at {first:.5f}{unit}")
        total["wrong"] += wrong
        total["joints"] += 1
        total["blocked"] += int(not claim["opens"])
        total["met"] += int(driven < joint.limit)
        total["near"] += int(abs(least) <= NEAR)
        total["decided"] += int(abs(margin) > BAND)
        total["missed"] += int(missed)
        total["widest"][joint.kind] = max(total["widest"][joint.kind], float(wider))
        total["narrowest"][joint.kind] = max(total["narrowest"][joint.kind], float(-wider))


def main():
    (path,) = sys.argv[1:]
    ends = lambda: {"hinge": -1e300, "slide": -1e300}
    total = {"cases": 0, "joints": 0, "blocked": 0, "met": 0, "near": 0, "decided": 0, "missed": 0,
             "widest": ends(), "narrowest": ends(), "wrong": []}
    try:
        with open(path, encoding="utf-8") as file:
            cases = json.load(file)
        for case in cases:
            judge(case, os.path.dirname(path), total)
            total["cases"] += 1
    except Exception as problem:  # whatever it is, the verdict is: cannot judge
        print(f"cannot judge: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    print(json.dumps(total))
    return 1 if total["wrong"] or not total["joints"] else 0


if __name__ == "__main__":
    sys.exit(main())
