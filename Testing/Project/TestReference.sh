#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# Module/docs.sh makes a page for each public class, and a warning is an error.
#   TestReference.sh SOURCE FOLDER
set -euo pipefail
source=$1 folder=$2
if ! command -v doxygen >/dev/null; then
  echo "skipped: doxygen is not installed"
  exit 125
fi
# Releases of Doxygen have different warnings. The test uses that of Debian 12.
if ! doxygen --version | grep -q '^1\.9\.'; then
  echo "skipped: doxygen is not version 1.9"
  exit 125
fi
rm -rf "$folder"
mkdir -p "$folder"
RELEVO_BUILD_DIR=$folder bash "$source/Module/docs.sh" --no-install | tee "$folder/log"
test -s "$(tail -n 1 "$folder/log")"

# Pages contain text of classes in several modules, including methods from macros and of groups.
check() {
  if ! grep -q "$2" "$folder/Documentation/html/class$1.html"; then
    echo "class$1.html: has no text $2"
    exit 1
  fi
}
check vtkAdaptiveRefinement 'GetMaximumLevel()'
check vtkTerrainSource 'MapToTerrain'
check vtkPhongSurface 'GetAlpha()'
check vtkSurfaceLineIntegralConvolution 'SetTextureSize'
check vtkAdaptiveRefinementMapper 'SetMethodToARKFPI()'
check vtkAdaptiveLICMapper 'SetPhase'
check vtkEGLOffscreenRenderWindow 'no display'
check relevo_1_1SurfaceBounds 'ComputeNormalCone'
if [ -e "$folder/Documentation/html/classrelevo_1_1RefinementMesh.html" ]; then
  echo "a private class has a page"
  exit 1
fi

# In a copy, a reference to a missing name must be an error.
copy=$folder/copy
mkdir -p "$copy"
cp -r "$source/CMakeLists.txt" "$source/Module" "$source/Filters" "$source/Rendering" "$copy"
sed -i 's/@brief /@brief @ref nothing /' "$copy/Filters/Refinement/Surfaces/vtkLinearSurface.h"
if RELEVO_BUILD_DIR=$copy/build bash "$copy/Module/docs.sh" --no-install >"$folder/log" 2>&1; then
  echo "docs.sh accepts a reference to a missing name"
  exit 1
fi
grep -q 'vtkLinearSurface.h' "$folder/log"
