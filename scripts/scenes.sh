#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Writes the large scenes, unless they are there, as out/scenes/NAME.glb:
#   scripts/scenes.sh [--output DIR] [--packages DIR] [NAME...]
# NAME: bunny, maple, conference_room, engine or hairball (default: all).
# Their models come from Debian packages, which are downloaded but not
# installed; see scenes/README.md for licences and whom to credit. With
# --packages, the downloaded packages stay in that folder, and those that are
# already there are used.
set -euo pipefail

usage() { sed -n '4,10s/^# \{0,1\}//p' "$0"; }
fail() { echo "error: $*" >&2; exit 1; }

package_of() {
  case $1 in
  bunny) echo glmark2-data ;;
  maple | conference_room) echo sweethome3d-furniture ;;
  engine) echo assimp-testmodels ;;
  hairball) echo embree-tools ;;
  *) fail "there is no scene '$1'; --help lists them" ;;
  esac
}

# The package's newest file in the folder of packages, else a downloaded one.
find_package() {
  local found
  found=$(find "$packages" -name "$1_*.deb" | sort -V | tail -n 1)
  if [ -z "$found" ]; then
    (cd "$packages" && apt-get download -q "$1") >"$work/log" 2>&1 || {
      cat "$work/log" >&2
      fail "cannot download the Debian package $1; put its .deb file into a" \
        "folder and name that with --packages"
    }
    found=$(find "$packages" -name "$1_*.deb")
  fi
  echo "$found"
}

# Unpacks a package once.
unpack() {
  local file
  [ -d "$work/$1" ] && return
  file=$(find_package "$1")
  dpkg-deb -x "$file" "$work/$1.part" 2>"$work/log" || {
    cat "$work/log" >&2
    fail "$file: not a complete Debian package; delete it and try again"
  }
  mv "$work/$1.part" "$work/$1"
}

root=$(dirname "$(dirname "$(realpath "$0")")")
output=$root/out/scenes
packages=
names=()
while [ $# -ne 0 ]; do
  case $1 in
  --output | --packages)
    [ $# -ge 2 ] || fail "$1 needs a folder; --help lists the options"
    if [ "$1" = --output ]; then output=$2; else packages=$2; fi
    shift
    ;;
  --help) usage; exit 0 ;;
  -*) fail "unknown option '$1'; --help lists the options" ;;
  *) package_of "$1" >/dev/null; names+=("$1") ;;
  esac
  shift
done
[ ${#names[@]} -ne 0 ] || names=(bunny maple conference_room engine hairball)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# apt-get download drops its privileges and must be able to read there.
chmod 755 "$work"
packages=${packages:-$work}
mkdir -p "$output" "$packages"

for name in "${names[@]}"; do
  target=$output/$name.glb
  [ -f "$target" ] && continue
  package=$(package_of "$name")
  unpack "$package"
  python3 "$root/scenes/$name/make_$name.py" "$work/$package" "$work/$name.glb"
  mv "$work/$name.glb" "$target"
  echo "wrote $target"
done
