#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds Relevo, downloads a height map with its satellite image, and draws them with relevo-view.
# The last line of the output is the path of the picture. If there is a display, a window opens too.
#
#   bash Examples/run.sh [FILE] [options of relevo-view]
#   bash Examples/run.sh [options of relevo-view] -- FILE
#
# FILE is a height map or a mesh to draw instead. build/bin/relevo-view --help lists all options.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}

bash "$source_dir/Module/build.sh"
viewer=$build_dir/bin/relevo-view
# In the help, two or more spaces follow an option without a value. One space precedes a value, and
# brackets enclose an optional value.
flags=$("$viewer" --help | sed -nE 's/^  (--[a-z-]+) [ [].*/\1/p')

# Find the file and the output in the arguments. Their paths are relative to the caller's folder.
file='' output='' leaves=no option='' are_files=no
for argument in "$@"; do
  if [ $are_files = yes ]; then
    file=$argument
    continue
  fi
  if [ -n "$option" ]; then
    [ "$option" != --output ] || output=$argument
    option=''
    continue
  fi
  case $argument in
    -h | --help | --version) exec "$viewer" "$argument" ;;
    --) are_files=yes ;;
    --output=*) output=${argument#*=} ;;
    --export | --export=*) leaves=yes ;;&
    --*=*) ;;
    --*) grep -qxF -e "$argument" <<<"$flags" || option=$argument ;;
    *) file=$argument ;;
  esac
done
[ -z "$output" ] || leaves=yes

arguments=("$@")
if [ -z "$file" ]; then
  data=$(bash "$source_dir/Data/fetch.sh")
  # The raw bands of Landsat begin with blue. The land is rather flat.
  arguments=("$(sed -n 's/^RELIEF=//p' <<<"$data")"
    --imagery "$(sed -n 's/^IMAGERY=//p' <<<"$data")" --imagery-bands "3,2,1" --stretch
    --exaggeration 5
    "$@")
fi

if [ -z "$output" ]; then
  output=$build_dir/relevo-view.png
  "$viewer" --output "$output" "${arguments[@]}"
else
  "$viewer" "${arguments[@]}"
fi
if [ $leaves = no ] && [ -n "${DISPLAY:-}" ]; then
  "$viewer" "${arguments[@]}"
fi
picture=$(cd -- "$(dirname -- "$output")" && pwd)/$(basename -- "$output")
# Quote names with control characters, so that the last line cannot control a terminal.
if [[ $picture == *[[:cntrl:]]* ]]; then
  picture=$(printf %q "$picture")
fi
printf '%s\n' "$picture"
