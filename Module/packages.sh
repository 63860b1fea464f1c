# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs packages of Debian and Ubuntu, for the scripts that source this file.
# shellcheck shell=bash disable=SC2034

# Packages that a build needs besides VTK, one per line. a|b lists names of different releases.
build_packages="
ca-certificates
cmake
g++
libboost-dev
libcivetweb-dev
libegl-dev
libgdal-dev
libgeographiclib-dev|libgeographic-dev
libgl1-mesa-dri
libglm-dev
libimgui-dev
libopenimageio-dev
ninja-build
openimageio-tools
python3-dev
python3-numpy
"
vtk_packages="
libvtk9-dev
python3-vtk9
"
# Packages that Module/docs.sh needs.
documentation_packages="
doxygen
furo
python3-myst-parser
python3-sphinx
"

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "${0##*/}: error: run this command as root, or install sudo: $*" >&2
    exit 1
  fi
}

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Prints the first of the alternatives a|b for which the command $2 succeeds.
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

# Installs the missing ones of the packages. An argument a|b lists alternative names.
install_packages() {
  local missing=() wanted=() alternatives name
  if ! command -v apt-get >/dev/null; then
    echo "${0##*/}: this system has no apt-get. Install these packages, or equivalent ones: $*"
    return 0
  fi
  for alternatives in "$@"; do
    choose "$alternatives" is_installed >/dev/null || missing+=("$alternatives")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return 0
  fi
  echo "${0##*/}: installing ${missing[*]}"
  as_root apt-get update
  for alternatives in "${missing[@]}"; do
    if ! name=$(choose "$alternatives" is_available); then
      echo "${0##*/}: error: this release has no package named ${alternatives//|/ or }" >&2
      exit 1
    fi
    wanted+=("$name")
  done
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    "${wanted[@]}"
}
