#!/usr/bin/env bash
# The action and the hooks on a repository made for it: try-repository.sh FOLDER, with the wheel in FOLDER.
# The parts of the action that speak to GitHub are left out. pre-commit is tried where pip can install it.
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
! grep -q other.scene "$scratch/out/comment.md" # it was not changed
[ -z "$(git worktree list | sed 1d)" ]
say "the action says what changed"

if ! "$scratch/venv/bin/python" -m pip install --quiet --disable-pip-version-check pre-commit==4.5.0 2>/dev/null; then
    say "note: pip cannot install pre-commit, so the hooks are not tried"
    exit 0
fi
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
