#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Installs the Debian packages that the build and the tests need, and the given
# ones, as far as they are missing. Prints what it installs; says nothing else:
# scripts/install-packages.sh [PACKAGE...]
set -euo pipefail

packages=(
  # Build
  cmake ninja-build clang-22 llvm-22-dev libclang-22-dev libstdc++-12-dev
  llvm-22 libtinygltf-dev libpng-dev python3
  # Tests
  llvm-22-tools libgtest-dev libgmock-dev libembree-dev csmith libcsmith-dev
  libclang-rt-22-dev lld-22 gcc g++ make file python3-jsonschema clangd-22 dpkg-dev chromium
  "$@"
)
# Node.js comes with npm from some places, from Debian without.
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null |
    grep -q '^install ok installed$' || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

if [ "$(id -u)" -ne 0 ]; then
  echo "error: these Debian packages are missing: ${missing[*]}" >&2
  echo "install them as root: apt-get install ${missing[*]}" >&2
  exit 1
fi
echo "Installing Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
apt-get update -q >/dev/null
apt-get install -qy --no-install-recommends "${missing[@]}" >/dev/null
