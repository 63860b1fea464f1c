#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Tests the packages that Module/package.sh has made: lintian reports no errors. On a bare system of
# this release, which debootstrap installs, the packages can be installed, draw pictures, are
# upgraded and removed. The script needs root, and is skipped without it (exit code 125).
#
#   bash Testing/Packages/run.sh [--no-install] [FOLDER]
#
#   --no-install   do not install packages
#
# FOLDER contains the systems (default: build-package/test). Later runs reuse the bare system.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
packages=${RELEVO_PACKAGE_BUILD_DIR:-$source_dir/build-package}
install=yes
if [ "${1:-}" = --no-install ]; then
  install=no
  shift
fi
folder=${1:-$packages/test}

skip() {
  echo "skipped: $*"
  exit 125
}
fail() {
  echo "run.sh: error: $*" >&2
  exit 1
}
[ "$(id -u)" -eq 0 ] || skip "debootstrap and chroot need root"
ls "$packages"/python3-relevo_*.deb >/dev/null 2>&1 || skip "run Module/package.sh first"
if [ $install = yes ]; then
  . "$source_dir/Module/packages.sh"
  install_packages debootstrap lintian
fi
for program in debootstrap lintian unshare; do
  command -v $program >/dev/null || skip "there is no $program"
done

# Runs a command in the folder $1. The mounts end with the process that made them.
in_root() {
  root=$1 unshare --mount bash -euc '
    mount --rbind /dev "$root/dev"
    mount -t proc proc "$root/proc"
    exec chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive "$@"' run.sh "${@:2}"
}

echo "lintian"
lintian --allow-root --tag-display-limit 0 --fail-on error "$packages"/*.deb ||
  fail "lintian reports errors"

bare=$folder/bare
if [ ! -e "$folder/complete" ]; then
  rm -rf "$bare"
  mkdir -p "$folder"
  debootstrap --variant=minbase "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$bare" >/dev/null
  touch "$folder/complete"
fi
root=$folder/root
rm -rf "$root"
cp -a "$bare" "$root"
mkdir "$root/data" "$root/packages"
cp "$packages"/*.deb "$root/packages"
awk 'BEGIN {
  print "ncols 200\nnrows 150\nxllcorner 500000\nyllcorner 5200000\ncellsize 30"
  for (y = 0; y < 150; ++y)
    for (x = 0; x < 200; ++x)
      printf "%.1f%s", 900 + 300 * sin(x / 17) * cos(y / 23) + 80 * sin(x * y / 900), x < 199 ? " " : "\n"
}' >"$root/data/dem.asc"

# The three commands from a bare system to a picture.
echo "install"
installed=(/packages/librelevo0_*.deb /packages/python3-relevo_*.deb /packages/relevo_*.deb)
in_root "$root" apt-get update -qq
in_root "$root" bash -c "apt-get install -qq --download-only ${installed[*]}" >/dev/null
TIMEFORMAT="installing took %R s without downloads, of which %U + %S s of processor time"
time in_root "$root" bash -c "apt-get install -qq ${installed[*]}" >"$folder/install.log" 2>&1 ||
  { cat "$folder/install.log"; fail "the packages cannot be installed"; }

check_programs() {
  rm -f "$root"/data/*.png
  in_root "$root" bash -ec 'cd /data
    relevo-view dem.asc --output view.png >/dev/null
    /usr/bin/python3 -c "
import relevo
relevo.terrain(\"dem.asc\").screenshot(\"python.png\")"
    /usr/bin/python3 -m relevo --version >/dev/null
    relevo-pyramid --version >/dev/null'
  for picture in view python; do
    [ "$(stat -c %s "$root/data/$picture.png")" -gt 20000 ] || fail "$picture.png is empty"
  done
}
echo "draw"
check_programs
for file in /usr/share/man/man1/relevo-view.1.gz /usr/share/applications/relevo-view.desktop \
  /usr/share/bash-completion/completions/relevo-view /usr/share/doc/python3-relevo/copyright; do
  [ -e "$root$file" ] || [[ $file = /usr/share/man/* ]] || fail "there is no $file"
done

# The packages of the next revision have the same files.
echo "upgrade"
for package in "$root"/packages/{librelevo0,python3-relevo,relevo}_*.deb; do
  rm -rf "$folder/unpacked"
  dpkg-deb -R "$package" "$folder/unpacked"
  version=$(dpkg-deb -f "$package" Version)
  sed -i "s/${version//./\\.}/$version+next/g" "$folder"/unpacked/DEBIAN/control
  dpkg-deb -b "$folder/unpacked" "$root/packages/next-$(basename "$package")" >/dev/null
done
in_root "$root" bash -c 'apt-get install -qq /packages/next-*.deb' >"$folder/upgrade.log" 2>&1 ||
  { cat "$folder/upgrade.log"; fail "the packages cannot be upgraded"; }
[[ $(in_root "$root" dpkg-query -W -f '${Version}' relevo) = *+next ]] || fail "relevo is not upgraded"
check_programs

echo "develop"
in_root "$root" bash -c 'apt-get install -qq --simulate /packages/librelevo-dev_*.deb \
  /packages/librelevo0_*.deb --allow-downgrades' >/dev/null || fail "librelevo-dev has missing dependencies"
for package in "$root"/packages/relevo-paraview_*.deb; do
  if [ -e "$package" ]; then
    in_root "$root" apt-get install -qq --simulate "/packages/${package##*/}" >/dev/null ||
      fail "relevo-paraview has missing dependencies"
  fi
done

echo "remove"
in_root "$root" apt-get purge -qq librelevo0 python3-relevo relevo >"$folder/remove.log" 2>&1 ||
  { cat "$folder/remove.log"; fail "the packages cannot be removed"; }
audit=$(in_root "$root" dpkg --audit)
[ -z "$audit" ] || fail "dpkg reports: $audit"
rest=$(find "$root" -xdev \( -path "$root/packages" -o -path "$root/data" -o -path "$root/var/cache" \
  -o -path "$root/var/log" \) -prune -o -ipath "$root/*relevo*" -print)
[ -z "$rest" ] || fail "removing the packages leaves $rest"
rm -rf "$root"
echo "The packages passed."
