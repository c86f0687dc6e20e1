"""What the runners of peers share: a problem of boxes turned by quarters in a rectangle, and how a result is written.

These peers know no free yaw, no gaps between surfaces and no ways; so only families without them are given to them:
random-feasible, tight-packing, paper and contradictory.
"""

import argparse
import json
import math
import os
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from hidden import bounds

DIRECTIONS = ("left_of", "right_of", "in_front_of", "behind")
FRONT = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}
KINDS = {"order", "bound", "inline", "distance", "inside", "aligned", "against_wall", "facing", "on", *DIRECTIONS}


class Problem:
    """Facts, sorted for someone who is to encode them."""

    def __init__(self, facts):
        self.facts = facts
        self.size = {o["id"]: o["size"] for o in facts["objects"]}
        self.rects = {r["id"]: bounds(r["polygon"]) for r in facts["regions"]}
        self.room = self.rects["room"]
        given = [c for c in facts["constraints"] if c.get("given")]
        self.yaws = {c["a"]: c["yaws"] for c in given if c["kind"] == "yaw"}
        self.stated = [c for c in facts["constraints"] if not c.get("given")]
        unknown = {c["kind"] for c in self.stated} - KINDS
        if unknown or set(self.yaws) != set(self.size):
            raise ValueError(f"{facts['id']} is not for this peer: {', '.join(sorted(unknown)) or 'free yaw'}")
        # What a thing stands on is given, so its height is known.
        host = {c["a"]: c["b"] for c in self.stated if c["kind"] == "on"}
        self.bottom = {}
        for name in self.size:
            chain, at = name, 0.0
            while chain in host:
                chain = host[chain]
                at += self.size[chain][1]
            self.bottom[name] = at

    def overlap_upright(self, a, b):
        return self.bottom[a] < self.bottom[b] + self.size[b][1] - 1e-6 and self.bottom[b] < self.bottom[a] + self.size[a][1] - 1e-6

    def flat(self, constraint):
        """The radius in the plan that a distance between centres comes to; None where it always holds."""
        a, b = constraint["a"], constraint["b"]
        off = self.bottom[a] + self.size[a][1] / 2 - self.bottom[b] - self.size[b][1] / 2
        square = constraint["value"] ** 2 - off**2
        if square >= 0:
            return math.sqrt(square)
        return None if constraint["op"] == ">=" else -1.0

    def layout(self, found):
        """A layout file from centres in the plan and yaws."""
        objects = {i: {"pos": [x, self.bottom[i], z], "rot": [0, yaw, 0], "scale": self.size[i]} for i, (x, z, yaw) in found.items()}
        regions = {}
        for region in self.facts["regions"]:
            x0, z0, x1, z1 = self.rects[region["id"]]
            regions[region["id"]] = {"pos": [(x0 + x1) / 2, 0, (z0 + z1) / 2], "scale": [x1 - x0, region["height"], z1 - z0]}
        return {"format": "scenelang.layout/1", "objects": objects, "regions": regions}


def axes(kind, yaw):
    """Towards where a direction of b points, and across it, when b has that yaw."""
    f = FRONT[yaw]
    r = (f[1], -f[0])
    return {"left_of": ((-r[0], -r[1]), f), "right_of": (r, f), "in_front_of": (f, r), "behind": ((-f[0], -f[1]), r)}[kind]


def run(name, solve):
    """The command line of a runner: FACTS.json --time SECONDS [--layout FILE] [--core]; prints one JSON object."""
    parser = argparse.ArgumentParser()
    parser.add_argument("facts")
    parser.add_argument("--time", type=float, default=60)
    parser.add_argument("--layout")
    parser.add_argument("--core", action="store_true", help="a minimal set of statements that contradict each other")
    args = parser.parse_args()
    problem = Problem(json.load(open(args.facts, encoding="utf-8")))
    begun = time.perf_counter()
    status, found = solve(problem, args.time, args.core)
    out = {"problem": problem.facts["id"], "peer": name, "status": status, "seconds": round(time.perf_counter() - begun, 4)}
    if status == "solved" and args.layout:
        with open(args.layout, "w", encoding="utf-8") as file:
            json.dump(problem.layout(found), file)
    if status == "refuted":
        out["core"] = sorted(found or [])
        out["exact"] = out["core"] == sorted(problem.facts.get("contradiction", []))
    print(json.dumps(out))
