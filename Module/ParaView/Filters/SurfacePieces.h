// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SurfacePieces
 * @brief   surfaces of a data set whose results do not depend on the number of processes
 *
 * Each piece gets the surrounding faces of other processes, or of other partitions of the data set.
 * Their vtkGhostType has vtkDataSetAttributes::DUPLICATECELL. Strips become triangles. Points and
 * faces are sorted by position, so that results that depend on their order are bit-identical on all
 * processes.
 */
#ifndef SurfacePieces_h
#define SurfacePieces_h

#include "PieceCheck.h"                  // for members
#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"             // for members
#include "vtkType.h"                     // for members

#include <vector> // for members

class vtkDataObjectTree;
class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
/// Return whether all cells have their points, and all cells and points their data.
RELEVOPARAVIEWFILTERS_EXPORT bool IsSound(vtkPolyData* mesh);

class RELEVOPARAVIEWFILTERS_EXPORT SurfacePieces
{
public:
  /// Leave out faces with points that are not finite, and update GetCheck(). Off by default.
  void SetChecked(bool isChecked) { this->IsChecked = isChecked; }
  /// Remove faces of 3D cells that occur twice, because they are inside of the mesh; see
  /// FacePolygons.h. Off by default.
  void SetSharedFacesRemoved(bool areRemoved) { this->AreSharedFacesRemoved = areRemoved; }
  /// The problems of the surfaces, the same on all processes.
  const PieceCheck& GetCheck() const { return this->Check; }

  /**
   * Replace the surfaces of a tree. The new surfaces stay the same objects until the data of a
   * process change. Collective: every process calls this method with a tree of the same blocks,
   * which may be empty or nullptr.
   */
  void Update(vtkDataObjectTree* tree, vtkMultiProcessController* controller);

private:
  using Leaves = std::vector<vtkSmartPointer<vtkPolyData>>;

  bool FindOwn(vtkDataObjectTree* tree);
  void Make(vtkDataObjectTree* tree, vtkMultiProcessController* controller);

  Leaves Own;  // as they were in the tree
  Leaves Made; // from Own
  std::vector<vtkMTimeType> OwnTimes;
  bool IsChecked = false;
  bool AreSharedFacesRemoved = false;
  PieceCheck Check;
};
}

#endif
