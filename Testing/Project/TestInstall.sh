#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# An installed Relevo works from where it lies, and knows nothing of the build tree.
#   TestInstall.sh BUILD PREFIX PYTHON PYTHON_DESTINATION
set -euo pipefail
build=$1 prefix=$2 python=$3 destination=$4

rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null

if grep -rl --include='*.cmake' -F "$build" "$prefix"; then
  echo "the package configuration names the build tree"
  exit 1
fi
while IFS= read -r -d '' file; do
  if readelf -d "$file" 2>/dev/null | grep -E 'R(UN)?PATH' | grep -F "$build"; then
    echo "$file: finds libraries through the build tree"
    exit 1
  fi
done < <(find "$prefix" -type f \( -name '*.so*' -o -path '*/bin/*' \) -print0)

# The installed package, and through its RPATH the installed libraries.
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
