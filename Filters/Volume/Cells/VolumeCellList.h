// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeCellList
 * @brief   a compact list of the cells of VolumeCells
 *
 * A cell takes 8 bytes, and 8 more if scalars are those of cells. Private to the module.
 */
#ifndef VolumeCellList_h
#define VolumeCellList_h

#include "Cells/CellShape.h"
#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relevo
{
struct VolumeCell
{
  const CellShape* Shape;    // null for tetrahedra
  std::uint64_t FirstCorner; // see CornerIds; less than 2^60
  vtkIdType Scalars;         // of the cell, or -1 for point scalars
};

class RELEVOFILTERSVOLUME_EXPORT VolumeCellList
{
public:
  class Iterator
  {
  public:
    Iterator(const VolumeCellList& list, size_t index)
      : List(list)
      , Index(index)
    {
    }
    VolumeCell operator*() const { return this->List[this->Index]; }
    bool operator!=(const Iterator& other) const { return this->Index != other.Index; }
    Iterator& operator++()
    {
      ++this->Index;
      return *this;
    }

  private:
    const VolumeCellList& List;
    size_t Index;
  };

  size_t size() const { return this->Packed.size(); }
  bool empty() const { return this->Packed.empty(); }
  VolumeCell operator[](size_t i) const;
  VolumeCell front() const { return (*this)[0]; }
  VolumeCell back() const { return (*this)[this->size() - 1]; }
  Iterator begin() const { return Iterator(*this, 0); }
  Iterator end() const { return Iterator(*this, this->size()); }
  void push_back(const VolumeCell& cell);
  /// Prepares for appending `count` cells.
  void Prepare(size_t count) { this->Packed.reserve(this->Packed.size() + count); }

private:
  std::vector<std::uint64_t> Packed;     // the kind of shape in the highest bits
  std::vector<vtkIdType> ScalarsOfCells; // empty for point scalars
};
}

#endif
