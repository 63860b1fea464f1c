// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   access to the reliefs of an image or a composite data set
 *
 * Private to the modules.
 */
#ifndef Reliefs_h
#define Reliefs_h

#include "Data/Relief.h"
#include "RelevoFiltersReliefModule.h" // for export macro

#include <string>
#include <vector>

class vtkDataObject;

namespace relevo
{
struct RELEVOFILTERSRELIEF_EXPORT ReliefBlock
{
  /// Flat index of vtkCompositeDataSet; 0 for an image.
  unsigned int FlatIndex = 0;
  /// Name of the block, or "".
  std::string Name;
  Relief Data;
  /// Why the block is not a relief, as an error message with the name of the block, or "".
  std::string Error;

  /// Adds the name of the block to a sentence, for an error message.
  std::string Describe(const std::string& sentence) const;
};

/// Reads the image, or each leaf of a composite data set that is not empty.
RELEVOFILTERSRELIEF_EXPORT std::vector<ReliefBlock> ReadReliefs(vtkDataObject* input);
}

#endif
