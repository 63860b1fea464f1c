// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellContacts
 * @brief   classification of the cells of a surface by their contact with another surface
 *
 * Private to the module.
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

  /// `numberOfCells` is the number of cells of the mesh of the surface.
  CellContacts(const MovedSurface& surface, vtkIdType numberOfCells);

  /// Marks the cells of triangles at side 0 or 1 of the pairs as cut.
  void MarkCut(const std::vector<IntersectingPair>& pairs, int side);
  /// Measures the distances to another surface. Marks cells below nearDistance as near.
  void MeasureDistances(const MovedSurface& other, double nearDistance);
  /// Marks cells inside of another surface, which must be closed.
  void FindInside(const MovedSurface& other);

  /// Adds the cell array "Contact" and, if distances were measured, "Distance" to a mesh.
  void AddArrays(vtkPolyData* mesh) const;

private:
  bool IsCut(vtkIdType triangle) const;

  const MovedSurface& Surface;
  std::vector<unsigned char> Contacts;
  std::vector<double> Distances;
};
}

#endif
