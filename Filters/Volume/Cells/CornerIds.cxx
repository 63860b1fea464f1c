// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CornerIds.h"

#include "vtkDataArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace relevo
{
namespace
{
template <typename T, typename Array>
const T* GetValues(vtkDataArray* array)
{
  auto* values = Array::SafeDownCast(array);
  return values ? values->GetPointer(0) : nullptr;
}
}

std::uint64_t CornerIds::Append(const std::vector<vtkIdType>& ids)
{
  const std::uint64_t address = this->Wide.empty() ? this->Narrow.size() : this->Wide.size();
  constexpr vtkIdType most = std::numeric_limits<std::uint32_t>::max();
  const bool areNarrow =
    std::all_of(ids.begin(), ids.end(), [](vtkIdType id) { return id <= most; });
  if (this->Wide.empty() && areNarrow)
  {
    std::transform(ids.begin(), ids.end(), std::back_inserter(this->Narrow),
      [](vtkIdType id) { return static_cast<std::uint32_t>(id); });
    return address;
  }
  if (this->Wide.empty())
  {
    this->Wide.assign(this->Narrow.begin(), this->Narrow.end());
    std::vector<std::uint32_t>().swap(this->Narrow);
  }
  this->Wide.insert(this->Wide.end(), ids.begin(), ids.end());
  return address;
}

void CornerIds::RemoveFrom(std::uint64_t address)
{
  const size_t count = static_cast<size_t>(address);
  this->Narrow.resize(std::min(this->Narrow.size(), count));
  this->Wide.resize(std::min(this->Wide.size(), count));
}

void CornerIds::Prepare(size_t count)
{
  if (this->Wide.empty())
  {
    this->Narrow.reserve(this->Narrow.size() + count);
  }
  else
  {
    this->Wide.reserve(this->Wide.size() + count);
  }
}

void CornerIds::Refer(vtkCellArray* cells, vtkIdType firstPoint)
{
  this->WideOffsets = nullptr;
  this->NarrowOffsets = nullptr;
  if (!cells || this->Sets.size() >= MaximumSets)
  {
    return;
  }
  vtkDataArray* ids = cells->GetConnectivityArray();
  const Set set = { cells, firstPoint, GetValues<vtkTypeInt64, vtkTypeInt64Array>(ids),
    GetValues<vtkTypeInt32, vtkTypeInt32Array>(ids) };
  if (!set.Wide && !set.Narrow)
  {
    return;
  }
  this->Sets.push_back(set);
  this->WideOffsets = GetValues<vtkTypeInt64, vtkTypeInt64Array>(cells->GetOffsetsArray());
  this->NarrowOffsets = GetValues<vtkTypeInt32, vtkTypeInt32Array>(cells->GetOffsetsArray());
}

std::uint64_t CornerIds::Find(vtkIdType cell) const
{
  if (!this->WideOffsets && !this->NarrowOffsets)
  {
    return NoAddress;
  }
  const auto position = static_cast<std::uint64_t>(
    this->WideOffsets ? this->WideOffsets[cell] : this->NarrowOffsets[cell]);
  return position > Position
    ? NoAddress
    : static_cast<std::uint64_t>(this->Sets.size()) << BitsOfPosition | position;
}
}
