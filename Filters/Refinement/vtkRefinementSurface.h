// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementSurface
 * @brief   the surface that the points of a refined triangle lie on
 *
 * A surface maps barycentric weights over a coarse triangle, given by its corners' points and
 * normals, to a position and a normal. It is written once, as GLSL that C++ compiles too
 * (glsl/), and evaluated by vtkAdaptiveRefinementFilter and vtkAdaptiveRefinementMapper alike.
 *
 * What does not depend on the weights is computed beforehand: vectors per edge, from the edge's two
 * ends alone, and vectors per face. Positions among the edge vectors are averaged over all faces
 * around an edge whose normals differ, so that a crease stays closed (as PN-AEN triangles do,
 * McDonald and Kilgard 2010) while its shading stays sharp.
 *
 * @sa vtkLinearSurface vtkPNTriangleSurface vtkAdaptiveRefinement
 */
#ifndef vtkRefinementSurface_h
#define vtkRefinementSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"

#include <string> // for shader text

class RELEVOFILTERSREFINEMENT_EXPORT vtkRefinementSurface : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkRefinementSurface, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether the surface's shape depends on point normals. They are computed where missing.
   */
  virtual bool NeedsNormals() { return false; }

  //@{
  /**
   * Number of precomputed 3-vectors: positions per edge, normals per edge, positions per face.
   */
  virtual int GetNumberOfEdgePositions() { return 0; }
  virtual int GetNumberOfEdgeNormals() { return 0; }
  virtual int GetNumberOfFacePositions() { return 0; }
  //@}

#ifndef __VTK_WRAP__
  /**
   * Fill the vectors of the edge from a to b: first the positions, then the normals.
   */
  virtual void ComputeEdgeVectors(const float aPoint[3], const float aNormal[3],
    const float bPoint[3], const float bNormal[3], float* vectors);

  /**
   * Fill the positions per face. `points` holds the three corners; `edgePositions` those of edges
   * (0,1), (1,2) and (0,2), each from its first corner to its second.
   */
  virtual void ComputeFacePositions(
    const float points[9], const float* edgePositions[3], float* positions);

  /**
   * One coarse triangle, corners sorted by place; see relevo::RefinementMesh.
   */
  struct Face
  {
    float Points[3][3];
    float Normals[3][3];
    /// The vectors of edges (0,1), (1,2), (0,2): positions, then normals; then the face's.
    const float* Vectors;
  };

  /**
   * Position and normal (not normalised) at the weights of the sorted corners.
   */
  virtual void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) = 0;

  /**
   * A cone that holds the geometric normals of the whole face, those of (P1 - P0) x (P2 - P0):
   * fills its unit axis and returns the cosine of the angle between axis and side. 0, the default,
   * when nothing is known or the cone is no narrower than a half-space.
   */
  virtual float ComputeNormalCone(const Face& face, float axis[3]);

  /**
   * The GLSL functions surfacePosition(vec3) and surfaceNormal(vec3), in terms of cornerPoint(i),
   * cornerNormal(i), edgeVector(edge, k) and faceVector(k).
   */
  virtual std::string GetShaderSource() = 0;
#endif

protected:
  vtkRefinementSurface();
  ~vtkRefinementSurface() override;

private:
  vtkRefinementSurface(const vtkRefinementSurface&) = delete;
  void operator=(const vtkRefinementSurface&) = delete;
};

#endif
