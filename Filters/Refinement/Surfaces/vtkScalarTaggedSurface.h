// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScalarTaggedSurface
 * @brief   PN triangles shaped by numbers at the coarse points: creases, cusps, tension and bias
 *
 * After the ST-Mesh of T. Boubekeur, P. Reuter, C. Schlick, "Scalar Tagged PN Triangles",
 * Eurographics 2005 short presentations: each coarse point has a sharpness sigma, a tension theta,
 * a bias beta, and a vector Delta that goes with the sharpness. The meaning of these tags is the
 * paper's, the formulae are this class's own:
 *
 * An edge from Pi to Pj, e = Pj - Pi, leaves Pi as a cubic curve whose control point is Pi + T / 3.
 * With the unit normals Ni and Nj, h = e . Ni and t = e - h Ni, the edge's parts along and across
 * Ni,
 *
 *     T = (1 - theta) (e - (1 + beta) (h - s hx) Ni)
 *
 * - Tension in [-1, 1] scales the tangent as that of Kochanek and Bartels' splines (1984): 1 makes
 *   the surface tight at the point, -1 makes it twice as slack.
 * - Bias in [-1, 1] scales what bends the edge away from its chord: -1 leaves the chord, 0 the
 *   tangent plane, 1 overshoots it.
 * - Sharpness in [0, 1] takes the edge back towards its chord, s = sigma (1 - a). Without a
 *   direction a = 0, hx = h and x = t: at 1 the point becomes the tip of a cone, a cusp. With a
 *   direction, D is the unit vector of Delta's part across Ni, and x = t - (t . D) D is the part of
 *   t across Delta: a = max(0, 1 - 2 |x|^2 / |t|^2) tells how far the edge runs along Delta, 1 for
 *   one that does, 0 from 45 degrees on, and hx = h + (t . D) (Nj . D) / max(1 + Ni . Nj, 0.1) is
 *   its height without that of a circle's arc along Delta that turns as the normals do. So edges
 *   along Delta stay smooth while the others leave as on the two sides of a roof: a crease. A line
 *   of tagged points, each with the line's direction, makes a long one; on a single point it fades
 *   towards its neighbours.
 *
 * The centre of a patch follows from the edges as PN's does. Normals are quadratic as PN's, from a
 * normal per edge at each corner, which is perpendicular to T and, where sharp, to Delta:
 *
 *     Nij = normalize(Ni - (1 + beta) s hx x / |x|^2 + beta h t / |t|^2)
 *
 * Within a face a corner's normal passes from that of its one edge to that of its other by the
 * ratio of the other corners' weights. It comes from the edge alone, so that shading is continuous
 * across edges, except where they run along Delta: there each face takes, by the share a, the
 * normal of its other edge at that corner. vtkAdaptiveRefinementFilter gives faces with different
 * normals points of their own, at one place. Positions always come from the edge alone: refined
 * meshes are closed.
 *
 * Points without tags, or with zeros, give vtkPNTriangleSurface with quadratic normals to the last
 * bit. Tags beyond their range are clamped; the length and the sign of Delta do not count, nor does
 * its part along the normal; a Delta along the normal counts as none. Coincident points share the
 * mean of their tags. With a displacement along the normal, a mesh that has sharp or biased points
 * moves along its linear point normals, as one with split normals does.
 *
 * An array with another number of components, too few tuples or numbers that are not finite is an
 * error of the filter or the mapper that uses it.
 *
 * @sa vtkPNTriangleSurface vtkAdaptiveRefinement
 */
#ifndef vtkScalarTaggedSurface_h
#define vtkScalarTaggedSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkRefinementSurface.h"

#include <string> // for array names

class RELEVOFILTERSREFINEMENT_EXPORT vtkScalarTaggedSurface : public vtkRefinementSurface
{
public:
  static vtkScalarTaggedSurface* New();
  vtkTypeMacro(vtkScalarTaggedSurface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Names of the point arrays that hold the tags: "Sharpness", "Tension" and "Bias", of one
   * component, and "Direction", of three. A mesh need not have them; empty or None: not used.
   */
  void SetSharpnessArrayName(const char* name);
  const char* GetSharpnessArrayName();
  void SetTensionArrayName(const char* name);
  const char* GetTensionArrayName();
  void SetBiasArrayName(const char* name);
  const char* GetBiasArrayName();
  void SetDirectionArrayName(const char* name);
  const char* GetDirectionArrayName();
  //@}

  bool NeedsNormals() override { return true; }
  int GetNumberOfEdgePositions() override { return 2; }
  int GetNumberOfEdgeNormals() override { return 1; }
  int GetNumberOfFacePositions() override { return 1; }
  int GetNumberOfFaceNormals() override { return 6; }
  int GetNumberOfPointValues() override { return 6; }

#ifndef __VTK_WRAP__
  bool GetPointValues(vtkPolyData* mesh, float* values, std::string& error) override;
  void ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors) override;
  void ComputeFaceVectors(const Face& face, float* vectors, float* edgeNormals[3]) override;
  bool SplitsNormals(const Face& face) override;
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  float ComputeNormalCone(const Face& face, float axis[3]) override;
  std::string GetShaderSource() override;
#endif

protected:
  vtkScalarTaggedSurface();
  ~vtkScalarTaggedSurface() override;

  void SetName(std::string& name, const char* value);

  std::string SharpnessArrayName = "Sharpness";
  std::string TensionArrayName = "Tension";
  std::string BiasArrayName = "Bias";
  std::string DirectionArrayName = "Direction";

private:
  vtkScalarTaggedSurface(const vtkScalarTaggedSurface&) = delete;
  void operator=(const vtkScalarTaggedSurface&) = delete;
};

#endif
