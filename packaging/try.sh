#!/usr/bin/env bash
# Installs what was packed for this machine into empty environments, and furnishes a room with each: try.sh FOLDER
# No registry is asked: what is installed has no dependencies but its own.
set -euo pipefail
folder=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/.." && pwd)
empty=$(mktemp -d)
trap 'rm -rf "$empty"' EXIT

# The program of a sentence, its layout, its files: the corridor, on the binary that was installed.
furnish() {
    (cd "$empty" && "$@" synth "a study with a desk" -o "room-$RANDOM" --only glb,plan >/dev/null)
    printf '%s furnishes a room\n' "$1"
}

python=$(command -v python3 || command -v python)
"$python" -m venv "$empty/venv"
bin=$empty/venv/bin
[ -d "$bin" ] || bin=$empty/venv/Scripts
"$bin/python" -m pip install --quiet --disable-pip-version-check --no-index --find-links "$folder" --no-deps scenelang
furnish "$bin/scenelang"
(cd "$empty" && "$bin/python" - <<'PY'
import scenelang
program = scenelang.formalize("a study with a desk").program
layout = scenelang.solve(program).layout
evaluator = scenelang.Evaluator(program, layout)
assert all(evaluator.holds(evaluator.poses()).tolist()[i] for i, c in enumerate(evaluator.columns) if c["kind"] != "prefer")
assert all(row["margin"] is None or row["satisfied"] is not None for row in scenelang.check(program, layout).rows())
print(f"import scenelang furnishes a room: {len(layout.objects)} objects")
PY
)

"$python" "$root/packaging/pack.py" npm -o "$empty/npm" >/dev/null
(cd "$empty" && npm install --prefix "$empty/prefix" --offline --no-audit --no-fund --silent --omit=optional "$empty"/npm/*.tgz)
if (cd "$empty" && npx --prefix "$empty/prefix" --no-install scenelang --version) >/dev/null 2>&1; then
    echo "error: without the package of the platform there is something that runs" >&2
    exit 1
fi
(cd "$empty" && npm install --prefix "$empty/prefix" --offline --no-audit --no-fund --silent --omit=optional "$folder"/scenelang-*-*-[0-9]*.tgz)
furnish "$empty/prefix/node_modules/.bin/scenelang"

# A container tool is not needed: what the recipe of the image says is followed step by step.
if [ "$(uname -s)" = Linux ]; then
    "$python" "$root/packaging/try-image.py" "$folder"
fi
