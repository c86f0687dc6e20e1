"""Pulls every door, drawer and lid of an MJCF file at its handle, in the physics engine MuJoCo, and holds where it comes to
rest against how far it was claimed to open.

usage: driven.py FILE.mjcf.xml FILE.layout.json CLAIMS.json

CLAIMS is a list of {"object", "joint", "free": degrees or metres, "ignored": [names that are not in the way]}. The owner of
the joint stands on its own weight, and what is not in its way may be pushed aside; everything else is held where it is.
Prints one JSON object. Exit 0: every joint opens as far as claimed, and let go it stays within its limits and is slow;
1: some do not; 2: cannot judge.
"""
import json
import sys

import mujoco
import numpy as np

REACHED = {"hinge": 1.0, "slide": 0.005}  # degrees or metres between where it stops and what was claimed
LIMIT = {"hinge": 0.5, "slide": 0.001}  # degrees or metres by which it may be beyond its limits once it is let go
SPEED = {"hinge": 3.0, "slide": 3.0}  # rad/s or m/s, let go
GENTLE = {"hinge": 1.0, "slide": 0.5}  # rad/s or m/s that the first pull comes to
PUSH = 60.0  # newtons at the handle: what pushes a chair aside
SECONDS = 6.0  # of each pull
AFTER = 1.0  # seconds, let go
STILL = 1e-3  # rad/s or m/s
RESTED = 0.25  # seconds of that


def engine_point(p):
    """MuJoCo has z up: y and z change places."""
    return np.array([p[0], p[2], p[1]], float)


class Pull:
    """One joint, pulled at its handle along the way that the handle goes."""

    def __init__(self, model, data, told, name):
        self.model, self.data = model, data
        self.joint = model.joint(name).id
        self.body = int(model.jnt_bodyid[self.joint])
        self.kind = told["motion"]
        self.handle = engine_point(told["handle"])
        self.q, self.v = int(model.jnt_qposadr[self.joint]), int(model.jnt_dofadr[self.joint])

    def amount(self):
        at = float(self.data.qpos[self.q])
        return np.degrees(at) if self.kind == "hinge" else at

    def speed(self):
        return abs(float(self.data.qvel[self.v]))

    def gentle(self):
        """Newtons that overcome the friction of the joint and its damping."""
        load = self.model.dof_frictionloss[self.v] + GENTLE[self.kind] * self.model.dof_damping[self.v]
        return float(load / self.way()[1])

    def way(self):
        """Where the handle goes, and how far for each radian or metre; the handle."""
        at = self.data.xpos[self.body] + self.data.xmat[self.body].reshape(3, 3) @ self.handle
        way = self.data.xaxis[self.joint].copy()
        if self.kind == "hinge":
            way = np.cross(way, at - self.data.xanchor[self.joint])
        return way / np.linalg.norm(way), np.linalg.norm(way), at

    def step(self, newtons):
        self.data.qfrc_applied[:] = 0
        if newtons:
            way, _, at = self.way()
            mujoco.mj_applyFT(self.model, self.data, way * newtons, np.zeros(3), at, self.body, self.data.qfrc_applied)
        mujoco.mj_step(self.model, self.data)

    def until_still(self, newtons):
        """Pulls until it has come to rest."""
        still = 0.0
        for _ in range(round(SECONDS / self.model.opt.timestep)):
            self.step(newtons)
            still = still + self.model.opt.timestep if self.speed() < STILL else 0.0
            if still > RESTED:
                return


def held(path, loose):
    """The scene, in which only these can be moved as a whole."""
    spec = mujoco.MjSpec.from_file(path)
    for joint in list(spec.joints):
        if joint.type == mujoco.mjtJoint.mjJNT_FREE and joint.parent.name not in loose:
            spec.delete(joint)
    return spec.compile()


def judge(path, claim, told):
    """What is wrong with a joint, how far from the claim it came to rest, and its kind."""
    name = f"{claim['object']}/{claim['joint']}"
    model = held(path, {claim["object"], *claim["ignored"]})
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    pull = Pull(model, data, told, name)
    pull.until_still(pull.gentle())
    if pull.amount() < claim["free"] - REACHED[pull.kind]:
        pull.until_still(PUSH)
    reached, unit = pull.amount(), "°" if pull.kind == "hinge" else " m"
    meets = {model.body(int(model.geom_bodyid[g])).name for c in data.contact for g in (c.geom1, c.geom2)
             if pull.body in (model.geom_bodyid[c.geom1], model.geom_bodyid[c.geom2])} - {name}
    low, high, fastest = np.inf, -np.inf, 0.0
    for index in range(round(AFTER / model.opt.timestep)):
        pull.step(0)
        fastest = max(fastest, pull.speed())
        low, high = min(low, pull.amount()), max(high, pull.amount())
    wrong = []
    if abs(reached - claim["free"]) > REACHED[pull.kind]:
        wrong.append(f"{name}: {claim['free']:.4f}{unit} claimed, pulled to {reached:.4f}{unit}, at {sorted(meets)}")
    if high > told["limits"][1] + LIMIT[pull.kind] or low < told["limits"][0] - LIMIT[pull.kind]:
        wrong.append(f"{name}: let go it goes from {low:.4f}{unit} to {high:.4f}{unit}, beyond its limits")
    if fastest > SPEED[pull.kind]:
        wrong.append(f"{name}: let go it goes at {fastest:.2f} per second")
    return wrong, abs(reached - claim["free"]), pull.kind


def main():
    scene, layout, claims = sys.argv[1:]
    total = {"joints": 0, "farthest": {"hinge": 0.0, "slide": 0.0}, "wrong": []}
    try:
        with open(layout, encoding="utf-8") as file:
            objects = json.load(file)["objects"]
        with open(claims, encoding="utf-8") as file:
            claims = json.load(file)
        for claim in claims:
            told = next(j for j in objects[claim["object"]]["asset"]["joints"] if j["name"] == claim["joint"])
            wrong, off, kind = judge(scene, claim, told)
            total["wrong"] += wrong
            total["joints"] += 1
            total["farthest"][kind] = round(max(total["farthest"][kind], float(off)), 5)
    except Exception as problem:  # whatever it is, the verdict is: cannot judge
        print(f"cannot judge: {type(problem).__name__}: {problem}", file=sys.stderr)
        return 2
    print(json.dumps(total))
    return 1 if total["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
