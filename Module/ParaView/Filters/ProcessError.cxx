// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessError.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <vector>

namespace relevo
{
std::string FindProcessError(const std::string& own, vtkMultiProcessController* controller)
{
  const int size = controller ? controller->GetNumberOfProcesses() : 1;
  if (size < 2)
  {
    return own;
  }
  const int rank = controller->GetLocalProcessId();
  const int values[2] = { own.empty() ? size : rank, own.empty() ? -1 : 0 };
  int first = size;
  int everyone = 0;
  controller->AllReduce(values, &first, 1, vtkCommunicator::MIN_OP);
  controller->AllReduce(values + 1, &everyone, 1, vtkCommunicator::MIN_OP);
  if (first == size)
  {
    return "";
  }
  int length = static_cast<int>(own.size());
  controller->Broadcast(&length, 1, first);
  std::vector<char> text(own.begin(), own.end());
  text.resize(static_cast<std::size_t>(length));
  controller->Broadcast(text.data(), length, first);
  const std::string message(text.begin(), text.end());
  return everyone == 0 ? message
                       : "On rank " + std::to_string(first) + ", but not on all: " + message;
}

bool IsReportingProcess(vtkMultiProcessController* controller)
{
  return !controller || controller->GetLocalProcessId() == 0;
}
}
