# Loads an MJCF file in MuJoCo, lets time pass, and drives each joint towards its limit. Prints one JSON object.
# Exit 3: the package is not there; 4: the file cannot be loaded.
import sys

# Nothing is imported from the folder that this is called in.
sys.path[:] = [entry for entry in sys.path if entry not in ("", ".")]

import json

try:
    import mujoco
    import numpy as np
except ImportError as problem:
    print(problem, file=sys.stderr)
    sys.exit(3)

SECONDS = float(sys.argv[2])

try:
    model = mujoco.MjModel.from_xml_path(sys.argv[1])
except ValueError as problem:
    print(problem, file=sys.stderr)
    sys.exit(4)

data = mujoco.MjData(model)
mujoco.mj_forward(model, data)


def depths():
    found = {}
    for contact in data.contact[: data.ncon]:
        pair = tuple(sorted(model.body(model.geom_bodyid[g]).name for g in (contact.geom1, contact.geom2)))
        found[pair] = max(found.get(pair, 0.0), -float(contact.dist))
    return [{"bodies": list(pair), "depth": depth} for pair, depth in sorted(found.items(), key=lambda f: (-f[1], f[0]))]


at_first, start = depths(), data.xpos.copy()
far = np.zeros(model.nbody)
for _ in range(round(SECONDS / model.opt.timestep)):
    mujoco.mj_step(model, data)
    far = np.maximum(far, np.linalg.norm(data.xpos - start, axis=1))
moves = [{"body": model.body(i).name, "distance": float(far[i])} for i in np.argsort(-far, kind="stable") if model.body(i).dofnum[0]]

# What a joint is driven with overcomes its friction, and its damping at this speed (rad/s or m/s).
GENTLE = {"hinge": 1.0, "slide": 0.5}
LONGEST = 6.0  # seconds for each joint
STILL, RESTED = 1e-3, 0.25  # rad/s or m/s, and seconds of that


def driven(joint, motion):
    """How far a joint goes from its closed state, and how far it could go."""
    mujoco.mj_resetData(model, data)
    at, velocity = int(model.jnt_qposadr[joint]), int(model.jnt_dofadr[joint])
    low, high = (float(limit) for limit in model.jnt_range[joint])
    way = 1.0 if abs(high) >= abs(low) else -1.0
    force = float(model.dof_frictionloss[velocity]) + GENTLE[motion] * float(model.dof_damping[velocity])
    rested = 0.0
    mujoco.mj_forward(model, data)
    for _ in range(round(LONGEST / model.opt.timestep)):
        # A lid is lifted: its weight is carried.
        data.qfrc_applied[velocity] = way * force + data.qfrc_bias[velocity]
        mujoco.mj_step(model, data)
        rested = rested + model.opt.timestep if abs(data.qvel[velocity]) < STILL else 0.0
        if rested > RESTED:
            break
    told = np.degrees if motion == "hinge" else float
    return {"reach": abs(float(told(data.qpos[at]))), "limit": float(told(max(abs(low), abs(high))))}


MOTIONS = {int(mujoco.mjtJoint.mjJNT_HINGE): "hinge", int(mujoco.mjtJoint.mjJNT_SLIDE): "slide"}
joints = []
for index in range(model.njnt):
    motion = MOTIONS.get(int(model.jnt_type[index]))
    if motion and model.jnt_limited[index]:
        joints.append({"joint": model.joint(index).name, "motion": motion, **driven(index, motion)})
print(json.dumps({"engine": "MuJoCo " + mujoco.__version__, "seconds": SECONDS, "overlaps": at_first, "moves": moves, "joints": joints}))
