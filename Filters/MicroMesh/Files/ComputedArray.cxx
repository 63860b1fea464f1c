// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ComputedArray.h"

#include "Data/LevelErrors.h"
#include "Data/MicroMeshArrays.h"
#include "Data/MicroNormals.h"
#include "Files/ArrayPacking.h"
#include "Files/BitList.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"

#include <cstring>

namespace relevo
{
namespace
{
constexpr int BitsOfFloat = 32;
}

vtkSmartPointer<vtkFloatArray> ComputeMicroPointData(const MicroMesh& mesh, const char* name)
{
  return name && std::strcmp(name, MicroNormalsName) == 0 ? MakePointNormals(mesh) : nullptr;
}

vtkSmartPointer<vtkFloatArray> ComputeMicroCellData(const MicroMesh& mesh, const char* name)
{
  return name && std::strcmp(name, MicroLevelErrorsName) == 0 ? MakeLevelErrors(mesh) : nullptr;
}

bool IsLikeComputed(vtkDataArray* array, vtkFloatArray* computed)
{
  return vtkFloatArray::SafeDownCast(array) &&
    array->GetNumberOfComponents() == computed->GetNumberOfComponents() &&
    array->GetNumberOfTuples() == computed->GetNumberOfTuples();
}

std::string PackOtherTuples(vtkDataArray* array, vtkFloatArray* computed)
{
  const auto tuples = static_cast<std::size_t>(computed->GetNumberOfTuples());
  const auto components = static_cast<std::size_t>(computed->GetNumberOfComponents());
  const auto values = vtkFloatArray::SafeDownCast(array)->GetPointer(0);
  const float* usual = computed->GetPointer(0);
  std::string bytes;
  vtkNew<vtkFloatArray> others;
  others->SetNumberOfComponents(computed->GetNumberOfComponents());
  for (std::size_t i = 0; i < tuples; ++i)
  {
    const std::size_t first = components * i;
    const bool isOther =
      std::memcmp(values + first, usual + first, components * sizeof(float)) != 0;
    AppendBit(isOther, i, bytes);
    if (isOther)
    {
      others->InsertNextTypedTuple(values + first);
    }
  }
  return bytes + PackArray(others, BitsOfFloat);
}

bool UnpackOtherTuples(std::string_view bytes, vtkFloatArray* computed)
{
  const auto tuples = static_cast<std::size_t>(computed->GetNumberOfTuples());
  const std::string_view bits = bytes.substr(0, GetBitListSize(tuples));
  bytes.remove_prefix(bits.size());
  vtkIdType number = 0;
  for (std::size_t i = 0; i < tuples && i < 8 * bits.size(); ++i)
  {
    number += IsBitSet(bits, i) ? 1 : 0;
  }
  vtkNew<vtkFloatArray> others;
  others->SetNumberOfComponents(computed->GetNumberOfComponents());
  others->SetNumberOfTuples(number);
  if (bits.size() != GetBitListSize(tuples) ||
    bytes.size() != sizeof(float) * static_cast<std::size_t>(others->GetNumberOfValues()))
  {
    return false;
  }
  UnpackArray(bytes, BitsOfFloat, others);
  vtkIdType next = 0;
  for (std::size_t i = 0; i < tuples; ++i)
  {
    if (IsBitSet(bits, i))
    {
      computed->SetTuple(static_cast<vtkIdType>(i), next++, others);
    }
  }
  return true;
}
}
