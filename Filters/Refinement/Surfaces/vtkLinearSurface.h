// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLinearSurface
 * @brief   the coarse triangles without curvature
 *
 * Positions and normals are interpolated linearly (Lenz 2009, eq. 3.4). A recipe without a surface
 * uses this one.
 *
 * @sa vtkAdaptiveRefinement
 */
#ifndef vtkLinearSurface_h
#define vtkLinearSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkRefinementSurface.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkLinearSurface : public vtkRefinementSurface
{
public:
  static vtkLinearSurface* New();
  vtkTypeMacro(vtkLinearSurface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  float ComputeNormalCone(const Face& face, float axis[3]) override;
  std::string GetShaderSource() override;
#endif

protected:
  vtkLinearSurface();
  ~vtkLinearSurface() override;

private:
  vtkLinearSurface(const vtkLinearSurface&) = delete;
  void operator=(const vtkLinearSurface&) = delete;
};

#endif
