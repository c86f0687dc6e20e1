"""Loads an MJCF file with the physics engine MuJoCo and lets time pass: nothing overlaps, everything stays where it is, and
doors and drawers stay closed.

usage: mjcf.py FILE.mjcf.xml FILE.mjcf.json [--seconds 2]

The JSON file says what each body is; it must speak of all bodies, and what it calls static must have no joint.
Prints one JSON object. Exit 0: sound; 1: findings; 2: the file cannot be loaded.
"""
import argparse
import json
import sys

import mujoco
import numpy as np

OVERLAP = 0.002  # metres two shapes may share, at the beginning and at the end
DRIFT = 0.02  # metres a body may move while it settles
AJAR = {int(mujoco.mjtJoint.mjJNT_HINGE): np.radians(0.5), int(mujoco.mjtJoint.mjJNT_SLIDE): 0.001}  # how far a joint may open


def deepest(model, data):
    """The deepest contact of each pair of bodies that is deeper than allowed."""
    found = {}
    for contact in data.contact[: data.ncon]:
        pair = tuple(sorted(model.body(model.geom_bodyid[g]).name for g in (contact.geom1, contact.geom2)))
        if -contact.dist > OVERLAP:
            found[pair] = max(found.get(pair, 0.0), float(-contact.dist))
    return {" and ".join(pair): round(depth, 4) for pair, depth in sorted(found.items())}


def kinds(model, told):
    """What the JSON file says of bodies and what the model does not."""
    wrong = []
    names = {model.body(i).name for i in range(1, model.nbody)}
    wrong += [f"no such body: {name}" for name in sorted(told.keys() - names)]
    wrong += [f"a body that is not told of: {name}" for name in sorted(names - told.keys())]
    for name in names & told.keys():
        body = model.body(name)
        if told[name]["static"] != (body.jntnum[0] == 0):
            wrong.append(f"{name}: static or not?")
        if not told[name]["static"] and abs(told[name]["mass"] - body.mass[0]) > 1e-6 * body.mass[0]:
            wrong.append(f"{name}: weighs {body.mass[0]}")
    return wrong


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("model")
    arguments.add_argument("told")
    arguments.add_argument("--seconds", type=float, default=2.0)
    given = arguments.parse_args()
    try:
        model = mujoco.MjModel.from_xml_path(given.model)
        with open(given.told, encoding="utf-8") as file:
            told = json.load(file)["bodies"]
    except Exception as problem:  # whatever it is, the verdict is: it cannot be loaded
        print(f"cannot load: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    wrong = kinds(model, told)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    before = deepest(model, data)
    start = data.xpos.copy()
    far = np.zeros(model.nbody)
    joints = [i for i in range(model.njnt) if int(model.jnt_type[i]) in AJAR]
    where = model.jnt_qposadr[joints]
    closed, ajar = data.qpos[where].copy(), np.zeros(len(joints))
    for _ in range(round(given.seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
        far = np.maximum(far, np.linalg.norm(data.xpos - start, axis=1))
        ajar = np.maximum(ajar, np.abs(data.qpos[where] - closed))
    warned = [mujoco.mjtWarning(i).name for i, w in enumerate(data.warning) if w.number]
    moved = {model.body(i).name: round(float(d), 4) for i, d in enumerate(far) if d > DRIFT}
    opened = {model.joint(i).name: round(float(a), 4) for i, a in zip(joints, ajar) if a > AJAR[int(model.jnt_type[i])]}
    after = deepest(model, data)
    print(json.dumps({
        "bodies": model.nbody - 1, "loose": model.njnt, "geoms": model.ngeom, "wrong": wrong, "warnings": warned,
        "overlaps": before, "overlaps_after": after, "moved": moved, "opened": opened,
        "largest_move": round(float(far.max(initial=0)), 5),
    }))
    return 1 if wrong or warned or before or after or moved or opened else 0


if __name__ == "__main__":
    sys.exit(main())
