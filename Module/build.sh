#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds Relevo into build/: installs what is missing (Debian, Ubuntu), configures, compiles, and
# leaves build/env.sh to source. Running it again does only what has to be done anew.
#
#   bash Module/build.sh [--testing] [--benchmark] [--no-install] [CMake's own arguments...]
#
#   --testing      build the tests, and install what they need
#   --benchmark    build the benchmark, and install what it needs
#   --no-install   leave the machine's packages alone
#
# RELEVO_BUILD_DIR is the folder to build in (default: build beside README.md).
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}

# One package a line; a|b where releases of Debian and Ubuntu name it differently.
packages="
ca-certificates
cmake
g++
libegl-dev
libgdal-dev
libgeographiclib-dev|libgeographic-dev
libgl1-mesa-dri
libglm-dev
libopenimageio-dev
libvtk9-dev
ninja-build
openimageio-tools
python3-dev
python3-numpy
python3-vtk9
"
testing_packages="
clang
clang-format
gdal-bin
git
glslang-tools
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
      sed -n '/^# Builds/,/^set /p' "${BASH_SOURCE[0]}" | sed '$d; s/^# \{0,1\}//'
      exit 0
      ;;
    *) cmake_arguments+=("$argument") ;;
  esac
done

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "build.sh: error: installing packages needs root or sudo: $*" >&2
    exit 1
  fi
}

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# The first of the alternatives a|b that is installed or, failing that, can be.
choose() {
  local name
  for name in ${1//|/ }; do
    if "$2" "$name"; then
      echo "$name"
      return 0
    fi
  done
  return 1
}

is_available() {
  [ -n "$(apt-cache policy "$1" 2>/dev/null | sed -n '/Candidate: (none)/d; /Candidate:/p')" ]
}

install_missing() {
  local missing=() wanted=() alternatives name
  for alternatives in $packages; do
    choose "$alternatives" is_installed >/dev/null || missing+=("$alternatives")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return 0
  fi
  echo "build.sh: installing ${missing[*]}"
  as_root apt-get update
  for alternatives in "${missing[@]}"; do
    if ! name=$(choose "$alternatives" is_available); then
      echo "build.sh: error: this release has no package ${alternatives//|/ or }" >&2
      exit 1
    fi
    wanted+=("$name")
  done
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    "${wanted[@]}"
}

if [ $install = yes ]; then
  if command -v apt-get >/dev/null; then
    install_missing
  else
    echo "build.sh: no apt-get here: taking for granted what README.md lists"
  fi
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

echo "build.sh: built; now:  . $build_dir/env.sh"
