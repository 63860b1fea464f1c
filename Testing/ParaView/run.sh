#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Tests the plugin for ParaView that Module/ParaView/build.sh has built. The exit code is 0 if all
# tests passed and 125 if there is no plugin.
#
#   bash Testing/ParaView/run.sh [--no-install] [NAME...]
#
#   --no-install   do not install packages
#
# Without names it runs each Test*.py of this folder. Before you add one, read "Tests of the ParaView
# plugin" in CONTRIBUTING.md: all of them should take at most 8 minutes on two processors.
#
# RELEVO_PARAVIEW_BUILD_DIR is the build folder of the plugin (default: build-paraview, beside
# README.md). RELEVO_BUILD_DIR is that of the Python package, for TestPackage (default: build).
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir=${RELEVO_PARAVIEW_BUILD_DIR:-$source_dir/build-paraview}
if [ ! -f "$build_dir/env.sh" ]; then
  echo "skipped: there is no plugin; to build it, run: bash Module/ParaView/build.sh"
  exit 125
fi
if [ "${1:-}" = --no-install ]; then
  shift
else
  . "$source_dir/Module/packages.sh"
  install_packages openmpi-bin xauth xvfb
fi

package_dir=${RELEVO_BUILD_DIR:-$source_dir/build}
if [ -f "$package_dir/env.sh" ]; then
  . "$package_dir/env.sh"
fi
. "$build_dir/env.sh"
export PYTHONDONTWRITEBYTECODE=1
if [ -z "${DISPLAY:-}" ]; then
  exec xvfb-run -a -s "-noreset -screen 0 1280x1024x24" bash "${BASH_SOURCE[0]}" --no-install "$@"
fi

if [ $# -eq 0 ]; then
  for script in "$source_dir"/Testing/ParaView/Test*.py; do
    set -- "$@" "$(basename "$script" .py)"
  done
fi

# Tests on several ranks come first.
names_of_ranks=() names=()
for name in "$@"; do
  if [[ $name =~ Ranks|Translucent|Selection ]]; then
    names_of_ranks+=("$name")
  else
    names+=("$name")
  fi
done
names=("${names_of_ranks[@]}" "${names[@]}")
reversed=()
for name in "${names[@]}"; do
  reversed=("$name" "${reversed[@]}")
done

# In a container Open MPI must run as root, and with more ranks than processors.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
# Ranks that wait let others compute, also those that tests start.
export OMPI_MCA_mpi_yield_when_idle=1
mpirun=(mpirun --oversubscribe -x LP_NUM_THREADS=0 -x VTK_SMP_MAX_THREADS=1)
work_dir=$(mktemp -d)
trap 'rm -rf "$work_dir"' EXIT
if command -v cc >/dev/null; then
  waiting=$work_dir/waiting.so
  cc -O2 -shared -fPIC "$source_dir/Testing/ParaView/WaitingRanks.c" -o "$waiting"
  export LD_PRELOAD=$waiting${LD_PRELOAD:+:$LD_PRELOAD}
fi

run_test() {
  local script=$source_dir/Testing/ParaView/$1.py counts ranks
  case $1 in
    TestRanks | TestPatchRanks) counts="1 2 4 7" ;;
    TestFilterRanks) counts="1 7" ;;
    TestTerrainRanks | TestVolumeRanks) counts="1 2 4" ;;
    TestLICRanks | TestTranslucent) counts="1 4" ;;
    TestSelection | TestReliefRanks) counts="1 2" ;;
    *)
      timeout 300 pvbatch "$script"
      return
      ;;
  esac
  for ranks in $counts; do
    timeout 300 "${mpirun[@]}" -n "$ranks" pvbatch "$script" "$work_dir/$1/pictures.npz" || return 1
  done
}

# Runs those of the tests that the other process has not started.
report_tests() {
  local name outcome failed=0
  for name in "$@"; do
    mkdir "$work_dir/$name" 2>/dev/null || continue
    outcome=passed
    SECONDS=0
    run_test "$name" >"$work_dir/$name/log" 2>&1 || outcome=failed failed=1
    cat "$work_dir/$name/log"
    echo "$outcome: $name, $SECONDS s"
  done
  return $failed
}

# Two processes start at both ends, so one of them runs tests on several ranks and the other tests
# on one rank, and both end at about the same time.
report_tests "${names[@]}" &
failed=0
report_tests "${reversed[@]}" || failed=1
wait $! || failed=1
exit $failed
