#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets up, builds and runs the benchmark. Prints Markdown and writes JSON to the build folder.
# Arguments are passed to relevo-benchmark. Without a NAME everything is measured.
#
#   bash Testing/Benchmark/run.sh [--quick | --full] [--height-map FILE] [--paraview PREFIX]
#        [--output FILE.json] [--] [NAME...]
#
# --help lists the NAMEs. --quick only shows that everything runs. --full uses sizes and repetitions
# for graphics cards. RELEVO_TEST_DATA names a folder with larger real data. --paraview names a
# folder filled by ParaView/fetch.sh; lic then compares with its VTK. The NAME paraview, as the first
# argument, measures the plugin that Module/ParaView/build.sh has built; see ParaView/run.sh. The NAME
# python, as the first argument, measures the Python package, and writes
# build/benchmark-python/package.json. The NAME studio, as the first argument, measures the panels of
# relevo-studio, actions of its users and windows that are served to browsers, and writes
# build/benchmark-studio/panels.json, actions.json and server.json.
#
# You can copy the build folder to any path on another machine with the same VTK and run the copy's
# bin/relevo-benchmark. It needs no display (EGL) and prints the renderer's name.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [ "${1:-}" = paraview ]; then
  exec bash "$source_dir/Testing/Benchmark/ParaView/run.sh" "${@:2}"
fi
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}

bash "$source_dir/Module/build.sh" --benchmark >&2
if [ "${1:-}" = python ]; then
  . "$build_dir/env.sh"
  export PYTHONPATH=$PYTHONPATH:$source_dir/Testing/Python PYTHONDONTWRITEBYTECODE=1
  python=$(sed -n 's/^Python3_EXECUTABLE:.*=//p' "$build_dir/CMakeCache.txt")
  exec "$python" "$source_dir/Testing/Benchmark/Python/package.py" "$build_dir/bin/relevo-view" \
    "$build_dir/benchmark-python" "${@:2}"
fi
if [ "${1:-}" = studio ]; then
  . "$build_dir/env.sh"
  export PYTHONPATH=$PYTHONPATH:$source_dir/Testing/Python PYTHONDONTWRITEBYTECODE=1
  python=$(sed -n 's/^Python3_EXECUTABLE:.*=//p' "$build_dir/CMakeCache.txt")
  "$python" "$source_dir/Testing/Benchmark/Studio/panels.py" "$build_dir/bin/relevo-studio" \
    "$build_dir/benchmark-studio" "${@:2}"
  echo
  "$python" "$source_dir/Testing/Benchmark/Studio/actions.py" "$build_dir/bin/relevo-studio" \
    "$build_dir/benchmark-studio" "${@:2}"
  echo
  exec "$python" "$source_dir/Testing/Benchmark/Studio/server.py" "$build_dir/benchmark-studio" \
    "${@:2}"
fi

# A build without EGL needs an X server.
display=()
if [ -z "${DISPLAY:-}" ] && command -v xvfb-run >/dev/null; then
  display=(xvfb-run -a -s "-noreset -screen 0 1280x1024x24")
fi
exec "${display[@]}" "$build_dir/bin/relevo-benchmark" --output "$build_dir/benchmark.json" "$@"
