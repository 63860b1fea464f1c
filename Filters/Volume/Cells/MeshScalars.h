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

#include "RelevoFiltersVolumeModule.h" // for export macro

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
};

/// The array of a data set, and its association; null if there is none.
using FindArray = std::function<vtkDataArray*(vtkDataSet*, int& association)>;

/**
 * All data sets with cells, of which a composite data set may have many. false with words that
 * follow "The input " where one lacks an array that fits, or points that its cells refer to: `name`
 * is the array's, empty for active scalars, and `most` how many components it may have.
 */
RELEVOFILTERSVOLUME_EXPORT bool FindMeshScalars(vtkDataObject* input, const FindArray& find,
  const std::string& name, int most, std::vector<MeshScalars>& found, std::string& error);
}

#endif
