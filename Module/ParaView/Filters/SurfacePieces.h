// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfacePieces
 * @brief   the surfaces of a data set as every number of processes draws them alike
 *
 * Each piece gets the faces around it that other processes, or other partitions of the data set,
 * have: their vtkGhostType has vtkDataSetAttributes::DUPLICATECELL. Strips become triangles. Points
 * and faces are sorted by where they lie, so that what is computed in their order comes out the
 * same, to the bit, whoever has them.
 */
#ifndef SurfacePieces_h
#define SurfacePieces_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"             // for members
#include "vtkType.h"                     // for members

#include <vector> // for members

class vtkDataObjectTree;
class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
/// Whether all cells have their points, and all cells and points their data.
RELEVOPARAVIEWFILTERS_EXPORT bool IsSound(vtkPolyData* mesh);

class RELEVOPARAVIEWFILTERS_EXPORT SurfacePieces
{
public:
  /**
   * Replace the surfaces of a tree. Those that are made stay the same objects until the data of
   * some process change. Collective: every process calls it, with a tree of the same blocks, which
   * may be empty or nullptr.
   */
  void Update(vtkDataObjectTree* tree, vtkMultiProcessController* controller);

private:
  using Leaves = std::vector<vtkSmartPointer<vtkPolyData>>;

  bool FindOwn(vtkDataObjectTree* tree);
  void Make(vtkDataObjectTree* tree, vtkMultiProcessController* controller);

  Leaves Own;  // as the tree has had them
  Leaves Made; // of them
  std::vector<vtkMTimeType> OwnTimes;
};
}

#endif
