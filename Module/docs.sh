#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the reference of all public classes with Doxygen. On Debian and Ubuntu it first installs
# Doxygen if it is missing. Warnings are errors. The last line of the output is the path of the
# first page.
#
#   bash Module/docs.sh [--no-install]
#
#   --no-install   do not install packages
#
# The pages are in RELEVO_BUILD_DIR (default: build, beside README.md).
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}
. "$source_dir/Module/packages.sh"

case ${1:-} in
  '') install_packages doxygen ;;
  --no-install) ;;
  *)
    sed -n '/^# Makes/,/^set /p' "${BASH_SOURCE[0]}" | sed '$d; s/^# \{0,1\}//'
    [ "$1" = -h ] || [ "$1" = --help ] || exit 2
    exit 0
    ;;
esac

cd "$source_dir"
output=$build_dir/Documentation
rm -rf "$output"
mkdir -p "$output"
# Public headers declare classes with VTK's type macros, or CMakeLists.txt of a module lists them in
# author_headers, for authors of metrics and surfaces.
headers=$(grep -rlE --include='vtk*.h' 'vtk(Abstract)?TypeMacro\(' Filters Rendering | sort)
for list in Filters/*/CMakeLists.txt; do
  folder=$(dirname "$list")
  headers+=$(sed -n '/^set(author_headers/,/)/{s/)//;s/^  //p}' "$list" | sed "s|^|\n$folder/|")
done
version=$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)
RELEVO_HEADERS=$(tr '\n' ' ' <<<"$headers") RELEVO_OUTPUT=$output RELEVO_VERSION=$version \
  doxygen Module/Documentation/Doxyfile
echo "$output/html/index.html"
