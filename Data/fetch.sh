#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes a height map and its satellite image available. It downloads and unpacks a package of Debian
# or Ubuntu, without installing it and without root.
#
#   bash Data/fetch.sh [FOLDER]
#
# FOLDER gets the files (default: data/ in the build folder, which is build/ or RELEVO_BUILD_DIR).
# Later runs find them there and need no network. Standard output is only
#
#   RELIEF=path of the height map
#   IMAGERY=path of the image
#
# If the files are not available, the exit code is 1, and standard error has the reason.
set -euo pipefail

case ${1:-} in
  -h | --help)
    sed -n '/^# Makes/,/^set /p' "${BASH_SOURCE[0]}" | sed '$d; s/^# \{0,1\}//'
    exit 0
    ;;
esac

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${1:-${RELEVO_BUILD_DIR:-$source_dir/build}/data}
package=r-cran-stars # see README.md
inside=usr/lib/R/site-library/stars/tif
relief=olinda_dem_utm25s.tif
imagery=L7_ETMs.tif

fail() {
  echo "fetch.sh: error: $*" >&2
  exit 1
}

mkdir -p "$folder" || fail "cannot write into $folder"
folder=$(cd "$folder" && pwd)

if [ ! -s "$folder/$relief" ] || [ ! -s "$folder/$imagery" ]; then
  for tool in apt-get dpkg-deb; do
    command -v "$tool" >/dev/null ||
      fail "there is no $tool: downloading needs Debian or Ubuntu; use your own height map instead"
  done
  work=$(mktemp -d "$folder/fetch.XXXXXX")
  trap 'rm -rf "$work"' EXIT

  # As root, apt-get would download as the user _apt, who cannot write to this folder.
  download() {
    (cd "$work" && apt-get -qq -o APT::Sandbox::User= "$@" download "$package") \
      >"$work/log" 2>&1
  }
  echo "Downloading $package ..." >&2
  if ! download; then
    # The package lists may be missing or old. Download new ones to a folder that any user can
    # write.
    mkdir -p "$work/state/lists/partial" "$work/cache/archives/partial"
    own_lists=(-o "Dir::State::lists=$work/state/lists" -o "Dir::Cache=$work/cache")
    echo "Updating the list of packages ..." >&2
    apt-get -qq -o APT::Sandbox::User= "${own_lists[@]}" update >"$work/log" 2>&1 || true
    download "${own_lists[@]}" || {
      cat "$work/log" >&2
      fail "apt-get cannot download $package; check the network, or use your own height map instead"
    }
  fi
  dpkg-deb -x "$work/$package"_*.deb "$work/root" || fail "cannot unpack $package"
  for file in "$relief" "$imagery"; do
    [ -s "$work/root/$inside/$file" ] || fail "$package does not contain $inside/$file"
    mv "$work/root/$inside/$file" "$folder/$file"
  done
fi

echo "RELIEF=$folder/$relief"
echo "IMAGERY=$folder/$imagery"
