#!/usr/bin/env python3
"""Many samples of programs, each checked again by `scenelang check`; some of them by MuJoCo.

    cargo build --release --bin scenelang
    python3 tests/scale/samples.py target/release/scenelang examples/*.scene -n 1000
    python3 tests/scale/samples.py target/release/scenelang examples/bedroom.scene --mujoco 50 --python env/bin/python

`check` reads what is stored and judges it with the verifier; it knows nothing of how a layout was drawn. MuJoCo loads what
`--export mjcf` writes (`tests/oracles/mjcf.py`). It ends with 1 if a sample is bad.
"""

import argparse
import json
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

# Layouts that one `check` is given.
AT_ONCE = 250
ORACLE = pathlib.Path(__file__).resolve().parent.parent / "oracles/mjcf.py"


def cpu():
    """Seconds of processors of all commands so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def checked(binary, files):
    """How many layouts do not hold; each names its program."""
    bad = 0
    for at in range(0, len(files), AT_ONCE):
        some = files[at : at + AT_ONCE]
        command = [binary, "check", *[str(file) for file in some], "--format", "json"]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        reports = [json.loads(line) for line in ended.stdout.splitlines() if line.startswith("{")]
        bad += sum(not report["ok"] for report in reports) + len(some) - len(reports)
    return bad


def settled(args, scene, folder):
    """What MuJoCo finds in the first samples, exported for it."""
    command = [args.binary, "sample", str(scene), "-n", str(args.mujoco), "--seed", str(args.seed), "--export", "mjcf"]
    subprocess.run([*command, "-o", str(folder / "models")], capture_output=True, check=True)
    found = []
    for model in sorted((folder / "models").glob("sample-*/*.mjcf.xml")):
        told = str(model).replace(".mjcf.xml", ".mjcf.json")
        ended = subprocess.run([args.python, str(ORACLE), str(model), told], capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            found.append(f"{model.name}: {ended.stdout.strip()} {ended.stderr.strip()}")
    return found


def program(args, scene, folder):
    """Samples of one program: how many are bad."""
    scene = pathlib.Path(shutil.copy(scene, folder))
    # One workspace, so that layouts may name a program beside their own folder.
    (folder / "scenelang.toml").touch()
    begun, used = time.monotonic(), cpu()
    command = [args.binary, "sample", str(scene), "-n", str(args.n), "--seed", str(args.seed), "--jobs", str(args.jobs)]
    ended = subprocess.run([*command, "-o", str(folder / "out"), "--format", "json"], capture_output=True, text=True, check=False)
    wall, used = time.monotonic() - begun, cpu() - used
    if ended.returncode != 0:
        print(f"{scene}: exit code {ended.returncode}: {ended.stderr.strip()[:200]}")
        return 1
    report = json.loads(ended.stdout)
    lines = [line for file in sorted((folder / "out").glob("*.jsonl")) for line in file.read_text().splitlines()]
    files = []
    for number, line in enumerate(lines):
        file = folder / "out" / f"s{number:06}.layout.json"
        file.write_text(line)
        files.append(file)
    bad = checked(args.binary, files)
    near = report.get("nearestNeighbour") or {}
    print(f"{scene.name}: {len(lines)} of {report['asked']} stored, {bad} bad; {len(lines) / wall:.1f} per second, "
          f"{1000 * used / max(1, len(lines)):.1f} ms of a processor each; nearest neighbour {near.get('mean')} m", flush=True)
    if args.mujoco:
        found = settled(args, scene, folder)
        for said in found[:5]:
            print(f"  {said[:300]}")
        print(f"  MuJoCo: {len(found)} of {args.mujoco} bad", flush=True)
        bad += len(found)
    return bad


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("binary", type=pathlib.Path, help="a release build")
    arguments.add_argument("scenes", type=pathlib.Path, nargs="+")
    arguments.add_argument("-n", type=int, default=1000, help="samples of each (default 1000)")
    arguments.add_argument("--seed", type=int, default=7)
    arguments.add_argument("--jobs", type=int, default=2)
    arguments.add_argument("--mujoco", type=int, default=0, help="how many of each MuJoCo judges, too (default none)")
    arguments.add_argument("--python", default=sys.executable, help="a Python with the package mujoco")
    args = arguments.parse_args()
    args.binary = args.binary.resolve()
    bad = 0
    for scene in args.scenes:
        with tempfile.TemporaryDirectory() as folder:
            bad += program(args, scene, pathlib.Path(folder))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
