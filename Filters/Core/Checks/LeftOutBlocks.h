// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LeftOutBlocks
 * @brief   describes which blocks of a composite data set are skipped, and why
 */
#ifndef LeftOutBlocks_h
#define LeftOutBlocks_h

#include "RelevoFiltersCoreModule.h" // for export macro

#include <string>

class vtkCompositeDataIterator;

namespace relevo
{
/// "Block N", followed by its name in brackets if it has one.
RELEVOFILTERSCORE_EXPORT std::string GetBlockName(vtkCompositeDataIterator* leaf);

/// Creates one sentence for each of the first blocks and one for all others.
class RELEVOFILTERSCORE_EXPORT LeftOutBlocks
{
public:
  /// `lack` follows the name of the block, for example "has no 3D cells".
  void Add(const std::string& name, const std::string& lack);
  /// The sentences; empty if there are no blocks.
  std::string GetText() const;

private:
  std::string Sentences;
  int Count = 0;
  int NumberOfMore = 0;
};
}

#endif
