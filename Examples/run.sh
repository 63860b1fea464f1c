#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws real relief: sets up and builds what is missing, fetches a height map with its satellite
# image, and runs relevo-view on them. The last line is the path of the picture; with a display a
# window opens as well.
#
#   bash Examples/run.sh [FILE] [options of relevo-view]
#   bash Examples/run.sh [options of relevo-view] -- FILE
#
# A height map or mesh of your own takes the place of the fetched one. See build/bin/relevo-view --help.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}

bash "$source_dir/Module/build.sh"
viewer=$build_dir/bin/relevo-view
# Its help has two spaces or more after an option without a value, one before a value, and brackets
# around one that need not be there.
flags=$("$viewer" --help | sed -nE 's/^  (--[a-z-]+) [ [].*/\1/p')

# What the arguments already say. Paths in them count from where the caller stands.
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
  # Raw bands of Landsat, which begin with blue; and rather flat land.
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
# One line that cannot command a terminal: names with control characters as the shell quotes them.
if [[ $picture == *[[:cntrl:]]* ]]; then
  picture=$(printf %q "$picture")
fi
printf '%s\n' "$picture"
