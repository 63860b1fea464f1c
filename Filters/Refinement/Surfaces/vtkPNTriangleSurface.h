// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPNTriangleSurface
 * @brief   curved PN triangles: a cubic patch per coarse triangle, made of its points and normals
 *
 * Source: A. Vlachos, J. Peters, C. Boyd, J. Mitchell, "Curved PN Triangles", I3D 2001. The control
 * point near P1 on the edge to P2 is b210 = (2 P1 + P2 - ((P2 - P1) . N1) N1) / 3, and similarly
 * for the others. The centre is b111 = E + (E - V) / 2, where E is the mean of the six edge points
 * and V is the mean of the corners. The patch interpolates the coarse points. Patches meet without
 * gaps, also along creases, where the control points of both sides are averaged.
 *
 * The point normals of the input are used. Missing normals are computed from the faces.
 *
 * @sa vtkAdaptiveRefinement vtkLinearSurface
 */
#ifndef vtkPNTriangleSurface_h
#define vtkPNTriangleSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkRefinementSurface.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkPNTriangleSurface : public vtkRefinementSurface
{
public:
  static vtkPNTriangleSurface* New();
  vtkTypeMacro(vtkPNTriangleSurface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set whether normals vary quadratically, which preserves inflections, or linearly. The default
   * is on. The normal at the midpoint of an edge is n110 = normalize(N1 + N2 - v12 (P2 - P1)), with
   * v12 = 2 (P2 - P1) . (N1 + N2) / ((P2 - P1) . (P2 - P1)).
   */
  vtkSetMacro(QuadraticNormals, bool);
  vtkGetMacro(QuadraticNormals, bool);
  vtkBooleanMacro(QuadraticNormals, bool);
  //@}

  bool NeedsNormals() override { return true; }
  int GetNumberOfEdgePositions() override { return 2; }
  int GetNumberOfEdgeNormals() override { return this->QuadraticNormals ? 1 : 0; }
  int GetNumberOfFacePositions() override { return 1; }

#ifndef __VTK_WRAP__
  void ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors) override;
  void ComputeFaceVectors(const Face& face, float* vectors, float* edgeNormals[3]) override;
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  float ComputeNormalCone(const Face& face, float axis[3]) override;
  std::string GetShaderSource() override;
#endif

protected:
  vtkPNTriangleSurface();
  ~vtkPNTriangleSurface() override;

  bool QuadraticNormals = true;

private:
  vtkPNTriangleSurface(const vtkPNTriangleSurface&) = delete;
  void operator=(const vtkPNTriangleSurface&) = delete;
};

#endif
