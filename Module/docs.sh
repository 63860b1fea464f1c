#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the site: all pages, the gallery and the reference of C++ and Python, with a search that
# works without a network. On Debian and Ubuntu it first installs Doxygen and Sphinx if they are
# missing. Warnings and broken links are errors. The last line of the output is the path of the first
# page.
#
#   bash Module/docs.sh [--no-install]
#
#   --no-install   do not install packages
#
# The pages are in RELEVO_BUILD_DIR (default: build, beside README.md). If there is a build in this
# folder, the reference of Python has the types of its stubs.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}
. "$source_dir/Module/packages.sh"

case ${1:-} in
  '') install_packages $documentation_packages ;;
  --no-install) ;;
  *)
    sed -n '/^# Makes/,/^set /p' "${BASH_SOURCE[0]}" | sed '$d; s/^# \{0,1\}//'
    [ "$1" = -h ] || [ "$1" = --help ] || exit 2
    exit 0
    ;;
esac

# The first python3 in PATH may not be that of the packages.
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import sphinx, myst_parser, furo' 2>/dev/null; then
    break
  fi
done

cd "$source_dir"
output=$build_dir/Documentation
rm -rf "$output"
mkdir -p "$output/source"
# Public headers declare classes with VTK's type macros, or CMakeLists.txt of a module lists them in
# author_headers, for authors of metrics and surfaces.
headers=$(grep -rlE --include='vtk*.h' 'vtk(Abstract)?TypeMacro\(' Filters Rendering | sort)
for list in Filters/*/CMakeLists.txt; do
  folder=$(dirname "$list")
  headers+=$(sed -n '/^set(author_headers/,/)/{s/)//;s/^  //p}' "$list" | sed "s|^|\n$folder/|")
done
RELEVO_VERSION=$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)
export RELEVO_VERSION
RELEVO_HEADERS=$(tr '\n' ' ' <<<"$headers") RELEVO_OUTPUT=$output \
  doxygen Module/Documentation/Doxyfile

stubs=("$build_dir"/lib/python*/*-packages/relevo)
[ -e "${stubs[0]}" ] || stubs=()
export PYTHONDONTWRITEBYTECODE=1
"$python" Module/Site/make_pages.py "$source_dir" "$output/source" "$output/xml" "${stubs[@]}"
"$python" -m sphinx -W --keep-going -q -b html -d "$output/cache" "$output/source" "$output/html"
mv "$output/cxx" "$output/html/cxx"
"$python" Module/Site/check_site.py "$output/html"
echo "$output/html/index.html"
