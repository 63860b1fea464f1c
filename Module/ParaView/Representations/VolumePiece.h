// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumePiece
 * @brief   the data that a process gives to a view for volume rendering
 *
 * A piece is a copy of a data set, or of the selected blocks of a composite data set. The arrays
 * are shared. The field data hold the unit distance, because views cache pieces of animations.
 *
 * Private to the module.
 */
#ifndef VolumePiece_h
#define VolumePiece_h

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkExtractBlockUsingDataAssembly;
class vtkMultiProcessController;

namespace relevo
{
class VolumePiece
{
public:
  VolumePiece();

  /// The filter that selects blocks. Initially, it selects all.
  vtkExtractBlockUsingDataAssembly* GetBlocks() { return this->Blocks; }

  /// Return the piece of an input; nullptr gives an empty piece.
  vtkSmartPointer<vtkDataObject> Make(vtkDataObject* input);

  /**
   * Store the diagonal of the bounds of all processes' inputs, divided by the cube root of the
   * number of cells without ghost cells, in a new piece. Both may be nullptr. Collective.
   */
  static void StoreUnitDistance(
    vtkDataObject* piece, vtkDataObject* input, vtkMultiProcessController* controller);
  /// Return the stored unit distance, or 1.
  static double GetUnitDistance(vtkDataObject* piece);

  /// Return the data sets of a piece.
  static std::vector<vtkDataSet*> GetDataSets(vtkDataObject* piece);

  static vtkBoundingBox GetBox(vtkDataObject* piece);

  /// Return the number of components of an array in the first data set that has it, or 0.
  static int GetNumberOfComponents(vtkDataObject* piece, int association, const std::string& name);

private:
  vtkNew<vtkExtractBlockUsingDataAssembly> Blocks;
};
}

#endif
