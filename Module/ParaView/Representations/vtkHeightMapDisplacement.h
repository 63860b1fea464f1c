// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightMapDisplacement
 * @brief   a displacement with a height map that is read from a file
 *
 * ParaView sets each value by a property. Without a file, only Offset displaces the surface.
 *
 * @sa vtkDisplacement vtkHeightMap
 */
#ifndef vtkHeightMapDisplacement_h
#define vtkHeightMapDisplacement_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkDisplacement.h"
#include "vtkNew.h" // for Map

class vtkHeightMap;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkHeightMapDisplacement : public vtkDisplacement
{
public:
  static vtkHeightMapDisplacement* New();
  vtkTypeMacro(vtkHeightMapDisplacement, vtkDisplacement);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the file of the height map. nullptr or an empty name (the default) uses no height map.
   */
  void SetHeightMapFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetHeightMapFileName();
  //@}

  //@{
  /**
   * Set the maximum dimension. Larger rasters are read at a reduced size, see
   * vtkHeightMap::SetMaximumDimension().
   */
  void SetMaximumDimension(int dimension);
  int GetMaximumDimension();
  //@}

  //@{
  /**
   * Set whether the surface is displaced along its normals. On by default. Off, it is displaced
   * along FixedDirection, which may have any length and is (0, 0, 1) by default. A zero or
   * non-finite direction is an error and changes nothing.
   */
  void SetAlongNormals(bool along);
  vtkGetMacro(AlongNormals, bool);
  void SetFixedDirection(double x, double y, double z);
  vtkGetVector3Macro(FixedDirection, double);
  //@}

  /**
   * Update without printing errors. The mapper or filter reports why a raster cannot be read;
   * observers get the ErrorEvent.
   */
  bool Update() override;

protected:
  vtkHeightMapDisplacement();
  ~vtkHeightMapDisplacement() override;

private:
  vtkHeightMapDisplacement(const vtkHeightMapDisplacement&) = delete;
  void operator=(const vtkHeightMapDisplacement&) = delete;

  vtkNew<vtkHeightMap> Map;
  double FixedDirection[3] = { 0.0, 0.0, 1.0 };
  bool AlongNormals = true;
};

#endif
