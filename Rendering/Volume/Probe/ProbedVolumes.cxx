// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe/ProbedVolumes.h"

#include "vtkAbstractVolumeMapper.h"

namespace relevo
{
ProbedVolume& ProbedVolumes::Get(vtkAbstractVolumeMapper* mapper)
{
  this->Entries.remove_if([](const Entry& entry) { return !entry.Mapper; });
  for (Entry& entry : this->Entries)
  {
    if (entry.Mapper == mapper)
    {
      return entry.Volume;
    }
  }
  this->Entries.emplace_back();
  this->Entries.back().Mapper = mapper;
  return this->Entries.back().Volume;
}
}
