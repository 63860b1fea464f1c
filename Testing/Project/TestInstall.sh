#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# An installed Relevo works in any folder and without the build tree.
#   TestInstall.sh BUILD PREFIX PYTHON PYTHON_DESTINATION
set -euo pipefail
build=$1 prefix=$2 python=$3 destination=$4

rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null

if grep -rl --include='*.cmake' --include='env.sh' -F -e "$build" -e "$prefix" "$prefix"; then
  echo "an installed file contains the path of the build tree or of the installation"
  exit 1
fi
while IFS= read -r -d '' file; do
  if readelf -d "$file" 2>/dev/null | grep -E 'R(UN)?PATH' | grep -F "$build"; then
    echo "$file: its RPATH contains the build tree"
    exit 1
  fi
done < <(find "$prefix" -type f \( -name '*.so*' -o -path '*/bin/*' \) -print0)

# The installed pages link only to installed files.
readme=$(find "$prefix/share/doc" -maxdepth 2 -name README.md)
"$python" "$(dirname "${BASH_SOURCE[0]}")/TestPages.py" "$(dirname "$readme")" --links

# Python imports the installed package, which loads the installed libraries.
cd /
if [ -d "$prefix/$destination/relevo" ]; then
  PYTHONPATH=$prefix/$destination "$python" - "$prefix" <<'PYTHON'
import sys
import relevo
prefix = sys.argv[1]
assert relevo.__file__.startswith(prefix), relevo.__file__
relevo.vtkAdaptiveRefinement()
with open("/proc/self/maps") as maps:
    libraries = {line.split()[-1] for line in maps if "libRelevo" in line}
assert libraries and all(path.startswith(prefix) for path in libraries), libraries
PYTHON
fi
if [ -x "$prefix/bin/relevo-view" ]; then
  "$prefix/bin/relevo-view" --help >/dev/null
fi

# env.sh works in the build tree, in the installation, and in a moved installation.
check_environment() {
  local folder=$1 file=$2 shell=$3
  "$shell" -euc '. "$1"
    found=$(command -v relevo-view || echo none)
    [ ! -x "$2/bin/relevo-view" ] || [ "$found" = "$2/bin/relevo-view" ] ||
      { echo "$1: the path of relevo-view is $found"; exit 1; }
    [ ! -d "$2/$4" ] || "$3" -c "
import relevo, sys
assert relevo.__file__.startswith(sys.argv[1] + \"/\"), relevo.__file__" "$2"
    [ -z "${relevo_prefix+set}" ]' "$shell" "$file" "$folder" "$python" "$destination" ||
    { echo "$file: fails in $shell"; exit 1; }
}
check_environments() {
  local folder=$1 file=$2 shell
  for shell in bash dash zsh sh; do
    if command -v "$shell" >/dev/null; then
      check_environment "$folder" "$folder/$file" "$shell"
      (cd "$folder/.." && check_environment "$folder" "./${folder##*/}/$file" "$shell")
    fi
  done
}
unset PYTHONPATH
check_environments "$build" env.sh
check_environments "$prefix" share/relevo/env.sh
moved="$prefix moved"
rm -rf "$moved"
mv "$prefix" "$moved"
trap 'mv "$moved" "$prefix"' EXIT
check_environments "$moved" share/relevo/env.sh
