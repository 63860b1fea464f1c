#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# Examples/run.sh takes paths relative to the caller, prints the path of the picture last, and has
# the exit codes of relevo-view.
#   TestExamplesRun.sh SOURCE BUILD FOLDER
set -euo pipefail
source=$1 build=$2 folder=$3
export RELEVO_BUILD_DIR=$build
unset DISPLAY

rm -rf "$folder"
mkdir -p "$folder/here"
cd "$folder/here"
# A PGM file needs no other program: 4 x 3 grey pixels.
printf 'P5 4 3 255\n\001\002\003\004\005\006\007\010\011\012\013\014' >heights.pgm

check() {
  local expected=$1 wanted=$2 code=0 output
  shift 2
  output=$(bash "$source/Examples/run.sh" "$@" 2>errors) || code=$?
  if [ "$code" -ne "$expected" ]; then
    echo "run.sh $*: the exit code is $code, not $expected"
    cat errors
    exit 1
  fi
  if [ -n "$wanted" ] && [ "$(tail -n 1 <<<"$output")" != "$wanted" ]; then
    echo "run.sh $*: the last line is $(tail -n 1 <<<"$output"), not $wanted"
    exit 1
  fi
  if [ -n "$wanted" ] && [ "$(head -c 4 "$wanted" | tail -c 3)" != PNG ]; then
    echo "run.sh $*: $wanted is not a PNG file"
    exit 1
  fi
}
check 0 "$folder/here/out.png" heights.pgm --size 64x48 --output out.png
# The first run has brought the build up to date. Checking that again would take most of the time.
mkdir "$folder/bin"
printf '#!/bin/sh\n' >"$folder/bin/cmake"
chmod +x "$folder/bin/cmake"
PATH=$folder/bin:$PATH
check 0 "$folder/out.png" --output=../out.png --size 64x48 --wireframe --stats heights.pgm
printf '1\n1 1\n0 0 0 1 0 0\n0 1 0 1 1 1\n' >patch.bpt
printf '%s\n' 'ncols 3' 'nrows 2' 'xllcorner 10' 'yllcorner 50' 'cellsize 1' '1 2 3' '4 5 6' \
  >degrees.asc
printf '%s' 'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],' \
  'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]' >degrees.prj
printf '%s\n' '# vtk DataFile Version 3.0' triangle ASCII 'DATASET POLYDATA' 'POINTS 3 float' \
  '0 0 0 1 0 0 0 1 0' 'POLYGONS 1 4' '3 0 1 2' 'POINT_DATA 3' 'SCALARS a float 1' \
  'LOOKUP_TABLE default' '1 2 3' >triangle.vtk
# No option without a value takes the next argument as its value.
for flag in $("$build/bin/relevo-view" --help | sed -nE 's/^  (--[a-z-]+)  .*/\1/p'); do
  case $flag in --help | --version) continue ;; esac
  file=heights.pgm
  partner=
  case $flag in
    --patch-edges) file=patch.bpt ;;
    --axes) file=triangle.vtk ;;
    --log | --extremes) file=triangle.vtk partner=--array=a ;;
    --globe) file=degrees.asc ;;
    --contour-labels) partner=--contours=1 ;;
  esac
  rm -f flag.png
  check 0 "$folder/here/flag.png" "$flag" "$file" "$flag" $partner --output flag.png --size 64x48
done
rm -f "$build/relevo-view.png"
check 0 "$build/relevo-view.png" heights.pgm --size 64x48
check 0 "$build/relevo-view.png" heights.pgm --size 64x48 --export mesh.vtp
test -s mesh.vtp
cp heights.pgm ./-s.pgm
check 0 "$folder/here/-o.png" --size 64x48 --output ./-o.png -- -s.pgm
rm -f "$build/relevo-view.png"
check 0 "$build/relevo-view.png" --size 64x48 -- -s.pgm
# File names must not control the terminal or forge the last line.
name=$'a\e[2J\n.png'
check 0 "" heights.pgm --size 64x48 --output "$name"
test -s "$name"
last=$(bash "$source/Examples/run.sh" heights.pgm --size 64x48 --output "$name" | tail -n 1)
if [ "$last" != "$(printf %q "$folder/here/$name")" ]; then
  echo "run.sh: the last line is $(printf %q "$last")"
  exit 1
fi
check 1 '' missing.tif
check 2 '' heights.pgm --no-such-option
check 0 '' --help
check 0 '' --version
