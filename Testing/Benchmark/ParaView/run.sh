#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures the plugin for ParaView that Module/ParaView/build.sh has built. Prints Markdown.
#
#   bash Testing/Benchmark/run.sh paraview [TABLE...]
#
# Each TABLE is a name below; without one, all are measured. RELEVO_TEST_DATA names the folder with
# the post of the tables frames and post.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
build_dir=${RELEVO_PARAVIEW_BUILD_DIR:-$source_dir/build-paraview}
if [ -z "${DISPLAY:-}" ]; then
  exec xvfb-run -a -s "-noreset -screen 0 1280x1024x24" bash "${BASH_SOURCE[0]}" "$@"
fi
. "$build_dir/env.sh"
export PYTHONPATH=$source_dir/Testing/Benchmark/ParaView:$source_dir/Testing/ParaView:$PYTHONPATH
export PYTHONDONTWRITEBYTECODE=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
script=$source_dir/Testing/Benchmark/ParaView/plugin.py
volumes=$source_dir/Testing/Benchmark/ParaView/volumes.py
work_dir=$(mktemp -d)
trap 'rm -rf "$work_dir"' EXIT
pictures=$work_dir/pictures.npz
messages=$work_dir/messages
heights=$work_dir/heights.png
measure() {
  "$@" 2>"$messages" || { cat "$messages" >&2; exit 1; }
}

# Processes with a single thread each, of which those that wait let others compute.
on_ranks() {
  measure mpirun --oversubscribe --mca mpi_yield_when_idle 1 -x LP_NUM_THREADS=0 \
    -x VTK_SMP_MAX_THREADS=1 "$@"
}

table_ranks() {
  echo "| ranks | scene | pixels over 2 of 255 that differ from one rank | frame, camera moving |"
  echo "|---:|---|---:|---:|"
  for ranks in 1 4; do
    measure mpirun --oversubscribe -n $ranks pvbatch "$script" ranks "$pictures"
  done
}

table_meshes() {
  echo "| ranks | triangles of the filter | open edges | triangles of one rank | filter |"
  echo "|---:|---:|---:|---|---:|"
  for ranks in 1 4; do
    measure mpirun --oversubscribe -n $ranks pvbatch "$script" meshes "$pictures"
  done
}

table_agreement() {
  echo "| 4 ranks, camera moving | agreement before a frame | frame |"
  echo "|---|---:|---:|"
  measure mpirun --oversubscribe -n 4 pvbatch "$script" agreement
}

table_interactive() {
  echo "| 2 M faces, 4 ranks | time asked for | frame | triangles | offsets of levels, spread |"
  echo "|---|---:|---:|---:|---:|"
  measure mpirun --oversubscribe -n 4 pvbatch --sym "$script" interactive 1 1.5 2
}

table_plain() {
  echo "| 1 rank | frame in pvbatch | in plain VTK | pixels over 2 of 255 that differ |"
  echo "|---|---:|---:|---:|"
  measure pvbatch "$script" plain
}

table_volumes() {
  echo "| ranks | pieces | composite: over 2 of 255 | over 1 | most of all modes: over 2 | over 1 |" \
    "within 1 | ParaView's Volume: over 2 | over 1 |"
  echo "|---:|---|---:|---:|---:|---:|---:|---:|---:|"
  for ranks in 1 2 4 7; do
    on_ranks -n $ranks pvbatch "$volumes" ranks "$pictures"
  done
}

has_post() {
  [ -f "${RELEVO_TEST_DATA:-}/volume/postxyz.bin" ] ||
    { echo "skipped: RELEVO_TEST_DATA has no volume/postxyz.bin"; return 1; }
}

# Ranks sleep while they wait, so that their processor time is that of their work.
table_frames() {
  has_post || return 0
  echo "int usleep(unsigned int); int sched_yield(void) { return usleep(2000); }" |
    cc -shared -fPIC -x c - -o "$work_dir/wait.so"
  echo "| ranks | pieces | slowest rank, its cells in plain VTK | slowest rank | without the volume |" \
    "merging | frame | ratio | segments |"
  echo "|---:|---|---:|---:|---:|---:|---:|---:|---:|"
  on_ranks -x LD_PRELOAD="$work_dir/wait.so" -n 4 pvbatch --sym "$volumes" frames
}

table_post() {
  has_post || return 0
  echo "| 513 375 tetrahedra | frame | processor time | Adaptive Volume's, ratio |"
  echo "|---|---:|---:|---:|"
  measure pvbatch "$volumes" post
}

table_curved() {
  echo "| 4096 cubic hexahedra | first picture | frame | processor time | ratio | memory | ratio |"
  echo "|---|---:|---:|---:|---:|---:|---:|"
  measure pvbatch "$script" curved
}

table_displaced() {
  echo "| 512 x 512 heights | frame, another scale | frame, camera moving | bounds, true: 0 to 0.19 |"
  echo "|---|---:|---:|---:|"
  measure pvbatch "$script" displaced "$heights"
}

table_raster() {
  echo "| 4096 x 4096 heights | first picture | memory |"
  echo "|---|---:|---:|"
  for way in write Relevo ParaView; do
    measure pvbatch "$script" raster $way "$heights"
  done
}

if [ $# -eq 0 ]; then
  set -- ranks meshes agreement interactive plain volumes frames post curved displaced raster
fi
for name in "$@"; do
  table_"$name"
  echo
done
