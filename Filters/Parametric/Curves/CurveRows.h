// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveRows
 * @brief   layout of the points of tessellated curves
 *
 * A curve has a row of points at each end of a segment. If rows consist of one point, curves that
 * share an end share its point. A tube has an additional row, the cap, at each end that is not
 * joined.
 *
 * Private to the module.
 */
#ifndef CurveRows_h
#define CurveRows_h

#include "vtkType.h"

#include <array>  // for members
#include <vector> // for members

namespace relevo
{
class CurveFrames;
class CurveMesh;

class CurveRows
{
public:
  /// `frames` may be nullptr, for curves without caps.
  CurveRows(
    const CurveMesh& mesh, const std::vector<int>& segments, int width, const CurveFrames* frames);

  int GetWidth() const { return this->Width; }
  int GetSegments(vtkIdType curve) const { return this->Segments[curve]; }
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }

  /// Returns the first point of a row, from 0 to the number of segments.
  vtkIdType GetRow(vtkIdType curve, int row) const
  {
    const Place& place = this->Places[curve];
    const int last = this->Segments[curve];
    return row == 0 ? place.Ends[0]
                    : (row == last ? place.Ends[1] : place.Inner + (row - 1) * this->Width);
  }

  /// Returns the first point of the cap at the start (0) or end (1), or -1.
  vtkIdType GetCap(vtkIdType curve, int end) const { return this->Places[curve].Caps[end]; }

  /**
   * Calls work(t, first point, cap) for each row that belongs to this curve only. `cap` is -1 for
   * the cap at the start, 1 for the cap at the end, and 0 for other rows. Can be called from
   * several threads for different curves.
   */
  template <typename Work>
  void ForEachRow(vtkIdType curve, const Work& work) const
  {
    const Place& place = this->Places[curve];
    const int segments = this->Segments[curve];
    for (int row = place.IsOwn[0] ? 0 : 1; row < segments + (place.IsOwn[1] ? 1 : 0); ++row)
    {
      // t is exactly 1 at the end.
      work(static_cast<double>(row) / segments, this->GetRow(curve, row), 0);
    }
    for (int end = 0; end < 2; ++end)
    {
      if (place.Caps[end] >= 0)
      {
        work(static_cast<double>(end), place.Caps[end], 2 * end - 1);
      }
    }
  }

private:
  struct Place
  {
    std::array<vtkIdType, 2> Ends;
    vtkIdType Inner;
    std::array<vtkIdType, 2> Caps;
    std::array<bool, 2> IsOwn;
  };
  void ShareEnds(const CurveMesh& mesh);

  const std::vector<int>& Segments;
  int Width;
  std::vector<Place> Places;
  vtkIdType NumberOfPoints = 0;
};
}

#endif
