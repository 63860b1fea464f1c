// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedPolyDataBuilder
 * @brief   writes a refined mesh and its data to a vtkPolyData
 *
 * It performs the steps of vtkAdaptiveRefinementFilter after the levels are selected: triangles,
 * points and their data, vertices and lines, cell data.
 */
#ifndef RefinedPolyDataBuilder_h
#define RefinedPolyDataBuilder_h

#include "Evaluation/HoleFinder.h"
#include "Evaluation/NormalSplits.h"

#include "Evaluation/RefinedTopology.h"
#include "Evaluation/RefinementEvaluator.h"
#include "vtkNew.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkAdaptiveRefinement;
class vtkCellData;
class vtkCellArray;
class vtkFloatArray;
class vtkIdTypeArray;
class vtkPointData;
class vtkPoints;
class vtkPolyData;

namespace relevo
{
class PatternSelection;
class PointDataInterpolation;
class SurfaceFields;

/**
 * Calls `work` for ranges that cover all faces, possibly in parallel. `share` is the fraction of
 * the whole task. Returns false if it was stopped.
 */
using FaceLoop =
  std::function<bool(double share, const std::function<void(vtkIdType, vtkIdType)>& work)>;

class RefinedPolyDataBuilder
{
public:
  /// All arguments must outlive the builder.
  RefinedPolyDataBuilder(vtkPolyData* input, RefinementMesh& mesh,
    const PatternSelection& selection, vtkAdaptiveRefinement* recipe, const FaceLoop& forFaces);
  ~RefinedPolyDataBuilder();

  /// Fill an empty output. Returns false if the loop was stopped; the output is then incomplete.
  bool Build(vtkPolyData* output);

  /// Names of the arrays that are skipped because they have too few tuples.
  const std::vector<std::string>& GetShortArrays() const { return this->ShortArrays; }

private:
  bool CountTriangles();
  bool BuildTriangles();
  void NumberUsedPoints();
  /// If a point is unused, build it in place of its first copy that is used.
  void ReplaceUnusedOriginals();
  /// Returns 0 for each input point that a vertex or line uses, and -1 for the others.
  std::vector<vtkIdType> MarkPointsOfOtherCells() const;
  /// Give vertices and lines separate points where the displacement moves a face's points.
  void SeparateOtherCells();
  bool BuildPoints(vtkPolyData* output);
  void BuildFacePoints(int face, std::vector<RefinedPoint>& points,
    const PointDataInterpolation& data, const SurfaceFields& fields);
  /// Get the points that this face evaluates, with their ids in the output.
  void GetPointsToBuild(int face, std::vector<RefinedPoint>& points) const;
  /// Copy points that differ from another point only in their normal, after that point is built.
  void BuildCopies(vtkPointData* data);
  bool IsAtCorner(const int corners[3], const RefinedPoint& point, int nearest) const;
  void BuildOtherPoints(const PointDataInterpolation& data);
  void BuildCells(vtkPolyData* output);
  void BuildCellData(vtkPolyData* output);
  /// Set the cell arrays that differ on faces, at the centres of triangles.
  void RefineCellData(vtkCellData* data);

  vtkIdType GetNumberOfTriangles() const { return this->FirstTriangles.back(); }
  vtkIdType GetNewId(vtkIdType point) const
  {
    return this->NewIds.empty() ? point : this->NewIds[static_cast<size_t>(point)];
  }
  /// Copy vertices or lines, whose ids start with `firstCell`, without ghost cells.
  void CopyCells(vtkCellArray* from, vtkIdType firstCell, vtkCellArray* to);

  vtkPolyData* Input;
  const RefinementMesh& Mesh;
  vtkAdaptiveRefinement* Recipe;
  const FaceLoop& ForFaces;
  RefinedTopology Topology;
  RefinementEvaluator Evaluator;
  std::vector<NormalSplits::Value> Values; // evaluated so far
  std::unique_ptr<HoleFinder> Finder;      // nullptr if there are no holes
  std::vector<std::string> ShortArrays;

  /// Index of the first output triangle per face, and the number of triangles at the end.
  std::vector<vtkIdType> FirstTriangles;
  /// One byte per triangle of each face, 1 for removed triangles; empty if there are no holes.
  std::vector<std::vector<unsigned char>> Holes;
  /// Output ids of points, -1 for removed points; empty if all ids are unchanged.
  std::vector<vtkIdType> NewIds;
  /// Output ids of the points of vertices and lines; empty if they share the faces' points.
  std::vector<vtkIdType> IdsOfOtherCells;
  vtkIdType NumberOfPoints = 0;
  /// Input ids of the vertices and lines of the output.
  std::vector<vtkIdType> OtherCells;

  vtkNew<vtkIdTypeArray> Connectivity;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
};
}

#endif
