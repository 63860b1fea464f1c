// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ScalarTable
 * @brief   the scalars of many points or cells
 *
 * Stores only the components that are in use; the others are 0. Stores floats as long as no value
 * needs a double. Private to the modules.
 */
#ifndef ScalarTable_h
#define ScalarTable_h

#include "Integral/TransferFunctions.h" // for scalars
#include "RelevoFiltersVolumeModule.h"  // for export macro

#include <cstddef>
#include <vector>

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT ScalarTable
{
public:
  size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  Scalars operator[](size_t i) const
  {
    Scalars scalars = {};
    for (size_t c = 0; c < this->Width; ++c)
    {
      scalars[c] = this->GetValue(this->Width * i + c);
    }
    return scalars;
  }
  bool AreFinite() const;

  /// Replaces fill values of all components from an index on by NaN. Returns their magnitudes.
  std::vector<double> ReplaceFillValues(size_t first);
  void push_back(const Scalars& scalars);
  /// Appends scalars that are 0, or removes the last ones.
  void Resize(size_t count);
  /// Prepares for appending `count` scalars with this number of components.
  void Prepare(size_t count, int numberOfComponents);

private:
  double GetValue(size_t index) const
  {
    return this->IsWide ? this->Doubles[index] : static_cast<double>(this->Floats[index]);
  }
  void AddComponents(size_t width);
  void StoreDoubles();

  size_t Count = 0;
  size_t Width = 0;    // number of stored components
  bool IsWide = false; // whether Doubles has the values
  std::vector<float> Floats;
  std::vector<double> Doubles;
};
}

#endif
