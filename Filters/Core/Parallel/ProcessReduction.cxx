// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/ProcessReduction.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <numeric>

namespace relevo
{
void ProcessReduction::Reduce(std::vector<double>& values, int operation) const
{
  std::vector<double> all(values.size());
  this->Controller->AllReduce(
    values.data(), all.data(), static_cast<vtkIdType>(values.size()), operation);
  values = all;
}

void ProcessReduction::Add(std::vector<double>& values) const
{
  this->Reduce(values, vtkCommunicator::SUM_OP);
}

void ProcessReduction::TakeLargest(std::vector<double>& values) const
{
  this->Reduce(values, vtkCommunicator::MAX_OP);
}

std::vector<double> ProcessReduction::Collect(std::vector<double> values) const
{
  const vtkIdType own = static_cast<vtkIdType>(values.size());
  std::vector<vtkIdType> sizes(this->Controller->GetNumberOfProcesses());
  this->Controller->AllGather(&own, sizes.data(), 1);
  std::vector<vtkIdType> offsets(sizes.size(), 0);
  std::partial_sum(sizes.begin(), sizes.end() - 1, offsets.begin() + 1);
  std::vector<double> all(offsets.back() + sizes.back());
  this->Controller->AllGatherV(values.data(), all.data(), own, sizes.data(), offsets.data());
  return all;
}
}
