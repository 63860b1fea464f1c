#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures the plugin for ParaView that Module/ParaView/build.sh has built. Prints Markdown.
#
#   bash Testing/Benchmark/run.sh paraview
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
build_dir=${RELEVO_PARAVIEW_BUILD_DIR:-$source_dir/build-paraview}
if [ -z "${DISPLAY:-}" ]; then
  exec xvfb-run -a -s "-noreset -screen 0 1280x1024x24" bash "${BASH_SOURCE[0]}"
fi
. "$build_dir/env.sh"
export PYTHONPATH=$source_dir/Testing/ParaView:$PYTHONPATH PYTHONDONTWRITEBYTECODE=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
script=$source_dir/Testing/Benchmark/ParaView/plugin.py
pictures=$(mktemp --suffix=.npz)
messages=$(mktemp)
heights=$(mktemp --suffix=.png)
trap 'rm -f "$pictures" "$messages" "$heights"' EXIT
measure() {
  "$@" 2>"$messages" || { cat "$messages" >&2; exit 1; }
}

echo "| ranks | scene | pixels over 2 of 255 that differ from one rank | frame, camera moving |"
echo "|---:|---|---:|---:|"
for ranks in 1 4; do
  measure mpirun --oversubscribe -n $ranks pvbatch "$script" ranks "$pictures"
done
echo
echo "| ranks | triangles of the filter | open edges | triangles of one rank | filter |"
echo "|---:|---:|---:|---|---:|"
for ranks in 1 4; do
  measure mpirun --oversubscribe -n $ranks pvbatch "$script" meshes "$pictures"
done
echo
echo "| 4 ranks, camera moving | agreement before a frame | frame |"
echo "|---|---:|---:|"
measure mpirun --oversubscribe -n 4 pvbatch "$script" agreement
echo
echo "| 2 M faces, 4 ranks | time asked for | frame | triangles | offsets of levels, spread |"
echo "|---|---:|---:|---:|---:|"
measure mpirun --oversubscribe -n 4 pvbatch --sym "$script" interactive 1 1.5 2
echo
echo "| 1 rank | frame in pvbatch | in plain VTK | pixels over 2 of 255 that differ |"
echo "|---|---:|---:|---:|"
measure pvbatch "$script" plain
echo
echo "| 4096 cubic hexahedra | first picture | frame | ratio | memory | ratio |"
echo "|---|---:|---:|---:|---:|---:|"
measure pvbatch "$script" curved
echo
echo "| 512 x 512 heights | frame, another scale | frame, camera moving | bounds, true: 0 to 0.19 |"
echo "|---|---:|---:|---:|"
measure pvbatch "$script" displaced "$heights"
echo
echo "| 4096 x 4096 heights | first picture | memory |"
echo "|---|---:|---:|"
for way in write Relevo ParaView; do
  measure pvbatch "$script" raster $way "$heights"
done
