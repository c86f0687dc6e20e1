"""Runs the steps of `action.yml` as GitHub would on a pull request, with a `gh` that writes down what it is asked to do:

    try-action.py --wheel FILE --base COMMIT [--comment ID] [--fork]

The current folder is the repository. Prints the exit code of each step that ran and the requests, one JSON a line. What other
actions do, such as uploading artifacts, is left out. Needs PyYAML, and knows only the expressions that the action uses.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[1]
# It writes down what it is asked, with the content of the files that it is given.
GH = """#!{python}
import json, os, sys
said = [open(a.split("=@")[1]).read() if "=@" in a else a for a in sys.argv[1:]]
with open(os.environ["ASKED"], "a") as out:
    out.write(json.dumps(said) + "\\n")
if "--paginate" in sys.argv:
    print(os.environ["COMMENT"])
"""


class Found(dict):
    """A value of GitHub's: what is missing is empty."""

    def __missing__(self, key):
        return Found()

    def __bool__(self):
        return len(self) > 0

    def __str__(self):
        return json.dumps(self) if self else ""


def found(value):
    return Found({k: found(v) for k, v in value.items()}) if isinstance(value, dict) else value


def truth(value):
    return value not in ("", None, False) and bool(value)


def value_of(expression, known):
    """The value of an expression: names, texts, `format`, `!`, `==`, `!=`, `&&`, `||`."""
    tokens = re.findall(r"'[^']*'|&&|\|\||==|!=|!|[(),]|[\w.-]+", expression)
    at = 0

    def take(*wanted):
        nonlocal at
        if at < len(tokens) and tokens[at] in wanted:
            at += 1
            return tokens[at - 1]
        return None

    def one():
        nonlocal at
        if take("!"):
            return not truth(one())
        token = tokens[at]
        at += 1
        if token == "(":
            inner = either()
            take(")")
            return inner
        if token.startswith("'"):
            return token[1:-1]
        if take("("):
            arguments = []
            while not take(")"):
                arguments.append(either())
                take(",")
            if token != "format":
                sys.exit(f"error: the function {token} is not known here")
            return re.sub(r"\{(\d+)\}", lambda i: text_of(arguments[1 + int(i[1])]), arguments[0])
        value = known
        for part in token.split("."):
            value = value[part] if isinstance(value, dict) else Found()
        return value

    def compared():
        left = one()
        while sign := take("==", "!="):
            left = (text_of(left) == text_of(one())) == (sign == "==")
        return left

    def both():
        left = compared()
        while take("&&"):
            right = compared()
            left = right if truth(left) else left
        return left

    def either():
        left = both()
        while take("||"):
            right = both()
            left = left if truth(left) else right
        return left

    return either()


def text_of(value):
    return str(value).lower() if isinstance(value, bool) else str(value)


def filled(text, known):
    return re.sub(r"\$\{\{(.*?)\}\}", lambda part: text_of(value_of(part[1], known)), str(text))


def ran(step, known, temp, comment):
    """Runs one step; its exit code."""
    output = temp / "output"
    output.write_text("")
    values = {name: filled(value, known) for name, value in step.get("env", {}).items()}
    values |= {
        "PATH": f"{temp}{os.pathsep}{os.environ['PATH']}",
        "ASKED": str(temp / "asked"),
        "COMMENT": comment,
        "RUNNER_TEMP": str(temp),
        "GITHUB_ACTION_PATH": str(ROOT),
        "GITHUB_OUTPUT": str(output),
        "GITHUB_REPOSITORY": known["github"]["repository"],
    }
    ended = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]], env={**os.environ, **values})
    if "id" in step:
        lines = (line.split("=", 1) for line in output.read_text().splitlines())
        known["steps"][step["id"]] = Found(outputs=Found(lines))
    return ended.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--wheel", required=True)
    parser.add_argument("--base", required=True)
    parser.add_argument("--comment", default="", help="the comment that is there already")
    parser.add_argument("--fork", action="store_true")
    args = parser.parse_args()
    action = yaml.safe_load((ROOT / "action.yml").read_text())
    head = {"sha": "c0ffee", "repo": {"full_name": "someone/fork" if args.fork else "a/b"}}
    pull = {"number": "7", "base": {"sha": args.base}, "head": head}
    github = {"event": {"pull_request": pull}, "repository": "a/b", "token": "t", "job": "scenes"}
    inputs = {name: about.get("default", "") for name, about in action["inputs"].items()} | {"wheel": args.wheel}
    known = found({"github": github, "inputs": inputs, "steps": {}})
    with tempfile.TemporaryDirectory() as made:
        temp = Path(made)
        (temp / "gh").write_text(GH.format(python=sys.executable))
        (temp / "gh").chmod(0o755)
        for step in action["runs"]["steps"]:
            if "if" in step and not truth(value_of(step["if"], known)):
                continue
            if "uses" in step:
                known["steps"][step["id"]] = found({"outputs": {"artifact-url": "https://example.org/plans.zip"}})
                continue
            code = ran(step, known, temp, args.comment)
            print(f"{step['name']}: {code}")
            if code != 0:
                break
        asked = temp / "asked"
        print(asked.read_text() if asked.exists() else "", end="")


if __name__ == "__main__":
    main()
