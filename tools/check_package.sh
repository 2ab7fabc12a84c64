#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Installs a .deb into a bare system in a folder, and renders there: does it name all that it needs?
#
#   tools/check_package.sh FILE.deb [SUITE]   SUITE: bookworm by default, the one that it was built on
#
# Needs root, debootstrap and the network; takes two minutes.
set -euo pipefail

[[ $# -ge 1 ]] || { sed -n '5,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 2; }
suite="${2:-bookworm}"
root="$(mktemp -d)"
trap 'rm -rf "$root"' EXIT

debootstrap --variant=minbase "$suite" "$root" >"$root.log" || { tail "$root.log"; exit 1; }
rm -f "$root.log"
cp "$1" "$root/tmp/openltc.deb"
cp "$(dirname "${BASH_SOURCE[0]}")/../scenes/demo.glb" "$root/tmp"
chroot "$root" sh -euc '
  apt-get install -y -q --no-install-recommends /tmp/openltc.deb >/tmp/log 2>&1 || { tail /tmp/log; exit 1; }
  cd /tmp
  openltc --version
  openltc render demo.glb --size 160x90 --quiet -o picture.png -o picture.exr
  openltc inspect picture.exr
  openltc plot polygon --quiet -o figure.png
  apt-get remove -y -q openltc >/tmp/log 2>&1
  test ! -e /usr/bin/openltc'
echo "check_package: installed, ran, removed"
