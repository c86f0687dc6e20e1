# Loads an MJCF file in MuJoCo and lets time pass. Prints one JSON object.
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
print(json.dumps({"engine": "MuJoCo " + mujoco.__version__, "seconds": SECONDS, "overlaps": at_first, "moves": moves}))
