// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatchSurface
 * @brief   the Bézier patches that a mesh of vtkPatchSurfaceFilter carries
 *
 * Each triangle of the mesh is a part of a patch, of degree 1 to 8 in each direction, rational
 * where weights differ. Its points are those of the patch itself, and its normals the product of
 * the patch's derivatives; where these vanish, as along an edge that is one point, their limit from
 * the patch's middle. Patches that meet at a sharp edge have different normals there.
 *
 * Points of a patch's border come from the control points of that border alone, in an order that
 * the border fixes: the surface is closed to the bit wherever two patches have the control points
 * and weights of a border in common. Displacement goes along the normals; on borders along the mean
 * of those of the first two patches there, and at corners along the mesh's point normals, so that
 * what is displaced stays closed, too.
 *
 * Point arrays whose coefficients the mesh brings along are evaluated by the same basis; a patch
 * with one that stands for no data (vtkAdaptiveRefinement::SetNoDataMagnitude()) has none between
 * its corners.
 *
 * A mesh without patches, or with arrays that do not fit, is an error.
 *
 * G. Farin, "Curves and Surfaces for CAGD", 2002: rational Bézier patches, Horner's scheme for
 * Bernstein polynomials.
 *
 * @sa vtkPatchSurfaceFilter vtkAdaptiveRefinement vtkPatchErrorDepthTagMetric
 */
#ifndef vtkPatchSurface_h
#define vtkPatchSurface_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkRefinementSurface.h"

class RELEVOFILTERSPARAMETRIC_EXPORT vtkPatchSurface : public vtkRefinementSurface
{
public:
  static vtkPatchSurface* New();
  vtkTypeMacro(vtkPatchSurface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool NeedsNormals() override { return true; }
  bool HasTables() override { return true; }
  bool HasDirections() override { return true; }
  bool HasInterpolatedNormals() override { return false; }

#ifndef __VTK_WRAP__
  bool BuildTables(
    vtkPolyData* mesh, const double origin[3], Tables& tables, std::string& error) override;
  bool SplitsNormals(const Face& face) override;
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  void EvaluateDirection(const Face& face, const float weights[3], float direction[3]) override;
  vtkDataArray* FindCoefficients(vtkPolyData* mesh, vtkDataArray* pointArray) override;
  void EvaluateField(
    const Face& face, const float weights[3], vtkDataArray* coefficients, double* tuple) override;
  void ExtendBox(const Face& face, double low[3], double high[3]) override;
  std::string GetShaderSource() override;
#endif

protected:
  vtkPatchSurface();
  ~vtkPatchSurface() override;

private:
  vtkPatchSurface(const vtkPatchSurface&) = delete;
  void operator=(const vtkPatchSurface&) = delete;
};

#endif
