#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Unpacks Debian's ParaView, whose VTK has the surface LIC that Debian's own VTK lacks, into a folder
# of its own, with the libraries of Debian's that it needs and the machine has not. Nothing is
# installed: the packages conflict with those of VTK.
#
#   bash Testing/Benchmark/ParaView/fetch.sh PREFIX [PACKAGE...]
#
# PACKAGEs are unpacked besides, as paraview-dev for Module/ParaView/build.sh.
#
# Leaves PREFIX/bin/paraview-python: Python with ParaView's modules. Then
# relevo-benchmark --paraview PREFIX lic
set -euo pipefail

if [ $# -lt 1 ]; then
  echo "usage: fetch.sh PREFIX [PACKAGE...]" >&2
  exit 2
fi
mkdir -p "$1/bin"
prefix=$(cd "$1" && pwd)
packages_dir=$(mktemp -d)
trap 'rm -rf "$packages_dir"' EXIT

packages=(paraview python3-paraview "${@:2}")
# What would be installed along with them, if it were.
mapfile -t libraries < <(apt-get --simulate install --no-install-recommends "${packages[@]}" |
  sed -n 's/^Inst \(lib[^ ]*\) .*/\1/p' | grep -v -e '-dev$')
(cd "$packages_dir" && apt-get download "${packages[@]}" "${libraries[@]}")
for package in "$packages_dir"/*.deb; do
  dpkg -x "$package" "$prefix"
done
# Debian renames the modules of Python, but ParaView's files for CMake know the names from before.
find "$prefix/usr/lib/python3" -name '*.cpython-*.so' -print0 |
  while IFS= read -r -d '' module; do
    ln -sf "${module##*/}" "${module%%.cpython-*}.so"
  done

# It finds its folder by its own place, so PREFIX may move.
cat >"$prefix/bin/paraview-python.part" <<'EOF'
#!/bin/sh
prefix=$(cd "$(dirname "$0")/.." && pwd)
for folder in "$prefix"/usr/lib/*-linux-gnu "$prefix"/usr/lib/*-linux-gnu/paraview-*; do
  LD_LIBRARY_PATH=$folder${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
done
export LD_LIBRARY_PATH
PYTHONPATH=$prefix/usr/lib/python3/dist-packages exec /usr/bin/python3 "$@"
EOF
chmod +x "$prefix/bin/paraview-python.part"
mv "$prefix/bin/paraview-python.part" "$prefix/bin/paraview-python"
"$prefix/bin/paraview-python" -c "import vtkmodules.vtkRenderingLICOpenGL2"
echo "$prefix"
