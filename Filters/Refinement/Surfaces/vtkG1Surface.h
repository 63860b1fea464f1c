// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkG1Surface
 * @brief   curved triangles whose tangent planes join along edges, made of points and normals
 *
 * PN triangles meet without gaps, but with a kink along each edge that their normals, which are not
 * those of the surface, paint over. Here neighbours have the same tangent plane all along their
 * edge (G1).
 *
 * The edges' curves are those of vtkPNTriangleSurface. Along an edge from P0 to P1 let W(t) be the
 * curve's derivative, a quadratic Bezier curve with points W0, W1, W2, and A(t) the one with points
 * A0 = N0 x W0 / |N0 x W0|, A2 = N1 x W2 / |N1 x W2|, A1 = (A0 + A2) / |A0 + A2|. The patch's
 * derivative across the edge is made l(t) W(t) + m(t) A(t), l and m linear and such that it fits
 * the other two edges' curves at the ends: its plane depends on the edge alone. This gives, for
 * each edge, two inner points of a quartic patch. The two that different edges ask for near a
 * corner are blended by w1 / (w1 + w2) and w2 / (w1 + w2), with w1 and w2 the weights of the
 * corners that the edges lead to (Gregory's rational blending).
 *
 * D. Walton, D. Meek, "A triangular G1 patch from boundary curves", Computer-Aided Design 28, 1996;
 * PN triangles made G1 in this way: C. Fuenfzig, K. Mueller, D. Hansford, G. Farin, "PNG1 triangles
 * for tangent plane continuous surfaces on the GPU", Graphics Interface 2008. Evaluated here as the
 * cubic patch of PN triangles whose centre point varies, which is the same patch.
 *
 * The surface interpolates the coarse points and, where faces around a point see the same normal
 * there, the normals; it reproduces planes. Along creases, where they see different ones, the
 * curves of the sides are averaged: the surface stays closed, each side keeps its own tangent
 * planes but for the crease's ends, and shading is sharp. Where normals contradict a triangle the
 * patch is restrained, and tangent planes do not quite join: inner points stay within half the
 * length of the longest edge from where PN triangles have their centre point.
 *
 * Normals that are the surface's own also show how it undulates between coarse points, which the
 * interpolated ones of PN triangles hide: on coarse scans PN triangles look smoother.
 *
 * Point normals of the input are used; where there are none they are computed from the faces.
 * Where the patch itself is degenerate, geometric normals are interpolated ones.
 *
 * @sa vtkAdaptiveRefinement vtkPNTriangleSurface
 */
#ifndef vtkG1Surface_h
#define vtkG1Surface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkRefinementSurface.h"

class RELEVOFILTERSREFINEMENT_EXPORT vtkG1Surface : public vtkRefinementSurface
{
public:
  static vtkG1Surface* New();
  vtkTypeMacro(vtkG1Surface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether normals are those of the surface itself, continuous across edges, or, by default, the
   * quadratic ones of vtkPNTriangleSurface. The former are for measuring, for offsets and
   * reflections; they show every flat spot that the few points and normals of a coarse mesh leave.
   * The latter look smoother.
   */
  vtkSetMacro(GeometricNormals, bool);
  vtkGetMacro(GeometricNormals, bool);
  vtkBooleanMacro(GeometricNormals, bool);
  //@}

  bool NeedsNormals() override { return true; }
  int GetNumberOfEdgePositions() override { return 2; }
  int GetNumberOfEdgeNormals() override { return this->GeometricNormals ? 3 : 1; }
  int GetNumberOfFacePositions() override { return 6; }
  bool HasInterpolatedNormals() override { return !this->GeometricNormals; }

#ifndef __VTK_WRAP__
  void ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors) override;
  void ComputeFaceVectors(const Face& face, float* vectors, float* edgeNormals[3]) override;
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  std::string GetShaderSource() override;
#endif

protected:
  vtkG1Surface();
  ~vtkG1Surface() override;

  bool GeometricNormals = false;

private:
  vtkG1Surface(const vtkG1Surface&) = delete;
  void operator=(const vtkG1Surface&) = delete;
};

#endif
