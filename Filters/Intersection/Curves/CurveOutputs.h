// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   output of intersection curves and overlaps as VTK cells
 *
 * Private to the module.
 */
#ifndef CurveOutputs_h
#define CurveOutputs_h

#include "Pairs/PairSearch.h"

class vtkPolyData;

namespace relevo
{
/**
 * Fills `curves` with points and segments of the intersections, which are optionally joined, and
 * `overlaps` with polygons.
 */
void MakeCurves(const MovedSurface& first, const MovedSurface& second,
  const std::vector<IntersectingPair>& pairs, bool joinSegments, vtkPolyData* curves,
  vtkPolyData* overlaps);
}

#endif
