// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Files of Bézier patches, and their surfaces by de Casteljau's construction.
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

/// As VTK's streams read numbers; the text is one without faults.
std::vector<RelevoPatch> RelevoReadPatches(std::istream& text);
std::string RelevoWritePatches(const std::vector<RelevoPatch>& patches);

/// The largest distance between the cells and the patches that they are made of: a cell's first
/// direction leads along the rows.
double RelevoGetPatchError(vtkUnstructuredGrid* grid, const std::vector<RelevoPatch>& patches);

#endif
