// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   numbers that describe vectors and tensors
 *
 * Private to the module.
 */
#ifndef ArrayQuantity_h
#define ArrayQuantity_h

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataArray;

namespace relevo
{
struct ArrayQuantity
{
  enum KindType
  {
    Component,  // of any array
    Coordinate, // of a vector
    Entry,      // of a tensor
    Magnitude,
    Mean, // of the components
    VonMises,
    Tresca,
    Principal
  };

  KindType Kind;
  std::string Name;     // in the usual spelling, for example "von Mises"
  int Index = 0;        // of a component, coordinate, row of an entry, or principal value
  int Column = 0;       // of an entry
  std::string Source{}; // name of the array; empty for the only tensor

  /// Whether an array with this number of components has those that the quantity needs.
  bool CanUse(int components) const;
  /// Describes such arrays: "6 or 9 components".
  std::string GetNeed() const;
  vtkSmartPointer<vtkDataArray> Compute(vtkDataArray* array) const;
};

/// Returns nothing if the text is not the name of a quantity.
std::optional<ArrayQuantity> ParseQuantity(const std::string& text);

/// The quantities of an array with this number of components; none for one component.
std::vector<std::string> FindQuantities(int components);
}

#endif
