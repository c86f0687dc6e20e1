#!/usr/bin/env python3
"""Runs the commands on mutated programs, layouts, settings and requests, and compares what must agree.

    python3 tests/fuzz/commands.py --binary target/release/scenelang --cases 100000 [--seed 0] [--jobs 2]

For each case: the exit code is 0, 1 or 2; nothing panics; the input stays as it was; no temporary file is left; the time and
the memory are bounded. What must agree: the human and the JSON form in their exit code, two runs in every byte, a formatted
program with the program (the same constraints), formatting twice with formatting once, `solve` with one and two threads.

A case that breaks a rule is written to `--keep FOLDER` with the command that shows it. The same seed gives the same cases.
"""

import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MEMORY = 3 << 30
# Of a processor's time: on a machine that does other work, too, a clock says nothing. One that only waits is ended by HANGS.
SECONDS = 20
HANGS = 600
WILD = ["0", "-0", "-1", "1e300", "1e-300", "NaN", "1e999", "9007199254740993", "0.1", "4294967296", "1" * 400]
WORDS = """region object assert prefer forall exists in where and or not implies import let Number Bool Vec3 true false
inside on near far facing clear reachable visible gap distance connects count sum vec3 rot polygon rand room objects
<- = <= >= < > != + - * / % ( ) [ ] { } , ; : . .. // /* */ /// @req " ' \\ \u202e \u0000 \ufeff é 字 5cm 90deg""".split(" ")
REQUEST_WORDS = """a an the each every all both no except two 3 zero -2 1.5 half dozen beside under on near facing within
metres feet between without and or but not it them desk chair lamp window door room bed table shelf""".split()


def inputs():
    """Texts to start from, by kind."""
    scenes = sorted((ROOT / "examples").glob("*.scene")) + sorted((ROOT / "tests/work").glob("*.scene"))
    scenes += sorted((ROOT / "tests/problems/sample").rglob("*.scene"))
    layouts = sorted((ROOT / "crates").glob("*/tests/it/**/*.layout.json"))
    requests = sorted((ROOT / "tests/requests/development").glob("*.txt"))
    settings = ["physics = false\neta = 0.05\n[tolerances]\ncontact = 0.01\n", "[lints]\nW0601 = \"off\"\n[llm]\nmodel = \"none\"\n"]
    read = lambda files: [f.read_bytes() for f in files]
    found = {"scene": read(scenes), "layout": read(layouts), "request": read(requests)}
    found["settings"] = [s.encode() for s in settings]
    return found


def mutate(rng, texts, kind):
    """A text with one to six changes."""
    data = bytearray(rng.choice(texts))
    if len(data) > 6000:
        # A window of whole lines: long files make slow cases, not better ones.
        lines = bytes(data).split(b"\n")
        at = rng.randrange(max(1, len(lines) - 60))
        data = bytearray(b"\n".join(lines[:12] + lines[at : at + 60])) if kind != "layout" else data
    for _ in range(rng.randint(1, 6)):
        at = rng.randrange(len(data) + 1)
        what = rng.randrange(9)
        if what == 0 and data:
            data[at % len(data)] ^= 1 << rng.randrange(8)
        elif what == 1:
            del data[at : at + rng.randint(1, 40)]
        elif what == 2:
            end = at + rng.randint(1, 200)
            data[at:at] = data[at:end] * rng.randint(1, 4)
        elif what == 3:
            other = rng.choice(texts)
            start = rng.randrange(len(other) + 1)
            data[at:at] = other[start : start + rng.randint(1, 300)]
        elif what in (4, 5):
            word = rng.choice(REQUEST_WORDS if kind == "request" else WORDS)
            data[at:at] = f" {word} ".encode()
        elif what == 6:
            numbers = list(re.finditer(rb"-?\d+(\.\d+)?", bytes(data)))
            if numbers:
                hit = rng.choice(numbers)
                data[hit.start() : hit.end()] = rng.choice(WILD).encode()
        elif what == 7:
            lines = bytes(data).split(b"\n")
            rng.shuffle(lines) if rng.random() < 0.2 else lines.pop(rng.randrange(len(lines)))
            data = bytearray(b"\n".join(lines))
        else:
            names = re.findall(rb"[A-Za-z_]\w+", bytes(data))
            if len(names) > 1:
                data = bytearray(bytes(data).replace(rng.choice(names), rng.choice(names), rng.randint(1, 3)))
    return bytes(data)


class Broken(Exception):
    """A rule is broken."""


def run(binary, folder, *args):
    """Exit code and output of a command, after the rules that hold for all of them."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))

    try:
        done = subprocess.run([binary, *args], cwd=folder, capture_output=True, timeout=HANGS, preexec_fn=limit, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        raise Broken(f"{' '.join(args)}: not done after {HANGS} s")
    if done.returncode == -signal.SIGXCPU:
        raise Broken(f"{' '.join(args)}: not done after {SECONDS} s of processor time")
    if done.returncode not in (0, 1, 2):
        raise Broken(f"{' '.join(args)}: exit code {done.returncode}: {done.stderr[-400:]!r}")
    if b"panicked at" in done.stderr:
        raise Broken(f"{' '.join(args)}: {done.stderr[-400:]!r}")
    if any(folder.rglob("*.part")):
        raise Broken(f"{' '.join(args)}: a temporary file is left")
    return done.returncode, done.stdout, done.stderr


def agree(what, *values):
    if any(v != values[0] for v in values):
        raise Broken(f"{what}: {[str(v)[:200] for v in values]}")


def on_scene(rng, call, folder):
    draw = rng.randrange(40)
    if draw < 12:
        human, as_json = call("check", "a.scene"), call("check", "a.scene", "--format", "json")
        agree("exit codes of the human and the JSON form", human[0], as_json[0])
        if as_json[1]:
            json.loads(as_json[1])
    elif draw < 22:
        before = call("constraints", "a.scene")
        formatted = call("fmt", "a.scene")
        once = (folder / "a.scene").read_bytes()
        if formatted[0] == 0:
            after = call("constraints", "a.scene")
            # Places change with the format; what is said does not.
            said = [re.sub(rb"(?m)^a\.scene:\d+:\d+: ", b"", out) for _, out, _ in (before, after)]
            agree("constraints before and after formatting", *said) if before[0] == 0 else None
            call("fmt", "a.scene")
            agree("formatting twice and once", once, (folder / "a.scene").read_bytes())
    elif draw < 28:
        agree("two runs of check", call("check", "a.scene", "--all"), call("check", "a.scene", "--all"))
    elif draw < 33:
        call("syntax", "a.scene"), call("hir", "a.scene")
    elif draw < 36:
        call("trace", "a.scene", "--format", "json")
    elif draw < 38:
        fixed = call("check", "--fix", "a.scene")
        again = call("check", "a.scene")
        if fixed[0] == 0:
            agree("a fixed program has no findings", again[0], 0)
    else:
        one = call("solve", "a.scene", "--time", "2", "--threads", "1", "-o", "one.json")
        if b"the time limit was reached" not in one[1] + one[2]:
            two = call("solve", "a.scene", "--time", "2", "--threads", "2", "-o", "two.json")
            outputs = [folder / f for f in ("one.json", "two.json")]
            if all(f.exists() for f in outputs) and b"the time limit was reached" not in two[1] + two[2]:
                agree("layouts of one and two threads", *(f.read_bytes() for f in outputs))


def on_layout(rng, call, folder):
    draw = rng.randrange(20)
    if draw < 10:
        human, as_json = call("check", "room.layout.json"), call("check", "room.layout.json", "--format", "json")
        agree("exit codes of the human and the JSON form", human[0], as_json[0])
    elif draw < 14:
        agree("two runs of check", call("check", "room.layout.json"), call("check", "room.layout.json"))
    elif draw < 16:
        call("diff", "room.layout.json", "other.layout.json")
    elif draw < 18:
        call("repair", "room.layout.json", "--dry-run")
    elif draw < 19:
        call("export", "room.layout.json", "--only", "plan,glb")
    else:
        call("check", "room.layout.json", "--format", rng.choice(["sarif", "junit", "github"]))


def on_request(rng, call, folder):
    one = call("formalize", "-f", "request.txt", "--untried", "-o", "one.scene")
    two = call("formalize", "-f", "request.txt", "--untried", "-o", "two.scene")
    agree("exit codes of two readings", one[0], two[0])
    if (folder / "one.scene").exists():
        agree("two readings", (folder / "one.scene").read_bytes(), (folder / "two.scene").read_bytes())
        if call("check", "one.scene")[0] == 2:
            raise Broken("the program of a request does not compile")


def case(binary, texts, seed, keep):
    """One case; what it breaks, or nothing."""
    rng = random.Random(seed)
    kind = rng.choices(["scene", "layout", "settings", "request"], [60, 20, 8, 12])[0]
    data = mutate(rng, texts[kind], kind)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        room = ROOT / "crates/lsp/tests/it/room"
        file = {"scene": "a.scene", "layout": "room.layout.json", "settings": "scenelang.toml", "request": "request.txt"}[kind]
        if kind in ("layout", "settings"):
            for source in room.iterdir():
                shutil.copy(source, folder)
            shutil.copy(room / "room.layout.json", folder / "other.layout.json")
        (folder / file).write_bytes(data)
        call = lambda *args: run(binary, folder, *args)
        try:
            if kind == "scene":
                on_scene(rng, call, folder)
            elif kind == "request":
                on_request(rng, call, folder)
            else:
                on_layout(rng, call, folder)
                if (folder / file).read_bytes() != data:
                    raise Broken("the input was changed")
        except Broken as broken:
            at = keep / f"{seed}-{hashlib.sha256(str(broken).encode()).hexdigest()[:6]}"
            at.mkdir(parents=True, exist_ok=True)
            (at / file).write_bytes(data)
            (at / "why.txt").write_text(f"{broken}\n")
            return f"{at.name} ({kind}): {broken}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--binary", default=str(ROOT / "target/release/scenelang"))
    parser.add_argument("--cases", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=pathlib.Path, default=ROOT / "out/fuzz")
    args = parser.parse_args()
    binary, texts = str(pathlib.Path(args.binary).resolve()), inputs()
    broken = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        jobs = (range(args.seed + at, args.seed + min(at + 500, args.cases)) for at in range(0, args.cases, 500))
        for seeds in jobs:
            for said in pool.map(lambda seed: case(binary, texts, seed, args.keep), seeds):
                if said:
                    broken += 1
                    print(said, flush=True)
            if sys.stderr.isatty():
                print(f"\r{seeds.stop - args.seed} of {args.cases}", end="", file=sys.stderr)
    print(f"{args.cases} cases, {broken} broken rules")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
