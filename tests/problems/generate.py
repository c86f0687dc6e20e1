#!/usr/bin/env python3
"""Seeded generator of placement problems: generate.py -o DIR [--family NAME]… [--count N | --size N --seed S].

Writes for each problem NAME.scene (the program), NAME.json (the facts that judge.py judges by) and, where there is one,
NAME.witness.json (the hidden layout, which satisfies everything). Without --family: all families, as many of each as
docs/benchmarks.md measures. The same seed gives the same files.
"""

import argparse
import json
import os
import random

import judge
import scene
from contradictory import PLANTS, certified, contradictory
from equations import EQUATIONS
from families import FAMILIES
from furnished import EVERY
from hidden import floor_of
from homes import HOMES
from offices import OFFICES

SIZES = (10, 14, 20, 28, 40, 56, 80)
COVERS = (30, 40, 50)
# Furnished rooms; in every second problem of a family the ways go to each thing, in the others to one of each group.
ROOMS = {**OFFICES, **HOMES}
ROOM_SIZES = (10, 14, 20, 28, 36, 48, 60)
NEW = ("free-yaw", "l-room", "two-rooms", "stacking", "seating", "rows", "paths", "soft", *EQUATIONS, *ROOMS)
SAMPLE = (("random-feasible", 10), ("tight-packing", 10), ("contradictory", 10), ("paper", 40)) + tuple((f, 12) for f in NEW)


def make(family, n, cover, seed, plant=None, k=None):
    """One problem: its facts and the hidden layout."""
    for attempt in range(60):
        rng = random.Random(f"{family} {n} {cover} {plant} {k} {seed} {attempt}")
        if family == "contradictory":
            hidden = contradictory(rng, n, plant)
        elif family in ROOMS:
            hidden = ROOMS[family](rng, n, EVERY if seed % 2 else None)
        else:
            hidden = {**FAMILIES, **EQUATIONS}[family](rng, n, cover / 100, **({"k": k} if k else {}))
        if hidden is None:
            continue
        facts = hidden.facts
        share = None if family in ROOMS or family in EQUATIONS else f"d{cover}"
        facts["id"] = "-".join(str(v) for v in (family, f"n{n}", plant or share, k and f"k{k}", f"s{seed}") if v)
        facts["family"] = family
        if sound(facts, hidden, n):
            return facts, hidden
    raise SystemExit(f"no sound layout for {family} n={n} cover={cover} seed={seed}")


def sound(facts, hidden, n):
    """Whether the hidden layout is one: by the judge, who knows nothing of how it came about."""
    if facts["family"] == "contradictory":
        for dropped, order in facts["certificates"].items():
            layout = hidden.layout("")
            for name, box in certified(hidden, order).items():
                layout["objects"][name]["pos"] = list(box.pos)
            verdict = judge.judge(facts, layout)
            if verdict["wrong"] or verdict["broken"] != [dropped]:
                return False
        return True
    return len(hidden.boxes) >= 0.85 * n and judge.judge(facts, hidden.layout(""))["valid"]


def suite(family, count=None):
    """What docs/benchmarks.md measures of a family, as arguments of `make`."""
    if family == "random-feasible":
        plan = [(n, 40, s, None, 3) for n in (5, 10, 20, 40, 80) for s in range(3)]
        plan += [(n, c, 0, None, k) for c in (20, 60) for k in (1, 3, 5) for n in (10, 20)]
        plan += [(n, 40, 0, None, k) for k in (1, 5) for n in (10, 20)]
    elif family == "tight-packing":
        plan = [(n, c, 0) for n in (5, 10, 20, 40) for c in (85, 95)]
    elif family == "contradictory":
        plan = [(n, 40, s, p) for p in PLANTS for n, s in ((10, 0), (20, 1), (40, 2))]
    elif family == "stress":
        plan = [(n, 60 if k == 5 else 40, 0, None, k) for n, k in ((160, 3), (160, 5), (320, 3))]
    elif family == "paper":
        plan = [(40, (30, 35, 40)[s % 3], s) for s in range(100)]
    elif family in ROOMS or family in EQUATIONS:
        plan = [(ROOM_SIZES[s % len(ROOM_SIZES)], 40, s) for s in range(20)]
    else:
        plan = [(SIZES[s % len(SIZES)], COVERS[s % len(COVERS)], s) for s in range(20)]
    return plan[:count]


def write(folder, facts, hidden):
    os.makedirs(folder, exist_ok=True)
    stem = os.path.join(folder, facts["id"])
    texts = {f"{stem}.scene": scene.program(facts), f"{stem}.json": lines(facts)}
    if facts["family"] != "contradictory":
        texts[f"{stem}.witness.json"] = lines(hidden.layout(f"{facts['id']}.scene"))
    for path, text in texts.items():
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)


def lines(document):
    """JSON with a line for each member of a list or of an object in it: short, and readable in a comparison."""
    def short(value):
        return json.dumps(value, separators=(", ", ": "))
    out = []
    for key, value in document.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            out.append(f" {short(key)}: [\n  " + ",\n  ".join(short(v) for v in value) + "\n ]")
        elif isinstance(value, dict):
            out.append(f" {short(key)}: {{\n  " + ",\n  ".join(f"{short(k)}: {short(v)}" for k, v in value.items()) + "\n }")
        else:
            out.append(f" {short(key)}: {short(value)}")
    return "{\n" + ",\n".join(out) + "\n}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--out", required=True)
    every = (*FAMILIES, *EQUATIONS, *ROOMS, "contradictory", "stress")
    parser.add_argument("--family", action="append", choices=every)
    parser.add_argument("--count", type=int, help="only the first so many of each family")
    parser.add_argument("--size", type=int, help="one problem of so many objects")
    parser.add_argument("--cover", type=int, default=40, help="percent of the floor (with --size)")
    parser.add_argument("--seed", type=int, default=0, help="with --size")
    parser.add_argument("--plant", choices=PLANTS, default=PLANTS[0], help="with --size and --family contradictory")
    parser.add_argument("--sample", action="store_true", help="one small problem of each family: those of the tests")
    args = parser.parse_args()
    if args.sample:
        for i, (family, n) in enumerate(SAMPLE):
            plant = PLANTS[1] if family == "contradictory" else None
            write(args.out, *make(family, n, 85 if family == "tight-packing" else 40, i, plant))
        return
    for family in args.family or every:
        plans = [(args.size, args.cover, args.seed, args.plant if family == "contradictory" else None)]
        for plan in plans if args.size else suite(family, args.count):
            facts, hidden = make("random-feasible" if family == "stress" else family, *plan)
            if family == "stress":
                facts["id"] = facts["id"].replace("random-feasible", "stress")
            write(os.path.join(args.out, family), facts, hidden)
            floor = [b for b in hidden.boxes.values() if b.bottom < 0.01]
            share = sum(b.w * b.d for b in floor) / floor_of(facts["regions"])
            counted = sum(1 for c in facts["constraints"] if not c.get("given"))
            print(f"{facts['id']:40} {len(facts['objects']):3} objects {counted:4} constraints {share:.0%} covered", flush=True)


if __name__ == "__main__":
    main()
