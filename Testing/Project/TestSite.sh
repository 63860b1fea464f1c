#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# Module/docs.sh makes the site with all pages and classes. Warnings and broken links are errors.
#   TestSite.sh SOURCE BUILD FOLDER
set -euo pipefail
source=$1 build=$2 folder=$3
if ! command -v doxygen >/dev/null; then
  echo "skipped: doxygen is not installed"
  exit 125
fi
# Releases of Doxygen have different warnings. The test uses that of Debian 12.
if ! doxygen --version | grep -q '^1\.9\.'; then
  echo "skipped: doxygen is not version 1.9"
  exit 125
fi
if ! /usr/bin/python3 -c 'import furo, myst_parser, sphinx' 2>/dev/null; then
  echo "skipped: Sphinx, its theme Furo or MyST is not installed"
  exit 125
fi
rm -rf "$folder"
mkdir -p "$folder"
ln -s "$build/lib" "$folder/lib" # with the stubs
RELEVO_BUILD_DIR=$folder bash "$source/Module/docs.sh" --no-install | tee "$folder/log"
site=$folder/Documentation/html
[ "$(tail -n 1 "$folder/log")" = "$site/index.html" ]

# Pages contain text of classes in several modules, including methods from macros and of groups.
check() {
  if ! grep -q -- "$2" "$site/$1"; then
    echo "$1: has no text $2"
    exit 1
  fi
}
check cxx/classvtkAdaptiveRefinement.html 'GetMaximumLevel()'
check cxx/classvtkTerrainSource.html 'MapToTerrain'
check cxx/classvtkPhongSurface.html 'GetAlpha()'
check cxx/classvtkSurfaceLineIntegralConvolution.html 'SetTextureSize'
check cxx/classvtkAdaptiveRefinementMapper.html 'SetMethodToARKFPI()'
check cxx/classvtkAdaptiveLICMapper.html 'SetPhase'
check cxx/classvtkEGLOffscreenRenderWindow.html 'no display'
check cxx/classrelevo_1_1SurfaceBounds.html 'ComputeNormalCone'
if [ -e "$site/cxx/classrelevo_1_1RefinementMesh.html" ]; then
  echo "a private class has a page"
  exit 1
fi

# All wrapped classes have a page, with the methods of Python and C++.
for stub in "$folder"/lib/python*/*-packages/relevo/Relevo*.pyi; do
  for class in $(sed -n 's/^class \(vtk\w*\).*/\1/p' "$stub"); do
    check "classes/$class.html" "id=\"relevo.$class\""
  done
done
check classes/vtkTerrainPyramid.html 'id="relevo.vtkTerrainPyramid.GetElevation"'
check classes/vtkTerrainPyramid.html '<span class="kt">double</span>'
if [ -e "$stub" ]; then
  check classes/vtkTerrainPyramid.html '<span class="pre">float</span>' # from the stubs
fi
check functions.html 'id="relevo.terrain"'
check functions.html 'id="relevo.Terrain.elevation"'
check functions.html 'id="relevo.arrays.height_map"'

# The other parts, and the index of the search.
for page in "$source"/Module/Documentation/*.md; do
  name=${page##*/}
  check "${name%.md}.html" '<h1>'
  check index.html "href=\"${name%.md}.html"
done
check gallery.html '<img alt="A globe"'
check changes.html 'semantic'
check searchindex.js 'setscreenspaceerror'
check searchindex.js 'tutorial-analysis'
check search.html 'searchtools.js'

# In a small copy, a reference to a missing name, a link to a missing file and one to a missing
# heading are errors.
copy=$folder/copy
mkdir -p "$copy/Data" "$copy/Filters/Refinement" "$copy/Module/Documentation" "$copy/Rendering"
cp -r "$source/Filters/Refinement/Surfaces" "$copy/Filters/Refinement"
touch "$copy/Filters/Refinement/CMakeLists.txt"
cp "$source/CMakeLists.txt" "$copy"
cp -r "$source"/Module/{Python,Site,docs.sh,packages.sh} "$copy/Module"
cp "$source/Module/Documentation/Doxyfile" "$copy/Module/Documentation"
touch "$copy/Module/Documentation/reference.dox" # that of the source names classes of other folders
for page in README CHANGELOG CONTRIBUTING Data/README Module/Documentation/guide; do
  echo "# Page" >"$copy/$page.md"
done
fails() {
  if RELEVO_BUILD_DIR=$copy/build bash "$copy/Module/docs.sh" --no-install >"$folder/log" 2>&1; then
    echo "docs.sh accepts $1"
    exit 1
  fi
  if ! grep -q -- "$2" "$folder/log"; then
    echo "docs.sh does not report $1:"
    cat "$folder/log"
    exit 1
  fi
}
page=$copy/Module/Documentation/guide.md
echo '[heading](#nowhere)' >>"$page"
fails "a missing heading" 'guide.md.*nowhere'
echo '![picture](none.png)' >>"$page"
fails "a missing picture" 'guide.md: none.png is not a file'
sed -i 's/@brief /@brief @ref nothing /' "$copy/Filters/Refinement/Surfaces/vtkLinearSurface.h"
fails "a missing name" 'vtkLinearSurface.h'

# Pages that need the network or have broken links are errors.
mkdir "$folder/broken"
cat >"$folder/broken/index.html" <<'END'
<script src="https://example.org/script.js"></script><a href="other.html">text</a>
<img src="picture.png"><a href="#here">text</a><a href="https://example.org">text</a>
END
if /usr/bin/python3 "$source/Module/Site/check_site.py" "$folder/broken" >"$folder/log"; then
  echo "check_site.py accepts broken links"
  exit 1
fi
expected='index.html: other.html does not exist
index.html: #here: no such anchor
index.html: loads https://example.org/script.js
index.html: picture.png does not exist'
if [ "$(cat "$folder/log")" != "$expected" ]; then
  cat "$folder/log"
  exit 1
fi
