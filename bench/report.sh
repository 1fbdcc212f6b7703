#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Reruns the report's experiment from a fresh clone: installs what is missing
# (with matplotlib for the charts), builds, makes the scenes (but for --scenes)
# and runs bench/report.py with the given options.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install-packages.sh python3-matplotlib
scripts/build.sh tpcc tp-runtime tpsim
case " $* " in
*" --scenes "* | *" --from "* | *" --help "*) ;;
*) scripts/scenes.sh ;;
esac
# Debian's Python, which has Debian's matplotlib.
exec /usr/bin/python3 bench/report.py "$@"
