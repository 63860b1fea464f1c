// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceData
 * @brief   what a surface takes from the mesh: numbers per point, and tables
 *
 * A part of vtkRefinementSurface; see GetNumberOfPointValues() and HasTables() there.
 */
#ifndef SurfaceData_h
#define SurfaceData_h

#include "Surfaces/SurfaceFace.h"

#include <string> // for errors

class vtkPolyData;

namespace relevo
{
class SurfaceData
{
public:
  /**
   * Fill GetNumberOfPointValues() numbers for each point of the mesh. False, with an error to show
   * the user, when the mesh lacks what is needed.
   */
  virtual bool GetPointValues(vtkPolyData*, float*, std::string&) { return true; }

  /**
   * Fill the tables, with positions relative to `origin`. False, with an error to show the user,
   * when the mesh lacks what is needed.
   */
  virtual bool BuildTables(vtkPolyData*, const double[3], SurfaceTables&, std::string&)
  {
    return true;
  }

protected:
  SurfaceData() = default;
  ~SurfaceData() = default;
};
}

#endif
