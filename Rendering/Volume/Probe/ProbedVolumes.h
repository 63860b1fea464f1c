// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ProbedVolumes
 * @brief   the probed volumes of several mappers
 *
 * Private to the module.
 */
#ifndef ProbedVolumes_h
#define ProbedVolumes_h

#include "Probe/ProbedVolume.h"
#include "vtkWeakPointer.h"

#include <list>

class vtkAbstractVolumeMapper;

namespace relevo
{
class ProbedVolumes
{
public:
  /// Return the volume of a mapper. Volumes of mappers that no longer exist are removed.
  ProbedVolume& Get(vtkAbstractVolumeMapper* mapper);

private:
  struct Entry
  {
    vtkWeakPointer<vtkAbstractVolumeMapper> Mapper;
    ProbedVolume Volume;
  };
  std::list<Entry> Entries;
};
}

#endif
