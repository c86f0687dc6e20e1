#!/usr/bin/env python3
"""Measures all that docs/benchmarks.md tells, and writes its tables: `./x figures`.

Generates the problems, solves them with `scenelang bench solve`, has every layout judged by judge.py, runs the peers on
the same problems, and replaces what stands between the markers of docs/benchmarks.md. Each step leaves its result in the
folder of --out and is not done again while that is there.
"""

import argparse
import collections
import json
import os
import subprocess
import sys

import generate
import judge

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
DOCUMENT = os.path.join(ROOT, "docs/benchmarks.md")
OTHERS = os.path.join(ROOT, "crates/cli/src/bench/others.json")
# Families with the seeds that each of their problems is solved from.
SEEDS = {**{f: 10 for f in ("random-feasible", "tight-packing")}, **{f: 3 for f in generate.NEW}, "paper": 1, "contradictory": 1, "stress": 1}
PEERS = ("z3", "cpsat", "scenic")
SCENIC_MOST = 20  # objects; with more it never came to an end


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", default=os.path.join(ROOT, "out/problems"))
    parser.add_argument("--binary", default=os.path.join(ROOT, "target/release/scenelang"))
    parser.add_argument("--python", default=os.path.join(ROOT, ".venv-peers/bin/python"), help="one that has the peers")
    parser.add_argument("--time", type=float, default=60, help="limit of a run of ours (seconds)")
    parser.add_argument("--peer-time", type=float, default=60, help="limit of a run of a peer (seconds)")
    parser.add_argument("--count", type=int, help="only the first so many problems of each family: to try it")
    args = parser.parse_args()
    step(args, "set", lambda path: make(path, args.count))
    bench = {f: step(args, f"bench-{f}.json", lambda path, f=f: measure(args, f, path)) for f in SEEDS}
    verdicts = step(args, "verdicts.json", lambda path: save(path, judge_all(args, bench)))
    peers = step(args, "peers.json", lambda path: save(path, run_peers(args)))
    with open(DOCUMENT, encoding="utf-8") as file:
        text = file.read()
    tables = {"families": families(bench, verdicts), "peers": beside(bench, peers), "contradictions": contradictions(args, bench, peers), "published": published()}
    for name, table in tables.items():
        text = between(text, name, table)
    with open(DOCUMENT, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)


def step(args, name, work):
    path = os.path.join(args.out, name)
    if not os.path.exists(path):
        print(f"{name} …", file=sys.stderr)
        os.makedirs(args.out, exist_ok=True)
        work(path)
    if name.endswith(".json"):
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    return path


def save(path, value):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(value, file)


def make(path, count):
    command = [sys.executable, "-B", os.path.join(HERE, "generate.py"), "-o", path + ".part"]
    subprocess.run(command + (["--count", str(count)] if count else []), check=True, stdout=subprocess.DEVNULL)
    os.rename(path + ".part", path)


def measure(args, family, path):
    folder = os.path.join(args.out, "set", family)
    options = ["--seeds", str(SEEDS[family]), "--time", str(args.time), "--layouts", os.path.join(args.out, "layouts")]
    found = subprocess.run([args.binary, "bench", "solve", folder, *options, "-o", path], stdout=subprocess.DEVNULL)
    if found.returncode > 1:
        raise SystemExit(f"bench solve ended with {found.returncode}")


def facts_of(args, family, problem):
    with open(os.path.join(args.out, "set", family, f"{problem}.json"), encoding="utf-8") as file:
        return json.load(file)


def judge_all(args, bench):
    """Whether the judge accepts each layout that our verifier accepts, and the weight of the preferences in it."""
    out = {}
    for family, record in bench.items():
        for run in record["runs"]:
            if run["answer"] != "solved":
                continue
            name = f"{run['problem']}.s{run['seed']}"
            with open(os.path.join(args.out, "layouts", f"{name}.layout.json"), encoding="utf-8") as file:
                verdict = judge.judge(facts_of(args, family, run["problem"]), json.load(file))
            out[name] = {k: verdict[k] for k in ("valid", "broken", "wrong", "preferences")}
    return out


def run_peers(args):
    """Every peer on every problem that it can be given: those of quarter turns in a rectangle."""
    out = []
    for family in ("random-feasible", "tight-packing", "paper", "contradictory"):
        problems = sorted(f[:-6] for f in os.listdir(os.path.join(args.out, "set", family)) if f.endswith(".scene"))
        for problem in problems[:5] if family == "paper" else problems:
            facts = facts_of(args, family, problem)
            for peer in PEERS:
                if peer == "scenic" and (family not in ("random-feasible", "tight-packing") or len(facts["objects"]) > SCENIC_MOST):
                    continue
                out.append(run_peer(args, family, problem, facts, peer))
    return out


def run_peer(args, family, problem, facts, peer):
    layout = os.path.join(args.out, "peer.layout.json")
    if os.path.exists(layout):
        os.remove(layout)
    path = os.path.join(args.out, "set", family, f"{problem}.json")
    command = [args.python, "-B", os.path.join(HERE, "peers", f"{peer}_run.py"), path, "--time", str(args.peer_time), "--layout", layout]
    command += ["--core"] if family == "contradictory" else []
    try:
        ended = subprocess.run(command, capture_output=True, text=True, timeout=3 * args.peer_time + 60)
        found = json.loads(ended.stdout.splitlines()[-1])
    except (subprocess.TimeoutExpired, ValueError, IndexError):
        found = {"problem": problem, "status": "error", "seconds": None}
    found.update(family=family, peer=peer, objects=len(facts["objects"]))
    if found["status"] == "solved":
        with open(layout, encoding="utf-8") as file:
            found["valid"] = judge.judge(facts, json.load(file))["valid"]
    return found


def seconds(value):
    if value is None:
        return "—"
    if value < 0.0095:
        return f"{value * 1e3:.1f} ms"
    return f"{value * 1e3:.0f} ms" if value < 1 else f"{value:.2f} s"


def percent(part, whole):
    if not whole:
        return "—"
    share = 100 * part / whole
    return "99.9 %" if part < whole and share > 99.9 else f"{share:.1f} %"


def quantile(times, share):
    """Of all runs; those without an answer are slower than any."""
    times = sorted(times, key=lambda t: float("inf") if t is None else t)
    return times[max(0, -(-int(share * 1000) * len(times) // 1000) - 1)]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows])


def families(bench, verdicts):
    rows = []
    for family, record in bench.items():
        found = record["families"][0]
        runs = record["runs"]
        accepted = [verdicts[f"{r['problem']}.s{r['seed']}"] for r in runs if r["answer"] == "solved"]
        answered = found["solved"] + found["refuted"]
        held, of = (sum(v["preferences"][k] for v in accepted) for k in ("held", "of"))
        counted = found["constraints"]
        times = [seconds(found["seconds"][k]) for k in ("median", "p90", "p99", "max")]
        judged = percent(sum(v["valid"] for v in accepted), len(runs)) if accepted else "—"
        rows.append((family, found["problems"], found["runs"], percent(answered, found["runs"]), judged, percent(counted["held"], counted["of"]), percent(held, of), *times))
    return table(("family", "problems", "runs", "answered", "accepted by the judge", "constraints", "weight of preferences", "median", "p90", "p99", "max"), rows)


def beside(bench, peers):
    """Our time beside that of peers by size, and how many times longer they took."""
    groups = collections.OrderedDict()
    for family in ("random-feasible", "tight-packing", "paper"):
        for run in bench[family]["runs"]:
            groups.setdefault((family, run["objects"]), {}).setdefault("ours", []).append(run["first"])
    for found in peers:
        group = groups.get((found["family"], found["objects"]))
        if group is not None:
            group.setdefault(found["peer"], []).append(found["seconds"] if found.get("valid") else None)
    rows = []
    for (family, objects), group in groups.items():
        ours = quantile(group["ours"], 0.5)
        row = [family, objects, f"{seconds(ours)} ({sum(t is not None for t in group['ours'])} of {len(group['ours'])})"]
        for peer in PEERS:
            times = group.get(peer)
            if not times:
                row.append("not tried")
                continue
            median = quantile(times, 0.5)
            ratio = f", ×{median / ours:.0f}" if median and ours else ""
            row.append(f"{seconds(median)}{ratio} ({sum(t is not None for t in times)} of {len(times)})")
        rows.append(row)
    return table(("family", "objects", "ours: median (solved)", "z3", "CP-SAT", "Scenic"), rows)


def contradictions(args, bench, peers):
    rows = []
    for run in bench["contradictory"]["runs"]:
        planted = sorted(facts_of(args, "contradictory", run["problem"])["contradiction"])
        exact = [sorted(c) for c in run.get("contradictions", [])] == [planted]
        row = [run["problem"], run["objects"], f"{seconds(run['first'])}, {'exact' if exact else run['answer']}"]
        for peer in PEERS[:2]:
            found = next((p for p in peers if p["problem"] == run["problem"] and p["peer"] == peer), {})
            said = "exact" if found.get("exact") else found.get("status", "not tried")
            row.append(f"{seconds(found.get('seconds'))}, {said}")
        rows.append(row)
    return table(("problem", "objects", "ours", "z3", "CP-SAT"), rows)


def published():
    with open(OTHERS, encoding="utf-8") as file:
        others = json.load(file)
    rows = [(o["name"], "—", "—", f"{o['held_percent']} %", o["source"]) for o in others["published"]]
    for o in others["measured"]:
        rows.append((o["name"], o["problems"], percent(o["solved"], o["problems"]), percent(o.get("held", 0), o.get("of", 0)), o["source"].replace("see notes", "see below")))
    return table(("others", "problems", "solved", "constraints", "source"), rows)


def between(text, name, content):
    start, end = f"<!-- table: {name} -->\n", f"<!-- end: {name} -->"
    head, _, rest = text.partition(start)
    _, found, tail = rest.partition(end)
    if not found:
        raise SystemExit(f"{DOCUMENT} has no place for the table {name}")
    return head + start + content + "\n" + end + tail


if __name__ == "__main__":
    main()
