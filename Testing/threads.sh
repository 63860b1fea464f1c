#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Searches data races with g++'s thread sanitizer: in parallel loops, in the paging of terrain, and
# in the warping of reliefs. It builds the modules with the sanitizer into build-threads/. Tests of
# build/, which Module/build.sh --testing builds, then load these libraries instead of their own.
#
#   bash Testing/threads.sh [--no-install] [TEST...]
#
#   TEST           for example TestReliefWarperPolicies; default: the tests that this script lists
#   --no-install   do not install packages
#
# The exit code is 0 if all tests passed without a data race.
# thread-suppressions.txt lists libraries of others that are not instrumented.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
tests_dir=${RELEVO_BUILD_DIR:-$source_dir/build}
build_dir=$source_dir/build-threads
. "$source_dir/Module/arguments.sh"
. "$source_dir/Module/packages.sh"

# Tests of loops, of paging, of warping, and of volumes, by executable.
tests="
FiltersRefinement/TestAdaptiveRefinementFilter
FiltersRefinement/TestRefinedCellLocatorThreads
FiltersRefinement/TestDepthTagFilter
FiltersRefinement/TestHeightErrorDepthTagMetric
FiltersRefinement/TestCreaseNormals
FiltersFlow/TestLineIntegralConvolution
FiltersFlow/TestSurfaceLineIntegralConvolution
FiltersIntersection/TestSurfaceIntersectionCurves
FiltersIntersection/TestSurfaceIntersectionContacts
FiltersParametric/TestPatchSurfaceFilter
FiltersParametric/TestAdaptiveCurveFilter
FiltersVolume/TestVolumeRayCastFilter
FiltersVolume/TestVolumeRayCastFilterCurved
FiltersVolume/TestMeshVisibilitySort
FiltersVolume/TestPointGradients
RenderingVolume/TestGPUUnstructuredGridVolumeMapperDetail
RenderingVolume/TestGPUUnstructuredGridVolumeMapperChanges
RenderingVolume/TestGPUUnstructuredGridVolumeMapperHanging
FiltersTerrain/TestBlockCache
FiltersTerrain/TestHeightMapReduced
FiltersTerrain/TestHeightMapThreads
FiltersTerrain/TestHeightTileCache
FiltersTerrain/TestTerrainMeshSource
FiltersTerrain/TestTerrainPyramid
FiltersTerrain/TestTerrainPyramidErrors
FiltersTerrain/TestTerrainPyramidWriter
FiltersRelief/TestReliefWarper
FiltersRelief/TestReliefWarperErrors
FiltersRelief/TestReliefWarperPolicies
RenderingTerrain/TestTerrainMapper
RenderingTerrain/TestTerrainMapperImagery
RenderingTerrain/TestTerrainMapperPicks
RenderingTerrain/TestTerrainPainterHeights
RenderingRelief/TestReliefMapperMethods
"
read_arguments "$@"
wanted=("${other_arguments[@]}")
for argument in "${wanted[@]}"; do
  [[ $argument == Test* ]] || reject_argument "$argument"
done
if [ $install = yes ]; then
  install_packages g++ xauth xvfb
fi
if [ -z "${DISPLAY:-}" ]; then
  exec xvfb-run -a -s "-noreset -screen 0 1280x1024x24" bash "${BASH_SOURCE[0]}" --no-install \
    "${wanted[@]}"
fi

generator=()
if [ ! -f "$build_dir/CMakeCache.txt" ] && command -v ninja >/dev/null; then
  generator=(-G Ninja)
fi
cmake -S "$source_dir" -B "$build_dir" "${generator[@]}" -DCMAKE_CXX_COMPILER=g++ \
  -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -DNDEBUG" -DRELEVO_SANITIZE=thread \
  -DRELEVO_BUILD_EXAMPLES=OFF -DRELEVO_WRAP_PYTHON=OFF \
  -DRELEVO_PRECOMPILE_HEADERS=ON -DRELEVO_UNITY_BUILD=ON
cmake --build "$build_dir" --parallel "$(nproc)"

# The tests themselves are not instrumented, so the sanitizer must be loaded first. It needs
# addresses that are not random on newer kernels. VTK's other pools of threads use atomic operations,
# which the sanitizer does not see. Mesa's driver is loaded with it, because the sanitizer ends a
# program that unloads a library of the suppressions, as a window does when it is closed.
output=$build_dir/Testing
mkdir -p "$output"
preloaded=$(g++ -print-file-name=libtsan.so)
for driver in /usr/lib/*/dri/swrast_dri.so; do
  [ ! -e "$driver" ] || preloaded+=:$driver
done
launcher=(env "LD_PRELOAD=$preloaded" "LD_LIBRARY_PATH=$build_dir/lib"
  VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=4 GALLIVM_PERF=nopt
  "RELEVO_SOURCE_DIR=$source_dir" "RELEVO_BINARY_DIR=$tests_dir")
options="suppressions=$source_dir/Testing/thread-suppressions.txt history_size=4"
if setarch -R true 2>/dev/null; then
  launcher=(setarch -R "${launcher[@]}")
fi
failed=0
for test in $tests; do
  name=${test#*/}
  if [ ${#wanted[@]} -gt 0 ] && [[ " ${wanted[*]} " != *" $name "* ]]; then
    continue
  fi
  program=$tests_dir/bin/Relevo${test%/*}CxxTests
  if [ ! -x "$program" ]; then
    echo "threads.sh: error: there is no $program; run Module/build.sh --testing" >&2
    exit 1
  fi
  # Mesa's compiler of shaders holds more locks than the search of deadlocks can count.
  deadlocks=1
  [[ $test != Rendering* ]] || deadlocks=0
  code=0
  SECONDS=0
  "${launcher[@]}" "TSAN_OPTIONS=$options detect_deadlocks=$deadlocks" \
    "$program" "$name" -D "$source_dir/Data" -T "$output" \
    -V "$source_dir/Testing/Baseline/$name.png" >"$output/$name.log" 2>&1 || code=$?
  races=$(grep -c "WARNING: ThreadSanitizer" "$output/$name.log" || true)
  outcome=passed
  if [ $code -eq 125 ] && [ "$races" -eq 0 ]; then
    outcome=skipped
  elif [ $code -ne 0 ] || [ "$races" -gt 0 ]; then
    outcome="failed: exit code $code, $races reports in $output/$name.log"
    failed=1
  fi
  echo "$name: $outcome, $SECONDS s"
done
exit $failed
