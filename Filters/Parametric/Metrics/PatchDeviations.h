// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatchDeviations
 * @brief   view-independent data for the screen-space error of patches and curves
 *
 * Computed once per mesh. Private to the module.
 */
#ifndef PatchDeviations_h
#define PatchDeviations_h

#include "Mathematics/RefinementMathematics.h"
#include "View/PixelScale.h"
#include "vtkType.h"

#include <array>  // for edges
#include <string> // for errors
#include <vector> // for members

class vtkPolyData;

namespace relevo
{
class MetricMesh;
class PatchArrays;
class SurfaceEdges;
class SurfaceTriangles;

/// Data of a triangle of a patch.
struct FaceDeviation
{
  /// See ComputeDeviationForm().
  dvec3 Form{ 0.0 };
  /// The box of the control points of the triangle.
  PointBox Box;
  /// The edges of the mesh opposite to the corners. For a degenerate edge, this is the edge that
  /// leads to the point.
  std::array<int, 3> Edges{};
};

/// Data of a curve, which is a line cell of control points.
struct CurveDeviation
{
  /// See ComputeChordDeviation().
  double Chord = 0.0;
  PointBox Box;
  /// Index of the cell among the lines of the mesh.
  vtkIdType Line = 0;
};

class PatchDeviations
{
public:
  /// Computes the data of all triangles. Returns false with an `error` if the patches of the mesh
  /// are invalid.
  bool BuildFaces(MetricMesh& mesh, std::string& error);
  /// Computes the data of all lines, which are control polygons. Returns false with an `error` if a
  /// line has too many points.
  bool BuildCurves(vtkPolyData* mesh, std::string& error);

  const std::vector<FaceDeviation>& GetFaces() const { return this->Faces; }
  const std::vector<CurveDeviation>& GetCurves() const { return this->Curves; }

  /// One per edge of the mesh, for the curve of the edge.
  const std::vector<double>& GetChords() const { return this->Chords; }

  /// Calls f(face) with the index of each face at an edge.
  template <typename Function>
  void ForEachFace(int edge, Function&& f) const
  {
    for (int i = this->Starts[edge]; i < this->Starts[edge + 1]; ++i)
    {
      f(this->Uses[i]);
    }
  }

private:
  void FindFaces(MetricMesh& mesh, std::vector<vtkIdType>& cells);
  void BuildUses(int numberOfEdges);

  std::vector<FaceDeviation> Faces;
  std::vector<CurveDeviation> Curves;
  std::vector<double> Chords;
  std::vector<int> Starts; // index into Uses for each edge
  std::vector<int> Uses;   // faces
};
}

#endif
