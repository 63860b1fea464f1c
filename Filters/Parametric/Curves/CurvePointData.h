// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   point data of curves cut into segments, by each curve's own basis
 *
 * Numeric arrays keep their type: integers are rounded. What has no values between (strings, bits,
 * ghost flags) takes that of the nearest node; global and pedigree ids, which name the input's
 * points, and weights are left out. A curve with a node that stands for no data has none between
 * its ends.
 *
 * Private to the module's own sources.
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

/// Fills `to`. Names of arrays with too few tuples go to the end of `shortArrays`. Without
/// `keepNormals` the input's normals are left out. For noDataMagnitude see NoDataTuples.
void EvaluatePointData(vtkPointSet* input, const CurveMesh& mesh, const CurveRows& rows,
  bool keepNormals, double noDataMagnitude, vtkPointData* to,
  std::vector<std::string>& shortArrays);
}

#endif
