// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMicroMeshSurface
 * @brief   evaluate the displacements of a mesh of vtkMicroMeshFilter
 *
 * The surface is linear on the triangles of each face's grid. At MaximumLevel of the filter or
 * above, vtkAdaptiveRefinement therefore yields the surface whose error the filter measured, to the
 * accuracy of floats. At lower levels, points of the refined mesh lie on this surface.
 *
 * Both faces at an edge read the same samples in the same order. The surface is therefore
 * watertight at all combinations of levels. Normals are those of the displaced surface. They are
 * stored with 8 bits per octahedral coordinate and interpolated between grid points. At the corners
 * of faces, the point normals of the mesh are used, which differ on both sides of sharp edges.
 *
 * Point arrays that vtkMicroMeshFilter sampled on the grids (AttributesOn()) are evaluated linearly
 * between grid points: by vtkAdaptiveRefinementFilter at all points, and by mappers at every pixel.
 * Values are interpolated first and then mapped to colours. Cell arrays have a value per triangle
 * of the grids.
 *
 * A mesh without the arrays of vtkMicroMeshFilter, or with inconsistent arrays, is an error.
 *
 * @sa vtkMicroMeshFilter vtkAdaptiveRefinement
 */
#ifndef vtkMicroMeshSurface_h
#define vtkMicroMeshSurface_h

#include "RelevoFiltersMicroMeshModule.h" // for export macro
#include "vtkRefinementSurface.h"

#ifdef __VTK_WRAP__
class RELEVOFILTERSMICROMESH_EXPORT vtkMicroMeshSurface : public vtkRefinementSurface
#else
#include "Surfaces/SurfaceFieldShading.h" // for the superclass

class RELEVOFILTERSMICROMESH_EXPORT vtkMicroMeshSurface
  : public vtkRefinementSurface
  , public relevo::SurfaceFieldShading
#endif
{
public:
  static vtkMicroMeshSurface* New();
  vtkTypeMacro(vtkMicroMeshSurface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool NeedsNormals() override { return true; }
  bool HasTables() override { return true; }
  bool HasInterpolatedNormals() override { return false; }
  int GetNumberOfPointValues() override { return 3; }
  int GetNumberOfShaderValues() override { return 3; }

#ifndef __VTK_WRAP__
  bool GetPointValues(vtkPolyData* mesh, float* values, std::string& error) override;
  bool BuildTables(
    vtkPolyData* mesh, const double origin[3], Tables& tables, std::string& error) override;
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  vtkDataArray* FindCoefficients(vtkPolyData* mesh, vtkDataArray* pointArray) override;
  void EvaluateField(
    const Face& face, const float weights[3], vtkDataArray* coefficients, double* tuple) override;
  void ExtendBox(const Face& face, double low[3], double high[3]) override;
  std::string GetShaderSource() override;
  std::string GetFieldShaderSource() override;
  vtkSmartPointer<vtkDataArray> FindCellValues(vtkPolyData* mesh, vtkDataArray* cellArray) override;
  vtkIdType FindCellTuple(const Face& face, const float weights[3]) override;
  std::string GetCellFieldShaderSource() override;
#endif

protected:
  vtkMicroMeshSurface();
  ~vtkMicroMeshSurface() override;

private:
  vtkMicroMeshSurface(const vtkMicroMeshSurface&) = delete;
  void operator=(const vtkMicroMeshSurface&) = delete;
};

#endif
