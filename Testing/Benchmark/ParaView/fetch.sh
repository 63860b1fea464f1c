#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Unpacks Debian's ParaView, whose VTK has the surface LIC that Debian's VTK lacks, and the libraries
# that it needs into a separate folder. Nothing is installed, because the packages conflict with
# those of VTK.
#
#   bash Testing/Benchmark/ParaView/fetch.sh PREFIX [PACKAGE...]
#
# Additional PACKAGEs are unpacked too, for example paraview-dev for Module/ParaView/build.sh.
#
# Creates PREFIX/bin/paraview-python, which is Python with ParaView's modules. Then run
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
# Lists the packages that an installation would add.
mapfile -t libraries < <(apt-get --simulate install --no-install-recommends "${packages[@]}" |
  sed -n 's/^Inst \(lib[^ ]*\) .*/\1/p' | grep -v -e '-dev$')
(cd "$packages_dir" && apt-get download "${packages[@]}" "${libraries[@]}")
for package in "$packages_dir"/*.deb; do
  dpkg -x "$package" "$prefix"
done
# Debian renames the Python modules, but ParaView's CMake files use the original names.
find "$prefix/usr/lib/python3" -name '*.cpython-*.so' -print0 |
  while IFS= read -r -d '' module; do
    ln -sf "${module##*/}" "${module%%.cpython-*}.so"
  done

# The script finds its folder relative to itself, so PREFIX may be moved.
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
