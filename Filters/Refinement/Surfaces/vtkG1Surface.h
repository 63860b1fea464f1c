// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkG1Surface
 * @brief   curved triangles with continuous tangent planes across edges, made of points and normals
 *
 * PN triangles meet without gaps, but with a kink along each edge. Their normals, which are not
 * those of the surface, hide the kink. With this surface, neighbouring patches have the same
 * tangent plane along their common edge (G1).
 *
 * The curves of the edges are those of vtkPNTriangleSurface. Along an edge from P0 to P1, let W(t)
 * be the curve's derivative, a quadratic Bezier curve with points W0, W1, W2. Let A(t) be the
 * quadratic Bezier curve with points A0 = N0 x W0 / |N0 x W0|, A2 = N1 x W2 / |N1 x W2| and
 * A1 = (A0 + A2) / |A0 + A2|. The patch's derivative across the edge is l(t) W(t) + m(t) A(t),
 * where l and m are linear and match the curves of the other two edges at the ends. The tangent
 * plane therefore depends only on the edge. Each edge determines two inner points of a quartic
 * patch. The two inner points near a corner, from different edges, are blended with w1 / (w1 + w2)
 * and w2 / (w1 + w2), where w1 and w2 are the weights of the corners at the other ends of these
 * edges (Gregory's rational blending).
 *
 * Sources: D. Walton, D. Meek, "A triangular G1 patch from boundary curves", Computer-Aided Design
 * 28, 1996. C. Fuenfzig, K. Mueller, D. Hansford, G. Farin, "PNG1 triangles for tangent plane
 * continuous surfaces on the GPU", Graphics Interface 2008, applies the method to PN triangles. The
 * patch is evaluated as a cubic PN patch with a varying centre point, which is the same patch.
 *
 * The surface interpolates the coarse points, and the normals at points whose faces share one
 * normal. It reproduces planes. Along creases, the curves of both sides are averaged. The surface
 * remains closed there, each side keeps its tangent planes except at the ends of the crease, and
 * shading is sharp. If normals contradict a triangle, inner points are kept within half the length
 * of the longest edge from the centre point of the PN triangle, and tangent planes are then not
 * quite continuous.
 *
 * Geometric normals also show how the surface undulates between coarse points, which the
 * interpolated normals of PN triangles hide. On coarse scans, PN triangles look smoother.
 *
 * The point normals of the input are used. Missing normals are computed from the faces. Where the
 * patch is degenerate, interpolated normals replace geometric normals.
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
   * Set whether to use the normals of the surface itself, which are continuous across edges. The
   * default is off: the quadratic normals of vtkPNTriangleSurface are used, which look smoother.
   * Turn this on for measurements, offsets and reflections. The geometric normals show each flat
   * spot that the points and normals of a coarse mesh cause.
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
