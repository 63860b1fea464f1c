// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatchDeviations
 * @brief   what a mesh's patches and curves need, whatever they are seen from: computed once a mesh
 *
 * Private to the module's own sources.
 */
#ifndef PatchDeviations_h
#define PatchDeviations_h

#include "Mathematics/RefinementMathematics.h"
#include "Metrics/PixelScale.h"
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

/// A triangle of a patch.
struct FaceDeviation
{
  /// See ComputeDeviationForm().
  dvec3 Form{ 0.0 };
  /// Of the triangle's own control points.
  PointBox Box;
  /// The mesh's edges opposite to the corners; an edge that is one place has that which leads
  /// there.
  std::array<int, 3> Edges{};
};

/// A curve between the points of a line cell.
struct CurveDeviation
{
  /// See ComputeChordDeviation().
  double Chord = 0.0;
  PointBox Box;
  /// Of the cell, among the mesh's lines.
  vtkIdType Line = 0;
};

class PatchDeviations
{
public:
  /// Of all triangles. False, with an error to show the user, where the mesh's patches are not
  /// valid.
  bool BuildFaces(MetricMesh& mesh, std::string& error);
  /// Of all lines, which are control polygons. False, with an error, where one has too many points.
  bool BuildCurves(vtkPolyData* mesh, std::string& error);

  const std::vector<FaceDeviation>& GetFaces() const { return this->Faces; }
  const std::vector<CurveDeviation>& GetCurves() const { return this->Curves; }

  /// Per edge of the mesh, that of its own curve.
  const std::vector<double>& GetChords() const { return this->Chords; }

  /// Calls f(face) for the index of each face at an edge.
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
  std::vector<int> Starts; // into Uses, per edge
  std::vector<int> Uses;   // faces
};
}

#endif
