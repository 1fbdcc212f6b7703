#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Takes the pictures of the HTML report, docs/images/profile{,-source,-chip}.png,
# from a report that scripts/demo.sh has made:
#   scripts/profile-picture.sh [REPORT.html]
set -euo pipefail
cd "$(dirname "$0")/.."

report=${1:-out/conference_room.html}
if [ ! -f "$report" ]; then
  echo "error: $report is missing; run scripts/demo.sh first" >&2
  exit 1
fi
scripts/install-packages.sh
scripts/install-node-modules.sh
NODE_PATH=build/node/node_modules node scripts/profile_picture.js "$report" \
  docs/images/profile
