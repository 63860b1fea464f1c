// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankExchange.h"

#include "vtkType.h"

namespace relevo
{
std::vector<Bytes> RankExchange::Gather(const Bytes& own, int at) const
{
  const auto size = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> sizes = this->Share(size);
  std::vector<vtkIdType> offsets = { 0 };
  for (vtkIdType each : sizes)
  {
    offsets.push_back(offsets.back() + each);
  }
  const bool isReceiver = this->Controller->GetLocalProcessId() == at;
  Bytes all(isReceiver ? static_cast<std::size_t>(offsets.back()) : 0);
  this->Controller->GatherV(own.data(), all.data(), size, sizes.data(), offsets.data(), at);
  std::vector<Bytes> messages;
  for (std::size_t i = 0; i < sizes.size() && isReceiver; ++i)
  {
    messages.emplace_back(all.begin() + offsets[i], all.begin() + offsets[i + 1]);
  }
  return messages;
}
}
