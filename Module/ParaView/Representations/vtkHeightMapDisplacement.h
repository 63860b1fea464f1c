// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeightMapDisplacement
 * @brief   a displacement with a height map of its own, by the name of its file
 *
 * As ParaView sets it, by single values. Without a file the surface is moved by Offset alone.
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
   * The raster of heights; nullptr or empty, the default, for none.
   */
  void SetHeightMapFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetHeightMapFileName();
  //@}

  //@{
  /**
   * Larger rasters are read at a reduced size, see vtkHeightMap::SetMaximumDimension().
   */
  void SetMaximumDimension(int dimension);
  int GetMaximumDimension();
  //@}

  //@{
  /**
   * Whether the surface is moved along its normals, the default; else along FixedDirection, (0, 0,
   * 1) by default, of any length. A direction that is zero or not finite is an error and changes
   * nothing.
   */
  void SetAlongNormals(bool along);
  vtkGetMacro(AlongNormals, bool);
  void SetFixedDirection(double x, double y, double z);
  vtkGetVector3Macro(FixedDirection, double);
  //@}

  /**
   * Prints no error: what draws or refines says in one why the raster cannot be read. Observers get
   * the ErrorEvent.
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
