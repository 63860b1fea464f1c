// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveRows
 * @brief   where the points of curves cut into segments are among all
 *
 * A curve has a row of points, as many as it is wide, at each end of its segments. Where rows are
 * one point wide, curves that share an end share its point. A tube has one more row, its cap, where
 * nothing is joined.
 *
 * Private to the module's own sources.
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
  /// Without frames there are no caps.
  CurveRows(
    const CurveMesh& mesh, const std::vector<int>& segments, int width, const CurveFrames* frames);

  int GetWidth() const { return this->Width; }
  int GetSegments(vtkIdType curve) const { return this->Segments[curve]; }
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }

  /// The first point of a row, 0 to the number of segments.
  vtkIdType GetRow(vtkIdType curve, int row) const
  {
    const Place& place = this->Places[curve];
    const int last = this->Segments[curve];
    return row == 0 ? place.Ends[0]
                    : (row == last ? place.Ends[1] : place.Inner + (row - 1) * this->Width);
  }

  /// That of the start (0) or the end (1); -1 for no cap.
  vtkIdType GetCap(vtkIdType curve, int end) const { return this->Places[curve].Caps[end]; }

  /**
   * Calls work(t, first point, cap) for each row of a curve that no other curve has as well;
   * cap is -1 at the start's cap, 1 at the end's, else 0. May be called from several threads for
   * different curves.
   */
  template <typename Work>
  void ForEachRow(vtkIdType curve, const Work& work) const
  {
    const Place& place = this->Places[curve];
    const int segments = this->Segments[curve];
    for (int row = place.IsOwn[0] ? 0 : 1; row < segments + (place.IsOwn[1] ? 1 : 0); ++row)
    {
      // Exactly 1 at the end.
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
