// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainProbe
 * @brief   heights of a terrain by its own x and y
 */
#ifndef TerrainProbe_h
#define TerrainProbe_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkHeightField;
class vtkPolyData;
class vtkStaticCellLocator;

class TerrainProbe
{
public:
  /// The flat mesh, with texture coordinates, and the heights over them.
  TerrainProbe(vtkPolyData* mesh, vtkHeightField* heights);
  ~TerrainProbe();

  /// The raster's height; false where there is no terrain, or no data.
  bool GetHeight(double x, double y, double& height);

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkHeightField> Heights;
  vtkNew<vtkStaticCellLocator> Locator;
};

#endif
