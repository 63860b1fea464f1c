#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes packages for Debian and Ubuntu: librelevo0, librelevo-dev, python3-relevo, relevo and
# relevo-paraview. They are for the release that the script runs on. It first installs missing
# packages. The last lines of the output are the paths of the packages, in build-package/.
#
#   bash Module/package.sh [--no-install] [--no-paraview] [--paraview FOLDER] [CMake arguments...]
#
#   --no-install        do not install packages
#   --no-paraview       do not make relevo-paraview, which builds the plugin with ParaView
#   --paraview FOLDER   as for Module/ParaView/build.sh
#
# RELEVO_PACKAGE_BUILD_DIR sets the build folder (default: build-package, beside README.md). The
# plugin is built in paraview/ below it. DEBFULLNAME and DEBEMAIL are the maintainer. The compiler
# gets the flags of dpkg-buildflags, unless CXXFLAGS is set. SOURCE_DATE_EPOCH is the time of the
# packages.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_PACKAGE_BUILD_DIR:-$source_dir/build-package}
. "$source_dir/Module/arguments.sh"
. "$source_dir/Module/packages.sh"

install=()
plugin=yes
paraview=()
cmake_arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --no-install) install=(--no-install) ;;
    --no-paraview) plugin=no ;;
    --paraview)
      paraview=(--paraview "${2:-}")
      shift
      ;;
    --paraview=*) paraview=("$1") ;;
    -h | --help)
      print_help
      exit 0
      ;;
    *) cmake_arguments+=("$1") ;;
  esac
  shift
done

if [ ! -e /etc/debian_version ]; then
  echo "package.sh: error: this system is not Debian or Ubuntu" >&2
  exit 1
fi
if [ ${#install[@]} -eq 0 ]; then
  install_packages dpkg-dev file xz-utils
fi

# Debug information is left out, because packages are stripped.
export DEB_BUILD_MAINT_OPTIONS=hardening=+all
for flags in CPPFLAGS CXXFLAGS LDFLAGS; do
  if [ -z "${!flags+set}" ]; then
    value=$(DEB_CXXFLAGS_MAINT_STRIP=-g dpkg-buildflags --get $flags)
    declare -x "$flags=$value"
  fi
done
export CXXFLAGS="$CXXFLAGS ${CPPFLAGS:-}"

cmake_arguments=(-DCMAKE_INSTALL_PREFIX=/usr "${cmake_arguments[@]}")
rm -f "$build_dir"/*.deb
RELEVO_BUILD_DIR=$build_dir bash "$source_dir/Module/build.sh" "${install[@]}" \
  "${cmake_arguments[@]}"
(cd "$build_dir" && cpack -G DEB)
if [ $plugin = yes ]; then
  rm -f "$build_dir"/paraview/*.deb
  RELEVO_PARAVIEW_BUILD_DIR=$build_dir/paraview bash "$source_dir/Module/ParaView/build.sh" \
    "${install[@]}" "${paraview[@]}" "${cmake_arguments[@]}"
  (cd "$build_dir/paraview" && cpack -G DEB)
  mv "$build_dir"/paraview/*.deb "$build_dir"
fi
rm -rf "$build_dir"/_CPack_Packages "$build_dir"/paraview/_CPack_Packages
ls "$build_dir"/*.deb
