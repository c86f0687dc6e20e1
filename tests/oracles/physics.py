"""Judges layouts with the physics engine MuJoCo: nothing overlaps, and everything stays where it was put.

usage: physics.py LAYOUT.json FACTS.json [LAYOUT.json FACTS.json …] [--seconds 2]

LAYOUT is a scenelang layout. FACTS says what the program behind it states, which a layout does not record:
  {"held": ["door", …],            hung on a wall or a ceiling, set in a wall, or floating by permission
   "overlap": [["rug", "bed"], …]} pairs that may share space; those that do not are solid for each other
Frames: the layout is left-handed with y up, MuJoCo right-handed with z up; y and z change places, so a point
(x, y, z) becomes (x, z, y) and a rotation R becomes S R S with S the exchange of the two axes.
Prints a line of JSON for each layout. Exit 0: all are sound; 1: an overlap above 2 mm or a move above 2 cm; 2: cannot judge.
"""
import argparse
import json
import sys

import mujoco
import numpy as np

OVERLAP = 0.002  # metres two solids may share
TOUCH = 0.0005  # metres two solids share that only touch
DRIFT = 0.02  # metres a body may move while it settles
SWAP = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])
CYLINDER_SIDES = 24  # a cylinder part is this regular prism, a vertex on +x


def turn(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    rows = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return np.array(rows[axis], float)


def orientation(euler):
    """Quaternion (w, x, y, z) in MuJoCo's frame of an Euler triple: about x, then z, then y, fixed axes."""
    x, y, z = euler
    matrix = SWAP @ turn("y", y) @ turn("z", z) @ turn("x", x) @ SWAP
    quaternion = np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, np.ascontiguousarray(matrix).ravel())
    return quaternion


def point(p):
    return SWAP @ np.array(p, float)


def convex_points(part):
    """Corners of a part that is no box, in the frame of its object."""
    if part["shape"] == "hull":
        return [point(p) for p in part["points"]]
    matrix = turn("y", part.get("rot", [0, 0, 0])[1]) @ turn("z", part.get("rot", [0, 0, 0])[2])
    matrix = matrix @ turn("x", part.get("rot", [0, 0, 0])[0])
    half, radius, at = part["height"] / 2, part["radius"], np.array(part["pos"], float)
    angles = np.arange(CYLINDER_SIDES) * 2 * np.pi / CYLINDER_SIDES
    ring = [(radius * np.cos(a), radius * np.sin(a)) for a in angles]
    return [point(at + matrix @ np.array([x, y, z])) for x, z in ring for y in (-half, half)]


def build(layout, held, overlap):
    spec = mujoco.MjSpec()
    spec.option.timestep = 0.002
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10
    # Stiff contacts: a body at rest must not sink by what we measure.
    stiff = dict(solref=[0.005, 1], solimp=[0.95, 0.99, 0.0005, 0.5, 2], density=300)

    floors = sorted({round(region["pos"][1], 6) for region in layout.get("regions", {}).values()}) or [0.0]
    if len(floors) > 1:
        raise ValueError("floors at several heights are not supported")
    spec.worldbody.add_geom(
        name="floor", type=mujoco.mjtGeom.mjGEOM_BOX, size=[100, 100, 0.5], pos=[0, 0, floors[0] - 0.5], **stiff
    )
    for name, thing in layout["objects"].items():
        body = spec.worldbody.add_body(name=name, pos=point(thing["pos"]), quat=orientation(thing.get("rot", [0, 0, 0])))
        if name not in held:
            body.add_freejoint()
        w, h, d = thing["scale"]
        whole = [{"shape": "box", "pos": [0, h / 2, 0], "size": [w, h, d]}]
        for index, part in enumerate((thing.get("asset") or {}).get("parts") or whole):
            label = f"{name}/{index}"
            if part["shape"] == "box":
                w, h, d = part["size"]
                body.add_geom(
                    name=label, type=mujoco.mjtGeom.mjGEOM_BOX, size=[w / 2, d / 2, h / 2],
                    pos=point(part["pos"]), quat=orientation(part.get("rot", [0, 0, 0])), **stiff,
                )
            else:
                spec.add_mesh(name=label, uservert=np.array(convex_points(part)).ravel())
                body.add_geom(name=label, type=mujoco.mjtGeom.mjGEOM_MESH, meshname=label, **stiff)
    for a, b in overlap:
        spec.add_exclude(bodyname1=a, bodyname2=b)
    return spec.compile()


def depths(model, pairs=None):
    """How deep every pair of bodies, or every one of these pairs, is in each other, by the distance of their parts."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    owner = [model.body(model.geom_bodyid[g]).name for g in range(model.ngeom)]
    found = {}
    for a in range(model.ngeom):
        for b in range(a + 1, model.ngeom):
            pair = frozenset((owner[a], owner[b]))
            if len(pair) == 1 or (pairs is not None and pair not in pairs):
                continue
            apart = np.linalg.norm(data.geom_xpos[a] - data.geom_xpos[b]) - model.geom_rbound[a] - model.geom_rbound[b]
            if "world" not in pair and apart > 0:
                continue
            depth = -mujoco.mj_geomDistance(model, data, a, b, 0.01, None)
            found[pair] = max(found.get(pair, 0), float(depth))
    return found


def shared(layout, held, overlap):
    """The pairs that may share space and do."""
    allowed = {frozenset(pair) for pair in overlap}
    return [tuple(pair) for pair, depth in depths(build(layout, held, []), allowed).items() if depth > TOUCH]


def overlaps(model, held, overlap):
    """Deepest overlap of every pair of objects, and of every object with the floor."""
    allowed = {frozenset(pair) for pair in overlap}
    # A door leaf reaches to the floor of the room it opens, so what is held is not measured against it.
    wrong = {
        pair: depth
        for pair, depth in depths(model).items()
        if depth > OVERLAP and pair not in allowed and not ("world" in pair and pair & held)
    }
    return [{"pair": sorted(pair), "metres": round(depth, 4)} for pair, depth in sorted(wrong.items(), key=lambda x: -x[1])]


def drifts(model, held, seconds):
    """How far every free body moves under gravity."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = data.xpos.copy()
    far = np.zeros(model.nbody)
    for _ in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
        far = np.maximum(far, np.linalg.norm(data.xpos - start, axis=1))
    names = [model.body(i).name for i in range(model.nbody)]
    moved = [{"object": n, "metres": round(float(m), 4)} for n, m in zip(names, far) if m > DRIFT and n not in held]
    return moved, float(far.max(initial=0))


def judge(layout_file, facts_file, seconds):
    try:
        with open(layout_file, encoding="utf-8") as file:
            layout = json.load(file)
        with open(facts_file, encoding="utf-8") as file:
            facts = json.load(file)
        held = set(facts["held"])
        model = build(layout, held, shared(layout, held, facts["overlap"]))
    except Exception as problem:  # whatever it is, the verdict is: cannot judge
        print(f"{layout_file}: cannot judge: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    wrong = overlaps(model, held, facts["overlap"])
    moved, most = drifts(model, held, seconds)
    found = {"objects": len(layout["objects"]), "overlaps": wrong, "moved": moved, "largest_move": round(most, 5)}
    print(json.dumps({"layout": layout_file, **found}))
    return 1 if wrong or moved else 0


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("files", nargs="+", metavar="LAYOUT FACTS")
    arguments.add_argument("--seconds", type=float, default=2.0)
    given = arguments.parse_args()
    if len(given.files) % 2:
        arguments.error("each layout needs a file of facts")
    return max(judge(*pair, given.seconds) for pair in zip(given.files[::2], given.files[1::2]))


if __name__ == "__main__":
    sys.exit(main())
