// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICProcesses.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace relevo
{
namespace
{
// Smaller numbers are nearer: the bits of the depth in the flags, then the process. The remaining
// bits complete the vector, because only directions are sent separately.
constexpr vtkTypeInt64 Nothing = VTK_TYPE_INT64_MAX;
constexpr vtkTypeInt64 IsMasked = 1;
constexpr vtkTypeInt64 HasDirection = 2;

vtkTypeInt64 MakeKey(const float* vector, int process)
{
  const float depth = std::abs(vector[3]);
  std::uint32_t bits;
  std::memcpy(&bits, &depth, sizeof(bits));
  return static_cast<vtkTypeInt64>(bits) << 32 | static_cast<vtkTypeInt64>(process) << 2 |
    (vector[2] > 0.0f ? HasDirection : 0) | (vector[3] < 0.0f ? IsMasked : 0);
}

void SetByKey(float* vector, vtkTypeInt64 key)
{
  const auto bits = static_cast<std::uint32_t>(key >> 32);
  float depth;
  std::memcpy(&depth, &bits, sizeof(depth));
  vector[2] = key & HasDirection ? 1.0f : 0.0f;
  vector[3] = key & IsMasked ? -depth : depth;
}
}

void LICProcesses::Maximize(std::vector<double>& values) const
{
  const std::vector<double> own = values;
  this->Controller->AllReduce(
    own.data(), values.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
}

void LICProcesses::MergeRange(float range[2]) const
{
  const float own[2] = { -range[0], range[1] };
  this->Controller->AllReduce(own, range, 2, vtkCommunicator::MAX_OP);
  range[0] = -range[0];
}

void LICProcesses::Composite(int rectangle[4], std::vector<float>& vectors) const
{
  const bool isEmpty = rectangle[2] <= 0 || rectangle[3] <= 0;
  std::vector<double> ends(4, -VTK_DOUBLE_MAX);
  for (int i = 0; i < 2 && !isEmpty; ++i)
  {
    ends[i] = -rectangle[i];
    ends[2 + i] = rectangle[i] + rectangle[2 + i];
  }
  this->Maximize(ends);
  int whole[4] = { 0, 0, 0, 0 };
  for (int i = 0; i < 2 && ends[0] > -VTK_DOUBLE_MAX; ++i)
  {
    whole[i] = static_cast<int>(-ends[i]);
    whole[2 + i] = static_cast<int>(ends[2 + i]) - whole[i];
  }

  const int process = this->Controller->GetLocalProcessId();
  const size_t size = static_cast<size_t>(whole[2]) * whole[3];
  std::vector<vtkTypeInt64> keys(size, Nothing);
  std::vector<float> directions(2 * size, 0.0f);
  for (int row = 0; row < rectangle[3] && !isEmpty; ++row)
  {
    const float* vector = &vectors[static_cast<size_t>(4) * row * rectangle[2]];
    size_t i =
      static_cast<size_t>(row + rectangle[1] - whole[1]) * whole[2] + rectangle[0] - whole[0];
    for (int column = 0; column < rectangle[2]; ++column, vector += 4, ++i)
    {
      if (vector[3] != 0.0f)
      {
        keys[i] = MakeKey(vector, process);
        std::copy(vector, vector + 2, &directions[2 * i]);
      }
    }
  }

  std::vector<vtkTypeInt64> nearest(size);
  this->Controller->AllReduce(
    keys.data(), nearest.data(), static_cast<vtkIdType>(size), vtkCommunicator::MIN_OP);
  for (size_t i = 0; i < size; ++i)
  {
    if (keys[i] != nearest[i])
    {
      directions[2 * i] = directions[2 * i + 1] = 0.0f;
    }
  }
  std::vector<float> sum(2 * size); // of one vector and zeros
  this->Controller->AllReduce(
    directions.data(), sum.data(), static_cast<vtkIdType>(sum.size()), vtkCommunicator::SUM_OP);

  vectors.assign(4 * size, 0.0f);
  for (size_t i = 0; i < size; ++i)
  {
    if (nearest[i] != Nothing)
    {
      std::copy(&sum[2 * i], &sum[2 * i] + 2, &vectors[4 * i]);
      SetByKey(&vectors[4 * i], nearest[i]);
    }
  }
  std::copy(whole, whole + 4, rectangle);
}
}
