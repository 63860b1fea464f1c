#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes real relief and the satellite image that goes with it available, out of Debian's (Ubuntu's)
# package archive: the package is downloaded and unpacked, not installed. Needs no root.
#
#   bash Data/fetch.sh [FOLDER]
#
# FOLDER keeps the files (default: data/ in the build folder, which is build/ or RELEVO_BUILD_DIR).
# Running it again finds them there, without a network. Standard output is
#
#   RELIEF=path of the height map
#   IMAGERY=path of the image
#
# and nothing else; exit code 1, with the reason on standard error, when they cannot be had.
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
      fail "$tool is missing: this needs Debian or Ubuntu; name a height map of your own instead"
  done
  work=$(mktemp -d "$folder/fetch.XXXXXX")
  trap 'rm -rf "$work"' EXIT

  # Root hands downloads to the user _apt, who may not write here.
  download() {
    (cd "$work" && apt-get -qq -o APT::Sandbox::User= "$@" download "$package") \
      >"$work/log" 2>&1
  }
  echo "Downloading $package ..." >&2
  if ! download; then
    # No package lists, or old ones: new ones in a place of our own, which anybody may write.
    mkdir -p "$work/state/lists/partial" "$work/cache/archives/partial"
    own_lists=(-o "Dir::State::lists=$work/state/lists" -o "Dir::Cache=$work/cache")
    echo "Updating the list of packages ..." >&2
    apt-get -qq -o APT::Sandbox::User= "${own_lists[@]}" update >"$work/log" 2>&1 || true
    download "${own_lists[@]}" || {
      cat "$work/log" >&2
      fail "apt-get cannot download $package (no network?); name a height map of your own instead"
    }
  fi
  dpkg-deb -x "$work/$package"_*.deb "$work/root" || fail "$package cannot be unpacked"
  for file in "$relief" "$imagery"; do
    [ -s "$work/root/$inside/$file" ] || fail "$package no longer holds $inside/$file"
    mv "$work/root/$inside/$file" "$folder/$file"
  done
fi

echo "RELIEF=$folder/$relief"
echo "IMAGERY=$folder/$imagery"
