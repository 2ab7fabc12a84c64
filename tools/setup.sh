#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# Installs the system packages of tools/packages.txt on Debian 12+ and Ubuntu 22.04+.
#
#   tools/setup.sh          install what is missing, as root or through sudo
#   tools/setup.sh --list   print the list
#
# Quick and silent about the network when everything is there. On another system it prints what is
# needed and stops with exit code 1. OPENLTC_SKIP_SETUP=1 leaves the whole step out.
set -euo pipefail

list="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/packages.txt"

fail() {
  echo "setup: $*" >&2
  exit 1
}

# Prints the entries of the list without comments: [?]package[=command].
entries() { sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$list"; }

is_installed() { # package command
  if [[ -n "$2" ]] && command -v "$2" >/dev/null; then
    return 0
  fi
  [[ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

# True when apt knows a version that it could install.
is_available() { [[ "$(apt-cache policy "$1" 2>/dev/null)" =~ Candidate:\ [^\(] ]]; }

is_supported_system() {
  local file="${OPENLTC_OS_RELEASE:-/etc/os-release}" id version # another file: for the tests
  [[ -r "$file" ]] || return 1
  id="$(unset ID; . "$file"; echo "${ID:-}")"
  version="$(unset VERSION_ID; . "$file"; echo "${VERSION_ID:-999}")" # Debian testing has no number
  case "$id" in
    debian) [[ "${version%%.*}" -ge 12 ]] ;;
    ubuntu) [[ "${version%%.*}" -ge 22 ]] ;;
    *) return 1 ;;
  esac
}

# Fills `needed` and `optional` with what is not installed.
find_missing() {
  needed=() optional=()
  local entry package command
  while read -r entry; do
    package="${entry#\?}"
    command=""
    if [[ "$package" == *=* ]]; then
      command="${package#*=}"
      package="${package%%=*}"
    fi
    if ! is_installed "$package" "$command"; then
      if [[ "$entry" == \?* ]]; then optional+=("$package"); else needed+=("$package"); fi
    fi
  done <<<"$(entries)"
}

as_root() {
  if [[ "$(id -u)" == 0 ]]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "this needs root and there is no sudo; as root, run: $*"
  fi
}

apt_get() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -y -q -o DPkg::Lock::Timeout=300 "$@"
}

case "${1:-}" in
  --list) cat "$list"; exit 0 ;;
  -h | --help) sed -n '5,11s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
  "") ;;
  *) echo "setup: unknown option '$1'; there are --list and --help" >&2; exit 2 ;;
esac

if [[ "${OPENLTC_SKIP_SETUP:-0}" == 1 ]]; then
  echo "setup: left out (OPENLTC_SKIP_SETUP=1)"
  exit 0
fi

if ! is_supported_system; then
  echo "setup: packages are installed on Debian 12+ and Ubuntu 22.04+ only. On this system please"
  echo "install the counterparts of the following, then set OPENLTC_SKIP_SETUP=1:"
  echo
  cat "$list"
  exit 1
fi

find_missing
if [[ ${#needed[@]} -gt 0 ]]; then
  echo "setup: installing ${needed[*]}"
  apt_get update || fail "apt-get update failed; is the network reachable?"
  for package in "${needed[@]}"; do
    is_available "$package" || fail "no package '$package' in this system's sources
(on Ubuntu enable 'universe': sudo add-apt-repository universe)"
  done
  apt_get install --no-install-recommends "${needed[@]}" ||
    fail "apt-get could not install the packages; the reason stands above"
fi

# An optional package never makes the setup fail.
for package in "${optional[@]}"; do
  purpose="$(sed -n "s/^?$package[=[:space:]][^#]*# *//p" "$list")"
  if ! is_available "$package"; then
    echo "setup: $package skipped, this system has no such package ($purpose)"
  elif ! apt_get install --no-install-recommends "$package"; then
    echo "setup: $package skipped, it could not be installed ($purpose)"
  fi
done

find_missing
[[ ${#needed[@]} -eq 0 ]] || fail "still missing: ${needed[*]}"
echo "setup: all packages are installed"
