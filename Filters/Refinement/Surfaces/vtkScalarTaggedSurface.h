// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScalarTaggedSurface
 * @brief   PN triangles shaped by values at the coarse points: creases, cusps, tension and bias
 *
 * This surface follows the ST-Mesh of T. Boubekeur, P. Reuter, C. Schlick, "Scalar Tagged PN
 * Triangles", Eurographics 2005 short presentations. Each coarse point has a sharpness sigma, a
 * tension theta, a bias beta, and a direction Delta for the sharpness. The tags have the same
 * meaning as in the paper, but the formulas differ:
 *
 * An edge e = Pj - Pi from Pi to Pj is a cubic curve whose control point near Pi is Pi + T / 3.
 * With the unit normals Ni and Nj, h = e . Ni is the part of the edge along Ni, and t = e - h Ni is
 * the part perpendicular to it:
 *
 *     T = (1 - theta) (e - (1 + beta) (h - s hx) Ni)
 *
 * - Tension in [-1, 1] scales the tangent as in the splines of Kochanek and Bartels (1984): 1 makes
 *   the surface tight at the point, -1 makes it twice as slack.
 * - Bias in [-1, 1] scales the deviation of the edge from its chord: -1 gives the chord, 0 the
 *   tangent plane, and 1 overshoots the tangent plane.
 * - Sharpness in [0, 1] moves the edge back towards its chord, with s = sigma (1 - a). Without a
 *   direction, a = 0, hx = h and x = t, and a sharpness of 1 makes the point the tip of a cone (a
 *   cusp). With a direction, D is the unit vector of Delta's part perpendicular to Ni, and
 *   x = t - (t . D) D is the part of t perpendicular to D. The share
 *   a = max(0, 1 - 2 |x|^2 / |t|^2) measures how far the edge runs along Delta: 1 for an edge along
 *   Delta, 0 for an angle of 45 degrees or more. hx = h + (t . D) (Nj . D) / max(1 + Ni . Nj, 0.1)
 *   is the edge's height minus the height of a circular arc along Delta that turns as the normals
 *   do. Edges along Delta therefore stay smooth, while the others meet at an angle, as on the two
 *   sides of a roof: a crease. To make a long crease, tag a line of points with the direction of
 *   the line. The crease of a single point fades towards its neighbours.
 *
 * The centre of a patch is computed from the edges as in PN triangles. Normals are quadratic as in
 * PN triangles, from one normal per edge at each corner. This normal is perpendicular to T and,
 * where sharp, to Delta:
 *
 *     Nij = normalize(Ni - (1 + beta) s hx x / |x|^2 + beta h t / |t|^2)
 *
 * Within a face, the normal at a corner changes from that of one edge to that of the other, by the
 * ratio of the other corners' weights. The normals depend only on the edge, so that shading is
 * continuous across edges, except across edges along Delta. There, each face uses the normal of its
 * other edge at that corner, weighted by a. vtkAdaptiveRefinementFilter splits the points where the
 * normals of faces differ. Positions depend only on the edge, so that refined meshes are closed.
 *
 * Points without tags or with zeros give exactly the same result as vtkPNTriangleSurface with
 * quadratic normals. Tags are clamped to their range. The length, the sign and the part of Delta
 * along the normal have no effect. A Delta along the normal is ignored. Coincident points use the
 * mean of their tags. If a mesh has sharp or biased points, a displacement along the normal uses
 * linearly interpolated point normals, as on a mesh with split normals.
 *
 * An array with the wrong number of components, too few tuples or non-finite numbers is an error of
 * the filter or mapper that uses the surface.
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
   * Set the names of the point arrays of tags. The defaults are "Sharpness", "Tension" and "Bias",
   * with one component, and "Direction", with three. Arrays that the mesh does not have are
   * ignored. Use an empty string or None to ignore an array of the mesh.
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
