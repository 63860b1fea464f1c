#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds Relevo into build/. On Debian and Ubuntu it first installs missing packages. Then it
# configures and compiles, and writes build/env.sh for you to source. Later runs build only what has
# changed.
#
#   bash Module/build.sh [--testing] [--benchmark] [--no-install] [CMake arguments...]
#
#   --testing      build the tests, and install the packages that they need
#   --benchmark    build the benchmark, and install the packages that it needs
#   --no-install   do not install packages
#
# The build folder keeps --testing, --benchmark and CMake arguments for later runs. To build without
# tests again, pass -DRELEVO_BUILD_TESTING=OFF, or -DRELEVO_BUILD_BENCHMARK=OFF.
# RELEVO_BUILD_DIR sets the build folder (default: build, beside README.md).
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}
. "$source_dir/Module/arguments.sh"
. "$source_dir/Module/packages.sh"

packages=$build_packages$vtk_packages
testing_packages="$documentation_packages
clang
clang-format
codespell
gdal-bin
git
glslang-tools
libclang-rt-dev
mypy
python3-pip
python3-proselint
python3-venv
shellcheck
xauth
xdotool
xvfb
"
benchmark_packages="
libbenchmark-dev
xauth
xvfb
"

install=yes
cmake_arguments=()
for argument in "$@"; do
  case $argument in
    --testing)
      packages+=$testing_packages
      cmake_arguments+=(-DRELEVO_BUILD_TESTING=ON)
      ;;
    --benchmark)
      packages+=$benchmark_packages
      cmake_arguments+=(-DRELEVO_BUILD_BENCHMARK=ON)
      ;;
    --no-install) install=no ;;
    -h | --help)
      print_help
      exit 0
      ;;
    *) cmake_arguments+=("$argument") ;;
  esac
done

if [ $install = yes ]; then
  install_packages $packages
fi

if command -v ccache >/dev/null; then
  cmake_arguments=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
    "${cmake_arguments[@]}")
fi
if [ ! -f "$build_dir/CMakeCache.txt" ] && command -v ninja >/dev/null; then
  cmake_arguments=(-G Ninja "${cmake_arguments[@]}")
fi
cmake -S "$source_dir" -B "$build_dir" "${cmake_arguments[@]}"
cmake --build "$build_dir" --parallel "$(nproc)"

echo "build.sh: the build is complete. To use it, run:  . $build_dir/env.sh"
