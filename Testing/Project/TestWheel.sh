#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# pip builds a wheel of the build tree, which works in a virtual environment and can be removed.
#   TestWheel.sh SOURCE BUILD FOLDER PYTHON
set -euo pipefail
source=$1 build=$2 folder=$3 python=$4

if ! "$python" -c 'import ensurepip, pip, tomllib, venv' 2>/dev/null; then
  echo "skipped: needs Python 3.11 with pip and venv"
  exit 125
fi
unset PYTHONPATH
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
"$python" -m pip wheel --quiet --no-index --no-deps --wheel-dir . \
  --config-settings="build-dir=$build" "$source"

# A compiler run finds VTK's Python modules, although pip hides the system's packages. This cmake
# checks that, and compiles nothing.
mkdir programs
cat >programs/cmake <<'SCRIPT'
#!/bin/sh
for argument in "$@"; do
  case $argument in
    -DPython3_EXECUTABLE=*) "${argument#*=}" -c 'import vtkmodules' && touch "$MARKER" ;;
  esac
done
exit 1
SCRIPT
chmod +x programs/cmake
if MARKER=$PWD/found PATH=$PWD/programs:$PATH "$python" -m pip wheel --quiet --no-index --no-deps \
  --wheel-dir nothing "$source" 2>pip.log || [ ! -e found ]; then
  cat pip.log
  echo "a build in pip's environment does not find vtkmodules"
  exit 1
fi

"$python" -m venv --system-site-packages environment
environment/bin/python -m pip install --quiet --no-index relevo-*.whl

environment/bin/python - <<'PYTHON'
import importlib.metadata
import sys

import relevo

prefix = sys.prefix
assert relevo.__file__.startswith(prefix), relevo.__file__
assert importlib.metadata.version("relevo") == relevo.__version__
relevo.vtkAdaptiveRefinement()
with open("/proc/self/maps") as maps:
    libraries = {line.split()[-1] for line in maps if "libRelevo" in line}
assert libraries and all(path.startswith(prefix) for path in libraries), libraries
for group in ("pyvista.accessors", "pyvista.plotter_components"):
    (point,) = importlib.metadata.entry_points(group=group)
    assert point.name == "relevo", point
PYTHON
if [ -x "$build/bin/relevo-view" ]; then
  environment/bin/relevo-view --help >/dev/null
  environment/bin/python -m relevo --help >/dev/null
fi

environment/bin/python -m pip uninstall --quiet --yes relevo
rest=$(find environment -iname '*relevo*' -not -name '__pycache__')
if [ -n "$rest" ]; then
  echo "pip uninstall leaves files: $rest"
  exit 1
fi
