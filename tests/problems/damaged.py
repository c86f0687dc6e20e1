#!/usr/bin/env python3
"""Damages hidden layouts and asks `check` and `repair` for the way back: damaged.py --binary FILE [--count N] [--seed S].

In each layout one thing is moved, turned or lifted, in every third a second one. For each violation that `check` offers a
move for, the move is made: what it was offered for must hold then, and nothing that held may fail. `repair` is asked for the
same violation and must offer the same move first, and a move for everything at once, after which all holds.
Needs problems with hidden layouts: generate.py -o DIR. The same seed gives the same cases.
"""

import argparse
import concurrent.futures
import copy
import json
import pathlib
import random
import subprocess
import sys
import tempfile

SAME = 0.05  # two moves of an object are one if they end this close (metres; of turns: degrees times a hundred)


def run(binary, *args):
    done = subprocess.run([binary, *args], capture_output=True, text=True, timeout=300)
    return done.returncode, json.loads(done.stdout) if done.stdout.strip() else {}


def damage(layout, rng, movable):
    """One or two things elsewhere; the names of those."""
    names = rng.sample(movable, min(len(movable), 2 if rng.random() < 1 / 3 else 1))
    for name in names:
        thing = layout["objects"][name]
        kind = rng.choice(("move", "move", "turn", "lift"))
        if kind == "turn":
            thing["rot"][1] = (thing["rot"][1] + rng.choice((90, 180, 270))) % 360
        elif kind == "lift":
            thing["pos"][1] = round(thing["pos"][1] + rng.choice((0.05, 0.3)), 3)
        else:
            far = rng.choice((0.1, 0.4, 1.0))
            thing["pos"][0] = round(thing["pos"][0] + rng.uniform(-far, far), 3)
            thing["pos"][2] = round(thing["pos"][2] + rng.uniform(-far, far), 3)
    return names


def steps_of(move):
    """By object, how far it goes and turns."""
    own = {move["object"]: (move["by"], move.get("turn", 0.0))}
    return {**own, **{m["object"]: (m["by"], m.get("turn", 0.0)) for m in move.get("with", []) if isinstance(m, dict)}}


def same(a, b):
    if a.keys() != b.keys():
        return False
    close = lambda p, q: all(abs(x - y) <= SAME for x, y in zip(p[0], q[0])) and abs(p[1] - q[1]) <= 100 * SAME
    return all(close(a[k], b[k]) for k in a)


def moved(layout, steps):
    out = copy.deepcopy(layout)
    for name, (by, turn) in steps.items():
        thing = out["objects"][name]
        thing["pos"] = [p + d for p, d in zip(thing["pos"], by)]
        thing["rot"][1] = (thing["rot"][1] + turn) % 360
    return out


def failing(report):
    return {c["id"] for c in report.get("constraints", []) if not c["satisfied"]}


def judge(binary, folder, scene, witness, seed):
    """What was found in one damaged layout, in lines; how much was asked."""
    rng = random.Random(f"{scene.stem} {seed}")
    layout = json.loads(witness.read_text())
    doors = {name for name in layout["objects"] if name.startswith(("portal", "door", "window"))}
    names = damage(layout, rng, sorted(set(layout["objects"]) - doors))
    layout["scene"] = str(scene.resolve())
    own = folder / f"{scene.stem}-{seed}"
    own.mkdir()
    text = scene.read_text()
    (own / scene.name).write_text(text)
    layout["scene"] = scene.name
    file = own / f"{scene.stem}.layout.json"
    file.write_text(json.dumps(layout))
    code, report = run(binary, "check", str(file), "--format", "json")
    if code == 0:
        return {"nothing": 1}, []
    out, lines = {"layouts": 1}, []
    before = failing(report)
    count = lambda key: out.__setitem__(key, out.get(key, 0) + 1)
    for row in (c for c in report["constraints"] if not c["satisfied"]):
        count("rows")
        move = (row.get("explanation") or {}).get("move")
        if not move:
            continue
        count("offered")
        steps = steps_of(move)
        after_file = own / "after.layout.json"
        after_file.write_text(json.dumps(moved(layout, steps)))
        after = failing(run(binary, "check", str(after_file), "--format", "json")[1])
        if row["id"] in after:
            count("not repaired")
            lines.append(f"{own.name} {row['id']} {names}: the move of check does not repair it: {steps}")
        if after - before:
            count("broken")
            lines.append(f"{own.name} {row['id']} {names}: the move of check breaks {sorted(after - before)}: {steps}")
        _, answer = run(binary, "repair", str(file), "--constraint", row["id"], "--dry-run", "--format", "json")
        first = next((a for a in answer.get("alternatives", []) if a["how"] == "move"), None)
        theirs = {m["object"]: (m["by"], m["turn"]) for m in first["moves"]} if first else {}
        if not same(steps, theirs):
            count("other move")
            lines.append(f"{own.name} {row['id']} {names}: check {steps}, repair {theirs}")
    _, answer = run(binary, "repair", str(file), "--dry-run", "--format", "json")
    first = next((a for a in answer.get("alternatives", []) if a["how"] == "move"), None)
    if first:
        count("repaired")
        steps = {m["object"]: (m["by"], m["turn"]) for m in first["moves"]}
        after_file.write_text(json.dumps(moved(layout, steps))) if "offered" in out else None
    else:
        lines.append(f"{own.name} {names}: repair finds no move for {sorted(before)}")
    return out, lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("problems", type=pathlib.Path)
    parser.add_argument("--binary", required=True)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    witnesses = sorted(args.problems.rglob("*.witness.json"))
    cases = [(w.with_name(w.name.replace(".witness.json", ".scene")), w, args.seed + i // len(witnesses))
             for i in range(args.count) for w in [witnesses[i % len(witnesses)]]]
    total = {}
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for out, lines in pool.map(lambda c: judge(args.binary, pathlib.Path(folder), *c), cases):
            print("\n".join(lines), end="\n" if lines else "", flush=True)
            for key, n in out.items():
                total[key] = total.get(key, 0) + n
    print(json.dumps(total))
    return int(any(total.get(k) for k in ("not repaired", "broken", "other move")))


if __name__ == "__main__":
    sys.exit(main())
