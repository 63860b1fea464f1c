#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the fuzz targets with clang, libFuzzer and the address and undefined-behaviour sanitizers
# into build-fuzz/, and runs them. Stops at the first error and prints the file that causes it.
#
#   bash Testing/fuzz.sh [TARGET...] [--seconds N] [--no-install]
#
#   TARGET         for example FuzzRaster; default: all
#   --seconds N    how long to run each target, default 60
#   --no-install   do not install packages
#
# To repeat an error, run build-fuzz/bin/TARGET FILE.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build-fuzz}
. "$source_dir/Module/arguments.sh"
. "$source_dir/Module/packages.sh"

read_arguments "$@"
seconds=60
targets=()
set -- "${other_arguments[@]}"
while [ $# -gt 0 ]; do
  case $1 in
    --seconds)
      seconds=${2:?--seconds needs a number}
      shift
      ;;
    Fuzz*) targets+=("$1") ;;
    *) reject_argument "$1" ;;
  esac
  shift
done

if [ $install = yes ]; then
  install_packages $build_packages $vtk_packages clang libclang-rt-dev
fi
generator=()
if [ ! -f "$build_dir/CMakeCache.txt" ] && command -v ninja >/dev/null; then
  generator=(-G Ninja)
fi
cmake -S "$source_dir" -B "$build_dir" "${generator[@]}" \
  -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1 \
  -DRELEVO_BUILD_FUZZERS=ON -DRELEVO_BUILD_EXAMPLES=OFF -DRELEVO_WRAP_PYTHON=OFF \
  -DRELEVO_FUZZ_SECONDS="$seconds"
cmake --build "$build_dir" --parallel "$(nproc)" --target "${targets[@]:-RelevoFuzzers}"

pattern=$(IFS='|' && echo "${targets[*]}")
words='Test +#|stat::number_of_executed|Sanitizer: |libFuzzer: |runtime error|is false|Test unit|tests passed'
cd "$build_dir"
ctest -L Fuzz -R "^(${pattern:-Fuzz.*})\$" --verbose | grep --line-buffered -E "$words"
exit "${PIPESTATUS[0]}"
