// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of Bézier patches, evaluated by de Casteljau's algorithm.
#ifndef RelevoPatchFiles_h
#define RelevoPatchFiles_h

#include "RelevoSplines.h"

#include <iosfwd>
#include <string>

struct RelevoPatch
{
  int First = 1; ///< the degrees
  int Second = 1;
  std::vector<RelevoPosition> Points; ///< First + 1 rows of Second + 1

  RelevoPosition Evaluate(double u, double v) const;
};

/// Reads numbers like VTK's streams. The text must be valid.
std::vector<RelevoPatch> RelevoReadPatches(std::istream& text);
std::string RelevoWritePatches(const std::vector<RelevoPatch>& patches);

/// Largest distance between the cells and their patches. A cell's first direction follows the rows.
double RelevoGetPatchError(vtkUnstructuredGrid* grid, const std::vector<RelevoPatch>& patches);

#endif
