// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CellCounts
 * @brief   counts the cells of each data set that are drawn, and those that are not
 *
 * Private to the modules.
 */
#ifndef CellCounts_h
#define CellCounts_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT CellCounts
{
public:
  struct Counts
  {
    vtkIdType Solid = 0;     // valid 3D cells that are neither ghosts nor blanked
    vtkIdType Bad = 0;       // without volume, or with coordinates that are not finite
    vtkIdType NotFinite = 0; // with a volume, and scalars that are fill values or not finite
    vtkIdType Drawn = 0;     // at least in parts
    vtkIdType Folded = 0;    // drawn, and folded over themselves
  };

  /// Adds a data set, whose cells have this number and higher ones, with the magnitudes of its fill
  /// values.
  void AddMesh(vtkIdType firstCell, const std::vector<double>& fillValues = {});

  /// The counts of the data set that has this cell.
  Counts& Of(vtkIdType cell);

  std::size_t GetNumberOfMeshes() const { return this->Meshes.size(); }
  const Counts& GetMesh(std::size_t number) const { return this->Meshes[number]; }
  /// The sums over all data sets.
  Counts GetSum() const;
  /// Different magnitudes of fill values, in ascending order.
  const std::vector<double>& GetFillValues() const { return this->FillValues; }

private:
  std::vector<vtkIdType> FirstCells;
  std::vector<Counts> Meshes;
  std::vector<double> FillValues;
};
}

#endif
