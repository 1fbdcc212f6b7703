#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Writes the conference-like room of 319,924 triangles, unless it is there:
#   scripts/conference-room.sh [FILE.glb]     (default out/conference_room.glb)
# Fetches Debian's package sweethome3d-furniture (120 MB) for the chairs and
# tables, CC-BY 3.0; see scenes/README.md for whom to credit. Nothing is
# installed.
set -euo pipefail
cd "$(dirname "$0")/.."

[ $# -le 1 ] || { sed -n '5,8s/^# \{0,1\}//p' "$0" >&2; exit 1; }
target=${1:-out/conference_room.glb}
[ -f "$target" ] && exit 0
mkdir -p "$(dirname "$target")"
target=$(realpath "$target")
scene_script=$PWD/scenes/conference_room/make_conference_room.py

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# apt-get download drops its privileges and must be able to write there.
chmod 755 "$work"
cd "$work"
apt-get download -q sweethome3d-furniture >download.log 2>&1 || {
  cat download.log >&2
  echo "error: cannot download the Debian package sweethome3d-furniture" >&2
  exit 1
}
dpkg-deb -x sweethome3d-furniture_*.deb package
python3 "$scene_script" package/usr/share/sweethome3d/furniture "$target"
