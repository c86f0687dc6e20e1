"""What the action says of a change: SARIF, plans before and after, and one comment.

    check.py --scenelang BINARY --base COMMIT --output FOLDER [--files "a.scene b/"]

Without --files, the programs and layouts that differ between COMMIT and what is checked out. Writes scenelang.sarif,
comment.md and plans/ into FOLDER. The exit code is 0 whenever the change could be looked at; what was found is the output
`verdict`: 0 good, 1 findings, 2 not judged.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

MARK = "<!-- scenelang -->"
ENDS = (".scene", ".layout.json")
# A comment may have 65536 characters.
SCENES, LINES = 30, 12
NOTHING = "0" * 40


def git(*args):
    return subprocess.run(["git", *args], check=True, capture_output=True).stdout


def run(binary, *args, cwd=None):
    return subprocess.run([binary, *args], capture_output=True, text=True, cwd=cwd)


def known(base):
    """A commit to compare with, or nothing where there is none."""
    if base in ("", NOTHING):
        return ""
    if subprocess.run(["git", "cat-file", "-e", f"{base}^{{commit}}"], capture_output=True).returncode != 0:
        sys.exit(f"error: the commit {base} is not in this clone; let actions/checkout fetch all commits, with `fetch-depth: 0`")
    return base


def changed(base):
    """Files that are there now and differ; all, where there is nothing to compare with."""
    names = git("diff", "--name-only", "-z", "--diff-filter=d", base, "--") if base else git("ls-files", "-z")
    return sorted(name for name in names.decode().split("\0") if name.endswith(ENDS))


def judged(name):
    """What is judged of a changed file: the layout beside a program, if it has one."""
    layout = Path(name).with_suffix(".layout.json") if name.endswith(".scene") else Path(name)
    return str(layout) if layout.is_file() else name


def report(binary, name, cwd=None):
    ended = run(binary, "check", "--format", "json", "--", name, cwd=cwd)
    try:
        return json.loads(ended.stdout.splitlines()[0])
    except (IndexError, ValueError):
        return None


def rows(found):
    """Constraints by what finds them again where lines have moved: kind and text, and which of several equal ones."""
    out, seen = {}, {}
    for row in (found or {}).get("constraints", []):
        key = (row["kind"], row["id"] if row.get("rule") else " ".join(row["text"].split()))
        seen[key] = seen.get(key, 0) + 1
        out[(*key, seen[key])] = row
    return out


def said(row):
    margin, unit = row.get("margin"), "°" if row.get("unit") == "deg" else " m"
    holds = {True: "holds", False: "fails", None: "cannot be checked"}[row.get("satisfied")]
    return holds if margin is None else f"{holds} by {abs(margin):.3f}{unit}"


def plan(binary, name, to, cwd=None):
    """The plan of a layout, if it has one."""
    if not name.endswith(".layout.json"):
        return False
    with tempfile.TemporaryDirectory() as folder:
        run(binary, "export", "--only", "plan", "-o", folder, "--", name, cwd=cwd)
        drawn = Path(folder) / "plan.png"
        if drawn.is_file():
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_bytes(drawn.read_bytes())
        return drawn.is_file()


def code(text):
    """Text of a file that cannot act as Markdown."""
    return "`" + " ".join(text.split()).replace("`", "'") + "`"


def section(binary, name, before, plans):
    now, was = report(binary, name), report(binary, name, cwd=before) if before else None
    if now is None:
        return f"### {code(name)}\n\ncould not be checked\n", []
    lines = []
    old, new = rows(was), rows(now)
    for key, row in new.items():
        other = old.get(key)
        if other is not None and other.get("satisfied") != row.get("satisfied"):
            lines.append(f"- {code(key[1])}: {said(other)} → **{said(row)}**")
        elif row.get("satisfied") is False and row["kind"] != "prefer":
            lines.append(f"- {code(key[1])}: **{said(row)}**: {code(row['message'])}")
    for finding in now.get("diagnostics", []):
        at = finding.get("span")
        place = f" ({code(at['file'])}, line {at['start'][0]})" if at else ""
        lines.append(f"- {finding['code']}{place}: {code(finding['message'])}")
    drawn = [
        which
        for which, folder in (("before", before), ("after", None))
        if (which == "after" or folder) and plan(binary, name, plans / f"{name.replace('/', '-')}.{which}.png", folder)
    ]
    more = len(lines) - LINES
    head = f"### {'✅' if now['ok'] else '❌'} {code(name)}\n"
    good = "all of it holds" if name.endswith(".layout.json") else "nothing was found; there is no layout beside it"
    text = "\n".join(lines[:LINES]) or good
    return f"{head}\n{text}\n" + (f"- and {more} more\n" if more > 0 else ""), drawn


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenelang", required=True)
    parser.add_argument("--base", default="")
    parser.add_argument("--output", required=True, type=Path)
    parser.add_argument("--files", default="")
    args = parser.parse_args()
    binary = str(Path(args.scenelang).absolute())
    base = known(args.base)
    plans = args.output / "plans"
    args.output.mkdir(parents=True, exist_ok=True)
    named = args.files.split() or changed(base)
    files = list(dict.fromkeys(judged(name) for name in named))
    comment, sarif = args.output / "comment.md", args.output / "scenelang.sarif"
    parts, drawn, worst = [], [], 0
    if files:
        ended = run(binary, "check", "--format", "sarif", "--", *files)
        worst = ended.returncode
        sarif.write_text(ended.stdout)
    else:
        sarif.write_text(json.dumps({"version": "2.1.0", "runs": []}))
    with tempfile.TemporaryDirectory() as folder:
        before = None
        if base:
            before = Path(folder) / "before"
            git("worktree", "add", "--quiet", "--detach", str(before), base)
        try:
            for name in files[:SCENES]:
                text, which = section(binary, name, before, plans)
                parts.append(text)
                drawn += which
        finally:
            if before:
                git("worktree", "remove", "--force", str(before))
    if len(files) > SCENES:
        parts.append(f"and {len(files) - SCENES} more files\n")
    title = "## Scenes\n\n" if files else "## Scenes\n\nNo scene was changed.\n"
    comment.write_text(f"{MARK}\n{title}" + "\n".join(parts))
    outputs = {"comment": comment, "sarif": sarif, "plans": plans, "drawn": str(bool(drawn)).lower(), "files": len(files), "verdict": worst}
    for name, value in outputs.items():
        if "GITHUB_OUTPUT" in os.environ:
            with open(os.environ["GITHUB_OUTPUT"], "a") as out:
                out.write(f"{name}={value}\n")
    if "GITHUB_STEP_SUMMARY" in os.environ:
        with open(os.environ["GITHUB_STEP_SUMMARY"], "a") as out:
            out.write(comment.read_text())
    print(f"{len(files)} files looked at, verdict {worst}")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as e:
        sys.exit(f"error: {' '.join(map(str, e.cmd))}: {e.stderr.decode(errors='replace').strip()}")
