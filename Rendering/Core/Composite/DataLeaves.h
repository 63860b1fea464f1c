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
  unsigned int FlatIndex = 0; // 0 of an input that is not composite
  vtkDataObject* Data = nullptr;

  /// The start of messages about the leaf: its index, or nothing where it is the only one.
  std::string GetPrefix() const
  {
    return this->FlatIndex == 0 ? "" : "Block " + std::to_string(this->FlatIndex) + ": ";
  }
};

/// The leaves that are not empty, in the order of their indices; none without an input.
RELEVORENDERINGCORE_EXPORT std::vector<DataLeaf> FindDataLeaves(vtkDataObject* input);

/// On the input and all its leaves.
RELEVORENDERINGCORE_EXPORT Dependencies GetLeafDependencies(vtkDataObject* input);

/// A composite data set of the same structure, with replace(flat index) in place of each leaf.
RELEVORENDERINGCORE_EXPORT vtkSmartPointer<vtkCompositeDataSet> ReplaceLeaves(
  vtkCompositeDataSet* composite, const std::function<vtkDataObject*(unsigned int)>& replace);
}

#endif
