// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellContacts
 * @brief   how the cells of a surface are to another
 *
 * Private to the module's own sources.
 */
#ifndef CellContacts_h
#define CellContacts_h

#include "Pairs/PairSearch.h"
#include "vtkType.h" // for vtkIdType

#include <vector> // for members

class vtkPolyData;

namespace relevo
{
class MovedSurface;

class CellContacts
{
public:
  enum Contact : unsigned char
  {
    Free,
    Near,
    Cut,
    Inside
  };

  /// Of a mesh of so many cells, which has the surface.
  CellContacts(const MovedSurface& surface, vtkIdType numberOfCells);

  /// Cells of triangles that are the side, 0 or 1, of a pair are cut.
  void MarkCut(const std::vector<IntersectingPair>& pairs, int side);
  /// Distances to another surface; what is nearer than a distance is near.
  void MeasureDistances(const MovedSurface& other, double nearDistance);
  /// What is inside of another surface, which is closed.
  void FindInside(const MovedSurface& other);

  /// Give a mesh the cell array `Contact` and, if distances were measured, `Distance`.
  void AddArrays(vtkPolyData* mesh) const;

private:
  bool IsCut(vtkIdType triangle) const;

  const MovedSurface& Surface;
  std::vector<unsigned char> Contacts;
  std::vector<double> Distances;
};
}

#endif
