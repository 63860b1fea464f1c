#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the plugin for ParaView into build-paraview/. On Debian and Ubuntu it first installs
# missing packages. It uses the installed ParaView. If there is none, it unpacks Debian's into the
# build folder, because Debian's packages of ParaView and VTK conflict. Then it compiles, and writes
# build-paraview/env.sh for you to source. After that, paraview, pvserver, pvbatch and pvpython load
# the plugin.
#
#   bash Module/ParaView/build.sh [--no-install] [--paraview FOLDER] [CMake arguments...]
#
#   --no-install        do not install packages
#   --paraview FOLDER   use the ParaView that is installed in FOLDER, 5.11 or later with its headers
#                       and CMake files, for example an SDK or a build of your own
#
# RELEVO_PARAVIEW_BUILD_DIR sets the build folder (default: build-paraview, beside README.md).
# Instead of --paraview you can set ParaView_DIR in the environment or pass -DParaView_DIR=...
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir=${RELEVO_PARAVIEW_BUILD_DIR:-$source_dir/build-paraview}
. "$source_dir/Module/arguments.sh"
. "$source_dir/Module/packages.sh"

# Prints the folder with ParaViewConfig.cmake of the ParaView that is installed in the folder $1.
find_paraview() {
  local folder
  if [ ! -d "$1" ]; then
    echo "build.sh: error: there is no folder $1; --paraview needs that of a ParaView" >&2
    exit 1
  fi
  for folder in "$1"/lib/cmake/paraview-* "$1"/lib64/cmake/paraview-* "$1"/lib/*/cmake/paraview-*; do
    if [ -f "$folder/ParaViewConfig.cmake" ] || [ -f "$folder/paraview-config.cmake" ]; then
      (cd "$folder" && pwd)
      return
    fi
  done
  echo "build.sh: error: $1 has no lib/cmake/paraview-*; ParaView's programs alone are not enough," \
    "because a plugin needs its headers and CMake files" >&2
  exit 1
}

install=yes
cmake_arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --no-install) install=no ;;
    --paraview)
      if [ -z "${2:-}" ]; then
        echo "build.sh: error: --paraview needs the folder of a ParaView" >&2
        exit 2
      fi
      ParaView_DIR=$(find_paraview "$2")
      shift
      ;;
    --paraview=*)
      set -- --paraview "${1#*=}" "${@:2}"
      continue
      ;;
    -h | --help)
      print_help
      exit 0
      ;;
    -DParaView_DIR=*) ParaView_DIR=${1#*=} ;;
    *) cmake_arguments+=("$1") ;;
  esac
  shift
done

# Packages that ParaView's VTK needs. They are dependencies of VTK's packages, but in most releases
# installing those would remove ParaView.
paraview_packages="
libdouble-conversion-dev
libeigen3-dev
libfontconfig-dev|libfontconfig1-dev
libfreetype-dev
libgl-dev
libglew-dev
libutfcpp-dev
mpi-default-dev
openmpi-bin
python3-mpi4py
"
if [ $install = yes ]; then
  install_packages $build_packages $paraview_packages
  if apt-cache depends python3-paraview 2>/dev/null | grep -q 'Depends: python3-vtk9'; then
    install_packages $vtk_packages
  fi
fi

# Use the installed ParaView, or unpack Debian's. In Debian 13 and later, CMake files of an
# installed ParaView name Python modules that do not exist.
if [ -z "${ParaView_DIR:-}" ]; then
  prefix=/usr
  if ! is_installed paraview-dev ||
    [ ! -e /usr/lib/python3/dist-packages/paraview/modules/vtkRemotingViews.so ]; then
    prefix=$build_dir/paraview
    if ! ls -d "$prefix"/usr/lib/*/cmake/paraview-* >/dev/null 2>&1; then
      bash "$source_dir/Testing/Benchmark/ParaView/fetch.sh" "$prefix" paraview-dev
    fi
    prefix+=/usr
  fi
  ParaView_DIR=$(ls -d "$prefix"/lib/*/cmake/paraview-* | tail -n 1)
fi

if command -v ccache >/dev/null; then
  cmake_arguments=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
    "${cmake_arguments[@]}")
fi
if [ ! -f "$build_dir/CMakeCache.txt" ] && command -v ninja >/dev/null; then
  cmake_arguments=(-G Ninja "${cmake_arguments[@]}")
fi
cmake -S "$source_dir" -B "$build_dir" -DRELEVO_BUILD_PARAVIEW=ON -DRELEVO_WRAP_PYTHON=OFF \
  -DRELEVO_BUILD_EXAMPLES=OFF -DParaView_DIR="$ParaView_DIR" "${cmake_arguments[@]}"
cmake --build "$build_dir" --parallel "$(nproc)"

echo "build.sh: the build is complete. To use it, run:  . $build_dir/env.sh"
