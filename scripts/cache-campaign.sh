#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Renders every scene from a cached tree, with caches of every size, policy and
# format, on the simulated chip and natively, and compares each picture with the
# baseline's; then a frame with 16 slots whose every deletion is verified:
#   scripts/cache-campaign.sh [option of cache_campaign.py...]
# Fetches the large scenes (scripts/scenes.sh). Exit status 1 if a picture
# differs or a rule of the cache is broken.
set -euo pipefail
cd "$(dirname "$0")/.."

case " $* " in
*" --scenes "* | *" --help "*) ;;
*) scripts/scenes.sh ;;
esac
exec python3 scripts/cache_campaign.py "$@"
