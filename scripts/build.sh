#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Installs what is missing and builds everything into build/ (or the given
# targets only): scripts/build.sh [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install-packages.sh
cmake --preset default >build-configure.log 2>&1 || {
  cat build-configure.log >&2
  exit 1
}
rm build-configure.log
cmake --build --preset default ${1:+--target "$@"}
