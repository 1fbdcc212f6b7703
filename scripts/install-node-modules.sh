#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Installs what the tests use from npm, in the versions of
# test/package-lock.json, into build/node/node_modules, unless it is there:
# scripts/install-node-modules.sh
set -euo pipefail
cd "$(dirname "$0")/.."

folder=build/node
installed=$folder/installed-lock.json
cmp -s test/package-lock.json "$installed" && exit 0

mkdir -p "$folder"
cp test/package.json test/package-lock.json "$folder"
echo "Installing npm packages into $folder"
npm ci --prefix "$folder" --prefer-offline --ignore-scripts --no-audit \
  --no-fund --loglevel=error >/dev/null || {
  echo "error: npm could not install the packages of test/package-lock.json;" \
    "the registry must be reachable once, or its cache be filled" >&2
  exit 1
}
cp test/package-lock.json "$installed"
