#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets up, builds and runs the benchmark: Markdown on stdout, JSON in the build folder. Arguments
# go to relevo-benchmark; without a NAME everything is measured.
#
#   bash Testing/Benchmark/run.sh [--quick | --full] [--height-map FILE] [--paraview PREFIX]
#        [--output FILE.json] [--] [NAME...]
#
# NAME is one of those that --help lists. --quick shows that everything runs, --full takes sizes
# and repetitions that are for graphics cards. RELEVO_TEST_DATA names a folder of larger real data.
# --paraview names a folder that ParaView/fetch.sh has filled: lic compares with its VTK.
# The NAME paraview, alone, measures the plugin that Module/ParaView/build.sh has built.
#
# The build folder can be copied to another machine with the same VTK, whatever the path: there
# run bin/relevo-benchmark of the copy. It needs no display (EGL), and names the renderer.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [ "${*:-}" = paraview ]; then
  exec bash "$source_dir/Testing/Benchmark/ParaView/run.sh"
fi
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}

bash "$source_dir/Module/build.sh" --benchmark >&2

# A build without the display-less window needs an X server.
display=()
if [ -z "${DISPLAY:-}" ] && command -v xvfb-run >/dev/null; then
  display=(xvfb-run -a -s "-noreset -screen 0 1280x1024x24")
fi
exec "${display[@]}" "$build_dir/bin/relevo-benchmark" --output "$build_dir/benchmark.json" "$@"
