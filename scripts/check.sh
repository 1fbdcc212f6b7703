#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# The test command: installs what is missing, builds, runs every test.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/build.sh
scripts/install-node-modules.sh
ctest --preset default -j "$(nproc)"
