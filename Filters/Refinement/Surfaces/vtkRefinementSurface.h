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
 * McDonald and Kilgard 2010) while its shading stays sharp. A surface may also take numbers per
 * point from arrays of the mesh; coincident points share the mean of theirs.
 *
 * Settings that are uniforms of the shader change live: they alter GetMTime() but not
 * GetPreparationMTime().
 *
 * @sa vtkLinearSurface vtkPNTriangleSurface vtkPhongSurface vtkScalarTaggedSurface vtkG1Surface
 * vtkProceduralSurface vtkAdaptiveRefinement
 */
#ifndef vtkRefinementSurface_h
#define vtkRefinementSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"

#include <string> // for shader text
#include <vector> // for uniforms

class vtkDataArray;
class vtkPolyData;

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
   * Number of precomputed 3-vectors: positions and normals per edge, positions and normals per
   * face.
   */
  virtual int GetNumberOfEdgePositions() { return 0; }
  virtual int GetNumberOfEdgeNormals() { return 0; }
  virtual int GetNumberOfFacePositions() { return 0; }
  virtual int GetNumberOfFaceNormals() { return 0; }
  //@}

  /**
   * How many numbers per point the surface takes from the mesh.
   */
  virtual int GetNumberOfPointValues() { return 0; }

  /**
   * How many of these, from the first on, its shader uses: 0 to 4.
   */
  virtual int GetNumberOfShaderValues() { return 0; }

  /**
   * Whether the surface has tables: shapes that the mesh itself brings along, of which corners tell
   * nothing. See BuildTables().
   */
  virtual bool HasTables() { return false; }

  /**
   * Whether displacement goes along directions of the surface's own, EvaluateDirection(), rather
   * than along its normals or, where these are split, those of the corners.
   */
  virtual bool HasDirections() { return false; }

  /**
   * How far, in length units, points can lie from the convex hull of a face's corners, precomputed
   * positions and the box of ExtendBox().
   */
  virtual double GetReach() { return 0.0; }

  /**
   * Whether the surface goes through the coarse points.
   */
  virtual bool InterpolatesCorners() { return true; }

  /**
   * Whether normals are sums, with weights that are not negative, of the corners' normals and the
   * precomputed ones.
   */
  virtual bool HasInterpolatedNormals() { return true; }

  /**
   * Latest change of what precomputed vectors, numbers per point or the shader's text depend on.
   */
  virtual vtkMTimeType GetPreparationMTime() { return this->GetMTime(); }

#ifndef __VTK_WRAP__
  /**
   * Fill GetNumberOfPointValues() numbers for each point of the mesh. False, with an error to show
   * the user, when the mesh lacks what is needed.
   */
  virtual bool GetPointValues(vtkPolyData* mesh, float* values, std::string& error);

  /**
   * Numbers of a mesh, for all its faces to look up.
   */
  struct Tables
  {
    /// Four per point: a position, and a number that belongs to it.
    std::vector<float> Points;
    /// Four per record.
    std::vector<int> Records;
    /// For each cell of the mesh, all of them triangles, the record that its face starts from.
    std::vector<int> Entries;
  };

  /**
   * Fill the tables, with positions relative to `origin`. False, with an error to show the user,
   * when the mesh lacks what is needed.
   */
  virtual bool BuildTables(
    vtkPolyData* mesh, const double origin[3], Tables& tables, std::string& error);

  /**
   * An end of an edge. Values are those per point; nullptr when there are none.
   */
  struct Corner
  {
    const float* Point;
    const float* Normal;
    const float* Values;
  };

  /**
   * Fill the vectors of the edge from a to b: first the positions, then the normals.
   */
  virtual void ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors);

  /**
   * One coarse triangle, corners sorted by place; see relevo::RefinementMesh.
   */
  struct Face
  {
    float Points[3][3];
    float Normals[3][3];
    /// What to add to points for the mesh's own coordinates.
    const double* Origin;
    /// Unit normals that all faces around a corner share: its own where normals are not split.
    const float* Directions[3];
    /// The numbers per point of each corner.
    const float* Values[3];
    /// The vectors of edges (0,1), (1,2), (0,2), each from its first corner to its second:
    /// positions, then normals. Then the face's positions, then its normals.
    const float* Vectors;
    /// The mesh's tables, the face's first record, and the code of the permutation from the cell's
    /// own corners to these (relevoWeights.glsl).
    const Tables* MeshTables;
    int TableEntry;
    int CornerOrder;
  };

  /**
   * Fill the vectors per face: first the positions, then the normals. The face's edges are
   * complete; `edgeNormals` lets their normals be replaced by others for this face alone.
   */
  virtual void ComputeFaceVectors(const Face& face, float* vectors, float* edgeNormals[3]);

  /**
   * Whether this face may see other normals at its corners or edges than the faces beside it,
   * though they share points.
   */
  virtual bool SplitsNormals(const Face& face);

  /**
   * Position and normal (not normalised) at the weights of the sorted corners.
   */
  virtual void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) = 0;

  /**
   * The direction, not normalised, that displacement goes along: on edges and at corners the same
   * from all faces around.
   */
  virtual void EvaluateDirection(const Face& face, const float weights[3], float direction[3]);

  /**
   * The coefficients by which the surface knows a point array between the corners; nullptr, the
   * default, where it is interpolated linearly.
   */
  virtual vtkDataArray* FindCoefficients(vtkPolyData* mesh, vtkDataArray* pointArray);

  /**
   * The tuple that such an array has at weights.
   */
  virtual void EvaluateField(
    const Face& face, const float weights[3], vtkDataArray* coefficients, double* tuple);

  /**
   * Extend a box, relative to the origin, by all that the face may reach beyond its corners and
   * precomputed positions.
   */
  virtual void ExtendBox(const Face& face, double low[3], double high[3]);

  /**
   * Why Evaluate() cannot do what the shader does; empty if it can.
   */
  virtual std::string GetEvaluationError()
  {
    return std::string();
  }

  /**
   * A cone that holds the geometric normals of the whole face, those of (P1 - P0) x (P2 - P0):
   * fills its unit axis and returns the cosine of the angle between axis and side. 0, the default,
   * when nothing is known or the cone is no narrower than a half-space.
   */
  virtual float ComputeNormalCone(const Face& face, float axis[3]);

  /**
   * The GLSL functions surfacePosition(vec3) and surfaceNormal(vec3), in terms of cornerPoint(i),
   * cornerNormal(i), cornerDirection(i), cornerValues(i), edgeVector(edge, k) and faceVector(k),
   * and with HasTables() of tableEntry(), cornerOrder(), vec4 tablePoint(i) and ivec4
   * tableRecord(i); with HasDirections() surfaceDirection(vec3) too.
   * Positions are those of VTK's vertex buffer: surfaceScale() is the factor from the mesh's
   * lengths to theirs, and modelPosition(p) a position in the mesh's own coordinates.
   */
  virtual std::string GetShaderSource() = 0;

  /**
   * A uniform of the shader, of 1 to 4 floats.
   */
  struct Uniform
  {
    std::string Name;
    std::vector<float> Values;
  };

  /**
   * The uniforms that GetShaderSource() declares, set with every frame.
   */
  virtual std::vector<Uniform> GetUniforms()
  {
    return {};
  }
#endif

protected:
  vtkRefinementSurface();
  ~vtkRefinementSurface() override;

private:
  vtkRefinementSurface(const vtkRefinementSurface&) = delete;
  void operator=(const vtkRefinementSurface&) = delete;
};

#endif
