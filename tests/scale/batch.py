#!/usr/bin/env python3
"""What `scenelang batch` promises of many lines, measured: results and errors, kills, shards, memory, two jobs.

    cargo build --release --bin scenelang
    python3 tests/scale/batch.py target/release/scenelang -n 1000

It takes the time of about four runs of the manifest and writes to a temporary folder. It ends with 1 if a promise is
broken; times and memory are only printed, since they belong to the machine.
"""

import argparse
import json
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

import manifest

FAILED = []


def expect(what, holds):
    """Notes a promise that is broken."""
    print(("ok    " if holds else "BROKEN"), what, flush=True)
    if not holds:
        FAILED.append(what)


def family(parent):
    """Resident memory of a process and of its children, in MiB."""
    found = []
    for entry in os.listdir("/proc"):
        if not entry.isdigit():
            continue
        try:
            status = dict(line.split(":\t", 1) for line in pathlib.Path(f"/proc/{entry}/status").read_text().splitlines())
            if entry == str(parent) or status["PPid"].strip() == str(parent):
                found.append((entry == str(parent), int(status["VmRSS"].split()[0]) / 1024))
        except (OSError, KeyError, ValueError):
            pass
    return [rss for own, rss in found if own], [rss for own, rss in found if not own]


class Watch(threading.Thread):
    """Notes the memory of a command and of its workers while it runs."""

    def __init__(self, process):
        super().__init__(daemon=True)
        self.process, self.parent, self.workers = process, [], []

    def run(self):
        while self.process.poll() is None:
            own, children = family(self.process.pid)
            self.parent += own
            self.workers += children
            time.sleep(0.2)


def run(args, folder, *more, watch=False):
    """A run to its end: exit code, wall and processor seconds, and what was seen of memory."""
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    command = [args.binary, "batch", "jobs.jsonl", "--time", str(args.time), *more]
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    seen = Watch(process) if watch else None
    if seen:
        seen.start()
    said, _ = process.communicate()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return process.returncode, time.monotonic() - begun, used, said, seen


def results(folder):
    """All files of a folder but summaries, with their bytes."""
    kept = (file for file in folder.iterdir() if not file.name.startswith(("summary-", ".")))
    return {file.name: file.read_bytes() for file in kept if file.is_file()}


def alike(one, other):
    """Whether two folders have the same results; which files differ is printed."""
    one, other = results(one), results(other)
    differ = sorted(name for name in one.keys() | other.keys() if one.get(name) != other.get(name))
    for name in differ[:5]:
        print(f"       {name}: {one.get(name, b'')[-200:]} is not {other.get(name, b'')[-200:]}")
    return not differ


def at_work(folder):
    """Whether a worker of a command that was killed is still there."""
    for entry in os.listdir("/proc"):
        try:
            words = pathlib.Path(f"/proc/{entry}/cmdline").read_bytes().split(b"\0")
            if b"batch-line" in words and os.readlink(f"/proc/{entry}/cwd") == str(folder):
                return True
        except OSError:
            pass
    return False


def whole(args, folder, count):
    """One run with two jobs, and one with a single one."""
    code, wall, used, said, seen = run(args, folder, "-o", "two", "--jobs", "2", "--format", "json", watch=True)
    if code not in (0, 1):
        sys.exit(f"scenelang batch ended with {code}")
    summary = json.loads(said)
    bad = count // 20
    expect(f"two jobs: exit code {code}, {summary['good']} results, {summary['failed']} errors",
           (code, summary["good"], summary["failed"]) == (1, count - bad, bad))
    kinds = {}
    for outcome in summary["results"]:
        if not outcome["ok"]:
            kinds.setdefault(outcome["error"]["kind"], []).append(outcome["error"]["message"])
    for kind, messages in sorted(kinds.items()):
        print(f"       {kind}: {len(messages)}, such as: {messages[0][:150]}")
    print(f"       {wall:.1f} s, {used:.1f} s of processors; {1000 * used / count:.0f} ms of a processor for a line")
    half = len(seen.parent) // 2
    print(f"       memory of the command: {max(seen.parent[:half]):.0f} MiB in the first half, "
          f"{max(seen.parent[half:]):.0f} MiB in the second; of a worker: {max(seen.workers):.0f} MiB at most")
    _, alone, own, _, _ = run(args, folder, "-o", "one", "--jobs", "1")
    expect("one job: the same bytes", alike(folder / "one", folder / "two"))
    print(f"       {alone:.1f} s, {own:.1f} s of processors: two jobs take {alone / wall:.2f} times less time")
    print(f"       a million scenes: {1e6 * wall / count / 3600:.0f} h on this machine with two jobs, "
          f"{1e6 * used / count / 3600:.0f} hours of processors")


def shards(args, folder, of):
    """Parts, merged."""
    for index in range(of):
        run(args, folder, "-o", "parts", "--jobs", "2", "--shard", f"{index}/{of}")
    for out in ["parts", "two"]:
        subprocess.run([args.binary, "batch", "merge", out], cwd=folder, capture_output=True, check=False)
    expect(f"{of} shards: the union is the single run, byte for byte", alike(folder / "parts", folder / "two"))


def kills(args, folder, times, wall):
    """Ends at random moments."""
    dice, done, repeated = random.Random(3), {}, 0
    out = folder / "killed"
    for _ in range(times):
        process = subprocess.Popen([args.binary, "batch", "jobs.jsonl", "--time", str(args.time), "-o", "killed", "--jobs", "2"],
                                   cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        # On average, each gets its part of the time that all lines take.
        time.sleep(dice.uniform(0.02, 2 * wall / times))
        process.send_signal(signal.SIGKILL)
        process.wait()
        # Half of the time the next command begins while workers of this one are still there.
        while dice.random() < 0.5 and at_work(folder):
            time.sleep(0.05)
        stamps = {file.name: file.stat().st_mtime_ns for file in out.glob("*.result.json")} if out.is_dir() else {}
        repeated += sum(stamps.get(name) != stamp for name, stamp in done.items())
        done = stamps
    print(f"       {len(done)} lines were done after {times} kills")
    run(args, folder, "-o", "killed", "--jobs", "2")
    repeated += sum((out / name).stat().st_mtime_ns != stamp for name, stamp in done.items())
    subprocess.run([args.binary, "batch", "merge", "killed"], cwd=folder, capture_output=True, check=False)
    expect(f"{times} kills: nothing is lost", alike(out, folder / "two"))
    expect(f"{times} kills: {repeated} finished lines were repeated", repeated == 0)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("binary", type=pathlib.Path, help="a release build")
    arguments.add_argument("-n", type=int, default=1000, help="lines (default 1000)")
    arguments.add_argument("--time", type=float, default=30, help="seconds for a line (default 30)")
    arguments.add_argument("--kills", type=int, default=10)
    arguments.add_argument("--shards", type=int, default=3)
    args = arguments.parse_args()
    args.binary = args.binary.resolve()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder).resolve()
        with (folder / "jobs.jsonl").open("w") as file:
            file.writelines(manifest.text_of(line) + "\n" for line in manifest.lines(args.n))
        begun = time.monotonic()
        whole(args, folder, args.n)
        wall = (time.monotonic() - begun) / 3
        shards(args, folder, args.shards)
        kills(args, folder, args.kills, wall)
    return 1 if FAILED else 0


if __name__ == "__main__":
    sys.exit(main())
