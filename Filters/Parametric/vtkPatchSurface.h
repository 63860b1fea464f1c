// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPatchSurface
 * @brief   evaluate the Bézier patches of a mesh of vtkPatchSurfaceFilter
 *
 * Each triangle of the mesh is part of a patch with degrees from 1 to 8, rational if weights
 * differ. Positions are those of the patch. Normals are cross products of its derivatives. Where
 * these vanish, for example along an edge that degenerates to a point, normals are the limit from
 * the interior of the patch. Patches that meet at a sharp edge have different normals there.
 *
 * Points on a border are computed from the control points of that border only, in an order that the
 * border determines. Patches that share the control points and weights of a border therefore match
 * to the bit. Displacement follows the normals; on borders the mean normal of the first two
 * patches, and at corners the point normals of the mesh. A displaced surface therefore has no
 * cracks either.
 *
 * Point arrays whose coefficients are in the mesh are evaluated in the same basis. If one
 * coefficient is missing (see vtkAdaptiveRefinement::SetNoDataMagnitude()), the patch has no data
 * between its corners.
 *
 * A mesh without patches, or with inconsistent arrays, is an error.
 *
 * Source: G. Farin, "Curves and Surfaces for CAGD", 2002, for rational Bézier patches and Horner's
 * scheme for Bernstein polynomials.
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
