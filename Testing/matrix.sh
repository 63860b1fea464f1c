#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds and tests Relevo and the plugin for ParaView on other releases of Debian, with their
# versions of VTK and ParaView. debootstrap installs each release in a folder, and later runs reuse
# it. The script needs root.
#
#   bash Testing/matrix.sh [12|13|sid]... [-- ctest arguments...]
#
#   12     VTK 9.1, ParaView 5.11
#   13     VTK 9.3, ParaView 5.13
#   sid    VTK 9.6, ParaView 6.1, or later
#
# Without arguments it runs all three releases. RELEVO_MATRIX_DIR contains the folders (default:
# build-matrix). RELEVO_TEST_DATA names a folder of larger real data, as for Testing/run.sh. The
# output ends with one line per release. The exit code is 0 only if the tests passed on all of them.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
matrix_dir=${RELEVO_MATRIX_DIR:-$source_dir/build-matrix}

declare -A suites=([12]=bookworm [13]=trixie [sid]=sid)
releases=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  if [ -z "${suites[$1]:-}" ]; then
    echo "matrix.sh: error: unknown release $1; use 12, 13 or sid" >&2
    exit 2
  fi
  releases+=("$1")
  shift
done
if [ $# -gt 0 ]; then
  shift
fi
if [ ${#releases[@]} -eq 0 ]; then
  releases=(12 13 sid)
fi
if [ "$(id -u)" -ne 0 ]; then
  echo "matrix.sh: error: run this as root; debootstrap and chroot need it" >&2
  exit 1
fi
for program in debootstrap unshare; do
  if ! command -v "$program" >/dev/null; then
    echo "matrix.sh: error: there is no $program; run: apt-get install debootstrap util-linux" >&2
    exit 1
  fi
done

# Installs the release $1 in the folder $2. An interrupted installation starts again.
install_release() {
  if [ ! -e "$2/installed" ]; then
    rm -rf "$2"
    mkdir -p "$2"
    debootstrap --variant=minbase "${suites[$1]}" "$2/root"
    touch "$2/installed"
  fi
  mkdir -p "$2/root/source" "$2/root/data" "$2/root/build"
}

# Runs the tests in the folder $1. The mounts end with the process that made them.
run_tests() {
  root=$1/root data=$2 source=$source_dir unshare --mount bash -euc '
    mount --bind -o ro "$source" "$root/source"
    if [ -n "$data" ]; then
      mount --bind -o ro "$data" "$root/data"
    fi
    mount --rbind /dev "$root/dev" # with the pseudo-terminals under it
    mount --bind /sys "$root/sys"
    mount --bind /tmp "$root/tmp" # X servers inside and outside must not take the same number
    mount -t proc proc "$root/proc"
    exec chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
      RELEVO_BUILD_DIR=/build RELEVO_PARAVIEW_BUILD_DIR=/build-paraview \
      ${data:+RELEVO_TEST_DATA=/data} bash -ec "
        bash /source/Module/ParaView/build.sh -DRELEVO_WERROR=ON
        bash /source/Testing/run.sh \"\$@\"" matrix.sh "$@"' matrix.sh "${@:3}"
}

data=${RELEVO_TEST_DATA:+$(cd "$RELEVO_TEST_DATA" && pwd)}
failed=0
summary=()
for release in "${releases[@]}"; do
  folder=$matrix_dir/$release
  install_release "$release" "$folder"
  result=passed
  if ! run_tests "$folder" "$data" "$@"; then
    result=failed
    failed=1
  fi
  version=$(chroot "$folder/root" dpkg-query -W -f '${Version}' libvtk9-dev 2>/dev/null || true)
  summary+=("Debian $release, VTK ${version:-not installed}: $result")
done
printf '%s\n' "${summary[@]}"
exit $failed
