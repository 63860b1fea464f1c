// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedTriangles
 * @brief   the refined triangles of one coarse face at a time, to be met by lines
 *
 * Places are relative to the mesh's origin. Private to the module's own sources.
 */
#ifndef RefinedTriangles_h
#define RefinedTriangles_h

#include <vector> // for members

class vtkDataArray;

namespace relevo
{
class HoleFinder;
class PatternSelection;
class RefinementEvaluator;
class RefinementMesh;

/// A point of a refined triangle.
struct TrianglePoint
{
  double Position[3];
  double Normal[3];     // interpolated; zero where the mesh has none
  double FlatNormal[3]; // the triangle's own, unit
  double Weights[3];    // of the coarse face's sorted corners
};

/// Coordinates in which a line runs along the third axis, by a shear (Woop et al. 2013).
struct LineFrame
{
  LineFrame(const double start[3], const double end[3]);
  void Transform(const float* point, double out[3]) const;

  double Start[3];
  int Axes[3];
  double Shear[3];
};

class RefinedTriangles
{
public:
  /// `holes` are nullptr where there are none. `normals` are the input's, of points, where the mesh
  /// has kept none; or nullptr.
  RefinedTriangles(const RefinementMesh& mesh, const RefinementEvaluator& evaluator,
    const HoleFinder* holes, const PatternSelection& selection, vtkDataArray* normals);

  /// Take a face.
  void Refine(int face);

  /// The first point where a line meets a triangle, if that is before `t`, which becomes its place
  /// on the line.
  bool Intersect(const LineFrame& frame, double& t, TrianglePoint& point) const;

  /// The same for the first place where the line passes a triangle within `tolerance`.
  bool Approach(const double start[3], const double end[3], double tolerance, double& t,
    TrianglePoint& point) const;

  /// The point nearest to a place, if nearer than the root of `distance2`, which becomes the
  /// square of its distance.
  bool FindClosest(const double place[3], double& distance2, TrianglePoint& point) const;

private:
  void InterpolateNormals(int face);
  template <typename Visitor>
  void ForEachTriangle(const Visitor& visit) const;
  void Interpolate(
    const unsigned int vertices[3], const double shares[3], TrianglePoint& point) const;

  const RefinementMesh& Mesh;
  const RefinementEvaluator& Evaluator;
  const HoleFinder* Holes;
  const PatternSelection& Selection;
  vtkDataArray* InputNormals;
  std::vector<float> Points;
  std::vector<float> Normals;
  std::vector<float> Weights;
  std::vector<unsigned char> Out; // triangles over no-data
  const unsigned int* Triangles = nullptr;
  bool Turned = false; // the triangles against the cell's sense
};
}

#endif
