#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Runs kernels on chips with either engine, with 1, 2, 3 and 7 threads of the
# host, and saved and restored in the middle, and compares results, output and
# statistics byte for byte:
#   scripts/determinism-campaign.sh [option of determinism_campaign.py...]
# Exit status 1 if a byte differs.
set -euo pipefail
exec python3 "$(dirname "$0")/determinism_campaign.py" "$@"
