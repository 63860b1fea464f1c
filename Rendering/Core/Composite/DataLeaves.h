// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the data sets in a mapper's input: the input itself, or the leaves of a composite one
 *
 * Private to the modules.
 */
#ifndef DataLeaves_h
#define DataLeaves_h

#include "Changes/Dependencies.h"
#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkSmartPointer.h"           // for copies

#include <functional> // for replacements
#include <string>     // for prefixes
#include <vector>     // for leaves

class vtkCompositeDataSet;
class vtkDataObject;

namespace relevo
{
struct DataLeaf
{
  unsigned int FlatIndex = 0; // 0 for an input that is not composite
  vtkDataObject* Data = nullptr;

  /// Return the start of messages about the leaf: its index, or nothing if the input is not
  /// composite.
  std::string GetPrefix() const
  {
    return this->FlatIndex == 0 ? "" : "Block " + std::to_string(this->FlatIndex) + ": ";
  }
};

/// Return the leaves that are not empty, ordered by index; none without an input.
RELEVORENDERINGCORE_EXPORT std::vector<DataLeaf> FindDataLeaves(vtkDataObject* input);

/// Return dependencies on the input and all its leaves.
RELEVORENDERINGCORE_EXPORT Dependencies GetLeafDependencies(vtkDataObject* input);

/// Return a composite data set of the same structure, with each leaf replaced by replace(flat
/// index).
RELEVORENDERINGCORE_EXPORT vtkSmartPointer<vtkCompositeDataSet> ReplaceLeaves(
  vtkCompositeDataSet* composite, const std::function<vtkDataObject*(unsigned int)>& replace);
}

#endif
