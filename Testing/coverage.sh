#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Prints which share of the lines of Filters/ and Rendering/ the tests run. It builds the modules
# with gcov's counters into build-coverage/. The tests of build/, which Module/build.sh --testing
# builds, then load these libraries instead of their own.
#
#   bash Testing/coverage.sh [--paraview] [--report] [--no-install] [ctest arguments...]
#
#   --paraview     also build the plugin for ParaView with counters, run its tests and count
#                  Module/ParaView/
#   --report       run no tests; print the lines of the last runs again
#   --no-install   do not install packages
#
# Counters add up until you delete build-coverage/. Its file report/index.html shows each line.
# Lines of shaders are not counted, nor those of the programs and of Module/FileChecks.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
tests_dir=${RELEVO_BUILD_DIR:-$source_dir/build}
build_dir=$source_dir/build-coverage
. "$source_dir/Module/arguments.sh"
. "$source_dir/Module/packages.sh"

read_arguments "$@"
paraview=no
run=yes
test_arguments=()
for argument in "${other_arguments[@]}"; do
  case $argument in
    --paraview) paraview=yes ;;
    --report) run=no ;;
    *) test_arguments+=("$argument") ;;
  esac
done
plugin_arguments=()
if [ $install = yes ]; then
  install_packages gcovr xauth xvfb
else
  plugin_arguments=(--no-install)
fi
if [ ! -f "$tests_dir/Testing/CTestTestfile.cmake" ]; then
  echo "coverage.sh: error: there are no tests in $tests_dir; run Module/build.sh --testing" >&2
  exit 1
fi

# Counters of a line can be increased by several threads at once. Only zero matters, so they need no
# locks. Functions of headers must be those of the module, not the copies in tests.
flags=(-DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -DNDEBUG --coverage"
  "-DCMAKE_C_FLAGS_DEBUG=-O1 -DNDEBUG" "-DCMAKE_SHARED_LINKER_FLAGS=-Wl,-Bsymbolic-functions"
  -DRELEVO_PRECOMPILE_HEADERS=ON -DRELEVO_UNITY_BUILD=ON)
display=()
if [ -z "${DISPLAY:-}" ]; then
  display=(xvfb-run -a -s "-noreset -screen 0 1280x1024x24")
fi
result=0
if [ $run = yes ]; then
  generator=()
  if [ ! -f "$build_dir/CMakeCache.txt" ] && command -v ninja >/dev/null; then
    generator=(-G Ninja)
  fi
  cmake -S "$source_dir" -B "$build_dir" "${generator[@]}" "${flags[@]}" \
    -DRELEVO_BUILD_EXAMPLES=OFF -DRELEVO_WRAP_PYTHON=OFF
  cmake --build "$build_dir" --parallel "$(nproc)"
  # Tests of the sources and of the packaging do not load the modules.
  (cd "$tests_dir" && LD_LIBRARY_PATH=$build_dir/lib "${display[@]}" ctest --output-on-failure \
    --parallel "$(nproc)" -LE "Project|Packages" "${test_arguments[@]}") || result=$?
fi
folders=("$build_dir/Filters" "$build_dir/Rendering")
counted="Filters|Rendering"
if [ $paraview = yes ]; then
  plugin_dir=$build_dir/paraview
  if [ $run = yes ]; then
    RELEVO_PARAVIEW_BUILD_DIR=$plugin_dir bash "$source_dir/Module/ParaView/build.sh" \
      "${plugin_arguments[@]}" "${flags[@]}"
    RELEVO_PARAVIEW_BUILD_DIR=$plugin_dir bash "$source_dir/Testing/ParaView/run.sh" \
      "${plugin_arguments[@]}" || result=$?
  fi
  folders+=("$plugin_dir/Filters" "$plugin_dir/Rendering" "$plugin_dir/Module")
  counted+="|Module/ParaView"
fi

# Counts are read once, and then summed for parts of the sources.
report_dir=$build_dir/report
mkdir -p "$report_dir"
gcovr --root "$source_dir" --gcov-ignore-parse-errors -j "$(nproc)" \
  --filter "$source_dir/($counted)/" --json "$report_dir/lines.json" "${folders[@]}"
report() {
  gcovr --root "$source_dir" --add-tracefile "$report_dir/lines.json" "$@"
}
report --html-details "$report_dir/index.html" --txt "$report_dir/lines.txt"
for part in "$source_dir"/{Filters,Rendering}/*/ "$source_dir/Module/ParaView/" "$source_dir/"; do
  lines=$(report --filter "$part" --print-summary --output /dev/null | sed -n 's/^lines: //p')
  case $part in
    */Module/*) [ $paraview = yes ] || continue ;;
  esac
  echo "${part#"$source_dir/"} ${lines:-none}"
done
exit "$result"
