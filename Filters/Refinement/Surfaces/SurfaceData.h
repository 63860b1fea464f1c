// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::SurfaceData
 * @brief   the data that a surface takes from the mesh: values per point, and tables
 *
 * Part of vtkRefinementSurface; see GetNumberOfPointValues() and HasTables() there.
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
   * Fill GetNumberOfPointValues() numbers for each point of the mesh. Returns false and an error
   * for the user if data are missing in the mesh.
   */
  virtual bool GetPointValues(vtkPolyData*, float*, std::string&) { return true; }

  /**
   * Fill the tables, with positions relative to `origin`. Returns false and an error for the user
   * if data are missing in the mesh.
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
