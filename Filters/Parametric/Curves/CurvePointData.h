// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   evaluation of point data at the points of tessellated curves
 *
 * Numeric arrays keep their type; integers are rounded. Strings, bits and ghost flags are copied
 * from the nearest node. Global and pedigree ids, which identify input points, and weights are
 * dropped. A curve with missing data at a node has no data between its ends.
 *
 * Private to the module.
 */
#ifndef CurvePointData_h
#define CurvePointData_h

#include <string>
#include <vector>

class vtkPointData;
class vtkPointSet;

namespace relevo
{
class CurveMesh;
class CurveRows;

/// Fills `to`. Appends the names of arrays with too few tuples to `shortArrays`. Without
/// `keepNormals`, normals of the input are dropped. For noDataMagnitude, see NoDataTuples.
void EvaluatePointData(vtkPointSet* input, const CurveMesh& mesh, const CurveRows& rows,
  bool keepNormals, double noDataMagnitude, vtkPointData* to,
  std::vector<std::string>& shortArrays);
}

#endif
