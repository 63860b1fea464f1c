// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CornerIds
 * @brief   the corners of cells: ids of points, copied or in the arrays of data sets
 *
 * An address is the position of an id. Ids are stored with 32 bits if possible. Private to the
 * module.
 */
#ifndef CornerIds_h
#define CornerIds_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkCellArray.h"              // for the smart pointer
#include "vtkSmartPointer.h"           // for the arrays of data sets
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relevo
{
class RELEVOFILTERSVOLUME_EXPORT CornerIds
{
public:
  static constexpr std::uint64_t NoAddress = ~std::uint64_t(0);

  vtkIdType Get(std::uint64_t address, int i) const
  {
    const std::uint64_t set = address >> BitsOfPosition;
    const size_t position = static_cast<size_t>(address & Position) + static_cast<size_t>(i);
    if (set > 0)
    {
      const Set& from = this->Sets[static_cast<size_t>(set) - 1];
      return from.FirstPoint + (from.Wide ? from.Wide[position] : from.Narrow[position]);
    }
    return this->Wide.empty() ? static_cast<vtkIdType>(this->Narrow[position])
                              : this->Wide[position];
  }

  /// Copies ids and returns the address of the first one.
  std::uint64_t Append(const std::vector<vtkIdType>& ids);
  /// Removes the ids from an address that Append() has returned.
  void RemoveFrom(std::uint64_t address);
  /// Prepares for copying `count` ids.
  void Prepare(size_t count);

  /// Refers to the cells of a data set whose first point has this id. The array must not change.
  void Refer(vtkCellArray* cells, vtkIdType firstPoint);
  /// Returns the address of a cell of the data set of the last Refer(), or NoAddress if its ids
  /// cannot be read in place.
  std::uint64_t Find(vtkIdType cell) const;

private:
  static constexpr int BitsOfPosition = 40;
  static constexpr std::uint64_t Position = (std::uint64_t(1) << BitsOfPosition) - 1;
  static constexpr size_t MaximumSets = (size_t(1) << 20) - 2;

  struct Set
  {
    vtkSmartPointer<vtkCellArray> Cells;
    vtkIdType FirstPoint;
    const vtkTypeInt64* Wide;
    const vtkTypeInt32* Narrow;
  };

  std::vector<std::uint32_t> Narrow; // copied ids, if all fit
  std::vector<vtkIdType> Wide;       // or
  std::vector<Set> Sets;
  const vtkTypeInt64* WideOffsets = nullptr; // of the last set
  const vtkTypeInt32* NarrowOffsets = nullptr;
};
}

#endif
