#!/usr/bin/env bash
# The action and the hooks on a repository made for it: try-repository.sh FOLDER, with the wheel in FOLDER.
# GitHub is played by a script that writes down what it is asked. That, and pre-commit, are tried where pip can install pre-commit.
set -euo pipefail
folder=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b

python3 -m venv "$scratch/venv"
"$scratch/venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-index --find-links "$folder" --no-deps scenelang
scenelang=$scratch/venv/bin/scenelang

mkdir "$scratch/repo" && cd "$scratch/repo" && git init --quiet
printf 'object desk;\ndesk.scale <- vec3(1, 0.7, 0.6);\nassert desk.pos.x > 1;\n' > room.scene
"$scenelang" solve room.scene >/dev/null
printf 'object bed;\nbed.scale <- vec3(1, 1, 2);\n' > other.scene
git add . && git commit --quiet -m one
base=$(git rev-parse HEAD)

say() { printf '%s\n' "$*"; }
expect() { grep -qF -- "$1" "$2" || { say "error: \"$1\" is not in $2:" >&2; cat "$2" >&2; exit 1; }; }
without() { ! grep -qF -- "$1" "$2" || { say "error: \"$1\" is in $2:" >&2; cat "$2" >&2; exit 1; }; }
check() { python3 "$root/packaging/action/check.py" --scenelang "$scenelang" --base "$base" --output "$scratch/out"; }

check
expect "No scene was changed" "$scratch/out/comment.md"
sed -i.old 's/> 1/> 9/' room.scene && rm room.scene.old
git commit --quiet -am two
GITHUB_OUTPUT=$scratch/outputs check
expect "verdict=1" "$scratch/outputs"
expect "desk.pos.x > 9" "$scratch/out/comment.md"
expect '"V0101"' "$scratch/out/scenelang.sarif"
[ -f "$scratch/out/plans/room.layout.json.before.png" ] && [ -f "$scratch/out/plans/room.layout.json.after.png" ]
without other.scene "$scratch/out/comment.md" # it was not changed
[ -z "$(git worktree list | sed 1d)" ]
say "the action says what changed"

if ! "$scratch/venv/bin/python" -m pip install --quiet --disable-pip-version-check pre-commit==4.5.0 2>/dev/null; then
    say "note: pip cannot install pre-commit, so neither the steps of the action nor the hooks are tried"
    exit 0
fi

# pre-commit brings the reader of YAML along.
action() { "$scratch/venv/bin/python" "$root/packaging/try-action.py" --wheel "$(ls "$folder"/scenelang-*-abi3-*.whl)" --base "$@" > "$scratch/said"; }
action "$base"
expect '"repos/a/b/code-scanning/sarifs", "--silent", "-f", "commit_sha=c0ffee", "-f", "ref=refs/pull/7/head", "-F"' "$scratch/said"
expect '"repos/a/b/issues/7/comments", "-F", "<!-- scenelang -->' "$scratch/said"
expect 'Plans before and after: [download](https://example.org/plans.zip)' "$scratch/said"
expect 'Verdict: 1' "$scratch/said"
action "$base" --fork
without '["api"' "$scratch/said" # its token may not write
expect 'Verdict: 1' "$scratch/said"
action HEAD # in which no scene differs
without '"-F"' "$scratch/said"
without Verdict "$scratch/said"
action HEAD --comment 12
expect '"--method", "PATCH", "repos/a/b/issues/comments/12", "-F", "<!-- scenelang -->' "$scratch/said"
expect 'No scene was changed' "$scratch/said"
action 0123456789012345678901234567890123456789 2> "$scratch/complaint"
expect 'fetch-depth: 0' "$scratch/complaint"
say "the steps of the action ask GitHub for the comment and the findings"

cp -R "$root/packaging/pre-commit" "$scratch/hooks"
(cd "$scratch/hooks" && git init --quiet && git add . && git commit --quiet -m hooks && git tag v0.1.0)
cat > .pre-commit-config.yaml <<YAML
repos:
  - repo: $scratch/hooks
    rev: v0.1.0
    hooks: [{ id: scenelang-check }, { id: scenelang-fmt }]
YAML
git add . && export PIP_FIND_LINKS=$folder PRE_COMMIT_HOME=$scratch/cache
if "$scratch/venv/bin/pre-commit" run --all-files > "$scratch/said" 2>&1; then
    say "error: the hook let a layout pass that does not hold" >&2
    exit 1
fi
expect "V0101" "$scratch/said"
"$scenelang" solve room.scene --force >/dev/null && git add .
"$scratch/venv/bin/pre-commit" run --all-files > "$scratch/said" 2>&1 || { cat "$scratch/said" >&2; exit 1; }
say "the hooks stop what does not hold"
