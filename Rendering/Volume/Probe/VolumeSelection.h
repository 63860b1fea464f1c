// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeSelection
 * @brief   draws a volume for vtkHardwareSelector, which vtkPropPicker uses
 *
 * Writes the colour of the prop, and the depth, into the pixels of the selected area at which the
 * volume becomes opaque in front of what has been drawn. Selections of cells and points ignore the
 * volume.
 *
 * Private to the module.
 */
#ifndef VolumeSelection_h
#define VolumeSelection_h

#include "Probe/ProbedVolume.h"

class vtkMatrix4x4;
class vtkRenderer;

namespace relevo
{
class VolumeSelection
{
public:
  void Draw(
    const ProbeRequest& request, vtkRenderer* renderer, vtkMatrix4x4* matrix, StageReport& report);

private:
  ProbedVolume Probed;
};
}

#endif
