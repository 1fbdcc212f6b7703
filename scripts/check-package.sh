#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Makes the Debian package of what is built and tries it in a bare Debian 12,
# which has nothing but the package, what it depends on, cmake and make: the
# sample project builds and runs there. As root; takes a few minutes and 1.5 GB:
#   scripts/check-package.sh [FOLDER OF THE BARE DEBIAN]
# A folder that is there is used again.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "$(id -u)" -ne 0 ]; then
  echo "error: a bare Debian needs root; run it as root" >&2
  exit 1
fi
scripts/install-packages.sh debootstrap
work=$(mktemp -d)
bare=${1:-$work/debian}
trap 'umount -q "$bare/proc" || true; rm -rf "$work"' EXIT

(cd build && cpack -B "$work/package") >"$work/cpack.log" 2>&1 || {
  cat "$work/cpack.log" >&2
  exit 1
}
if [ ! -e "$bare/etc/debian_version" ]; then
  debootstrap --variant=minbase bookworm "$bare" \
    http://deb.debian.org/debian >"$work/debootstrap.log" || {
    tail -n 5 "$work/debootstrap.log" >&2
    exit 1
  }
  security=http://deb.debian.org/debian-security
  echo "deb $security bookworm-security main" \
    >"$bare/etc/apt/sources.list.d/security.list"
fi
rm -rf "$bare/root/"*
cp "$work"/package/*.deb "$bare/root/"
cp /etc/resolv.conf "$bare/etc/"
mountpoint -q "$bare/proc" || mount -t proc proc "$bare/proc"

chroot "$bare" bash -euo pipefail <<'EOF'
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
apt-get update -q >/dev/null
apt-get install -qy --reinstall --no-install-recommends \
  /root/*.deb cmake make >/root/apt.log 2>&1 || { tail -n 5 /root/apt.log; exit 1; }
for compiler in cc c++ gcc g++ clang clang++; do
  ! command -v $compiler || { echo "error: $compiler is there"; exit 1; }
done
cp -r /usr/share/doc/tp-toolchain/examples/sample-project /root/sample
cmake -S /root/sample -B /root/build \
  -DCMAKE_TOOLCHAIN_FILE=/usr/lib/cmake/TP/TPToolchain.cmake
cmake --build /root/build
ctest --test-dir /root/build --output-on-failure
cmake --build /root/build --target run-cornell
EOF
echo "the package works in a bare Debian 12"
