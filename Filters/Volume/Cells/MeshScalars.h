// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the data sets of an input, and the array of each that is drawn
 *
 * Private to the module's own sources.
 */
#ifndef MeshScalars_h
#define MeshScalars_h

#include "Checks/MisplacedArray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;

namespace relevo
{
struct MeshScalars
{
  vtkDataSet* Mesh;
  vtkDataArray* Array;
  bool AreOfCells;
  std::string Block; // names the block before a message; empty without blocks
};

/// Which array is drawn.
struct ArrayRequest
{
  /// Of a data set, and its association; null if there is none.
  std::function<vtkDataArray*(vtkDataSet*, int& association)> Find;
  std::string Name;   // empty for active scalars
  int Association;    // that is asked for
  ArrayAdvice Advise; // what to do if it is the other one
  int MaximumComponents;
  const char* Setter; // by which users choose another one
};

/// When an input or one of its data sets last changed.
RELEVOFILTERSVOLUME_EXPORT vtkMTimeType GetMeshTime(vtkDataObject* input);

/**
 * The data sets with 3D cells and the array, of which a composite data set may have many. false
 * with words that follow "The input " where there is none, or where an array cannot be used.
 * Otherwise `warning` names the blocks that are left out, if any.
 */
RELEVOFILTERSVOLUME_EXPORT bool FindMeshScalars(vtkDataObject* input, const ArrayRequest& request,
  std::vector<MeshScalars>& found, std::string& error, std::string& warning);
}

#endif
