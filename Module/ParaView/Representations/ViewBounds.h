// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the bounds that representations give to their views
 *
 * Private to the module.
 */
#ifndef ViewBounds_h
#define ViewBounds_h

class vtkAbstractMapper3D;
class vtkInformation;
class vtkPVDataRepresentation;
class vtkProp3D;

namespace relevo
{
/// Get the bounds of a mapper without its errors and warnings, which it repeats when it draws.
void MeasureBounds(vtkAbstractMapper3D* mapper, double bounds[6]);

/// Give bounds to the view that calls with REQUEST_UPDATE(). The prop has the transform.
void GiveBounds(vtkInformation* inInfo, vtkPVDataRepresentation* representation,
  const double bounds[6], vtkProp3D* prop);
}

#endif
