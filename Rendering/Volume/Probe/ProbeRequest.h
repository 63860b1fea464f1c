// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  ProbeRequest
 * @brief   the settings of a mapper and a volume that decide where a volume is opaque
 *
 * Private to the module.
 */
#ifndef ProbeRequest_h
#define ProbeRequest_h

#include "Cells/ScalarChoice.h"
#include "Rays/BlendMode.h"
#include "Stages/MapperArray.h"

class vtkDataObject;
class vtkPlaneCollection;
class vtkVolumeProperty;

namespace relevo
{
struct ProbeRequest
{
  vtkDataObject* Input; // up to date; may be null
  ScalarChoice Choice;
  MapperArray Array;
  vtkVolumeProperty* Property;
  BlendMode Blending;
  bool HasSurfaces; // isosurfaces
  vtkPlaneCollection* ClippingPlanes;
};
}

#endif
