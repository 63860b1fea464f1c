// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedTriangles
 * @brief   the refined triangles of one coarse face at a time, for intersection with lines
 *
 * Points are relative to the mesh's origin.
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
  double Normal[3];     // interpolated; 0 if the mesh has none
  double FlatNormal[3]; // unit normal of the triangle
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
  /// `holes` is nullptr if there are none. `normals` are the input's point normals if the mesh does
  /// not have them, or nullptr.
  RefinedTriangles(const RefinementMesh& mesh, const RefinementEvaluator& evaluator,
    const HoleFinder* holes, const PatternSelection& selection, vtkDataArray* normals);

  /// Refine a face for the functions below.
  void Refine(int face);

  /// Find the first intersection of a line with a triangle before `t`. `t` becomes its parameter on
  /// the line.
  bool Intersect(const LineFrame& frame, double& t, TrianglePoint& point) const;

  /// Does the same for the first point of the line within `tolerance` of a triangle.
  bool Approach(const double start[3], const double end[3], double tolerance, double& t,
    TrianglePoint& point) const;

  /// Find the nearest point within the root of `distance2`. `distance2` becomes the square of its
  /// distance.
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
  std::vector<unsigned char> Out; // triangles over missing data
  const unsigned int* Triangles = nullptr;
  bool Turned = false; // whether the triangles are reversed relative to the cell
};
}

#endif
