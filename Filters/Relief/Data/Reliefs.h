// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the reliefs of a data object: an image, or the blocks of a composite data set
 *
 * Private to the modules' own sources.
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
  /// As vtkCompositeDataSet counts blocks; 0 of an image by itself.
  unsigned int FlatIndex = 0;
  /// What the composite data set calls it, or "".
  std::string Name;
  Relief Data;
  /// Why it is no relief, with the block that it is about, for an ErrorEvent; or "".
  std::string Error;

  /// A sentence about the block, for an ErrorEvent.
  std::string Describe(const std::string& sentence) const;
};

/// A block for the image, or for each leaf of a composite data set that is not empty.
RELEVOFILTERSRELIEF_EXPORT std::vector<ReliefBlock> ReadReliefs(vtkDataObject* input);
}

#endif
