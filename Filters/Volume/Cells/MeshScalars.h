// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the data sets of an input and their scalar arrays
 *
 * Private to the module.
 */
#ifndef MeshScalars_h
#define MeshScalars_h

#include "Checks/MisplacedArray.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkDataArray.h"              // for the smart pointer
#include "vtkDataSet.h"                // for the smart pointer
#include "vtkSmartPointer.h"           // for arrays
#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;

namespace relevo
{
struct MeshScalars
{
  vtkDataSet* Mesh;
  vtkSmartPointer<vtkDataArray> Array;
  bool AreOfCells;
  std::string Block; // name of the block for messages; empty without blocks
  vtkSmartPointer<vtkDataSet> Copy = nullptr; // Mesh, if it is not the one of the input

  /// Returns the begin of a message about the block.
  std::string GetPrefix() const { return this->Block.empty() ? "" : this->Block + ": "; }
};

/// The requested array.
struct ArrayRequest
{
  /// Returns the array of a data set and its association, or null.
  std::function<vtkDataArray*(vtkDataSet*, int& association)> Find;
  std::string Name;   // empty for active scalars
  int Association;    // the requested association
  ArrayAdvice Advise; // advice if the array has the other association
  int MaximumComponents;
  const char* Setter; // the setter that chooses another array
};

/// Returns the latest modification time of an input and its data sets.
RELEVOFILTERSVOLUME_EXPORT vtkMTimeType GetMeshTime(vtkDataObject* input);

/**
 * Finds the data sets with 3D cells and the array in an input that may be composite. Returns false
 * with an `error`, as a continuation of "The input ", if there is none or an array is invalid.
 * Otherwise `warning` lists blocks that are skipped.
 */
RELEVOFILTERSVOLUME_EXPORT bool FindMeshScalars(vtkDataObject* input, const ArrayRequest& request,
  std::vector<MeshScalars>& found, std::string& error, std::string& warning);
}

#endif
