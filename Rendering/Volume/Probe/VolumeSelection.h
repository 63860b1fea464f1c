// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeSelection
 * @brief   draws a volume for vtkHardwareSelector, which vtkPropPicker uses
 *
 * Rays through the selected pixels end where the volume becomes opaque. If this place is nearer
 * than everything drawn before, the pixel gets the prop's colour and the depth of the place. The
 * volume is not part of selections of cells and points.
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
