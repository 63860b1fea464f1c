// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedPolyDataBuilder
 * @brief   writes a refined mesh with all its data into a vtkPolyData
 *
 * The steps of vtkAdaptiveRefinementFilter once levels are selected: triangles, points and their
 * data, vertices and lines, cell data.
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
 * Calls `work` for ranges that make up all faces, perhaps in parallel; `share` of the whole task.
 * Returns false when it was stopped before the end.
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

  /// Fill an empty output; false when the loop was stopped, with the output left incomplete.
  bool Build(vtkPolyData* output);

  /// Names of arrays left out because they have too few tuples.
  const std::vector<std::string>& GetShortArrays() const { return this->ShortArrays; }

private:
  bool CountTriangles();
  bool BuildTriangles();
  void NumberUsedPoints();
  /// Build a point that is left out in place of the first of its copies that is not.
  void ReplaceUnusedOriginals();
  /// 0 for each of the input's points that a vertex or a line uses, else -1.
  std::vector<vtkIdType> MarkPointsOfOtherCells() const;
  /// Give vertices and lines points of their own where the displacement moves a face's.
  void SeparateOtherCells();
  bool BuildPoints(vtkPolyData* output);
  void BuildFacePoints(int face, std::vector<RefinedPoint>& points,
    const PointDataInterpolation& data, const SurfaceFields& fields);
  /// The points that this face is to evaluate, under their ids in the output.
  void GetPointsToBuild(int face, std::vector<RefinedPoint>& points) const;
  /// Points that differ from another one by their normals alone, once that one is built.
  void BuildCopies(vtkPointData* data);
  bool IsAtCorner(const int corners[3], const RefinedPoint& point, int nearest) const;
  void BuildOtherPoints(const PointDataInterpolation& data);
  void BuildCells(vtkPolyData* output);
  void BuildCellData(vtkPolyData* output);

  vtkIdType GetNumberOfTriangles() const { return this->FirstTriangles.back(); }
  vtkIdType GetNewId(vtkIdType point) const
  {
    return this->NewIds.empty() ? point : this->NewIds[static_cast<size_t>(point)];
  }
  /// Copy vertices or lines, whose ids begin with `firstCell`, but for ghosts.
  void CopyCells(vtkCellArray* from, vtkIdType firstCell, vtkCellArray* to);

  vtkPolyData* Input;
  const RefinementMesh& Mesh;
  vtkAdaptiveRefinement* Recipe;
  const FaceLoop& ForFaces;
  RefinedTopology Topology;
  RefinementEvaluator Evaluator;
  std::vector<NormalSplits::Value> Values; // evaluated by now
  std::unique_ptr<HoleFinder> Finder;      // null where there are no holes
  std::vector<std::string> ShortArrays;

  /// Per face its first triangle in the output, and one more for their number.
  std::vector<vtkIdType> FirstTriangles;
  /// Per face a byte per triangle, 1 where left out; empty where there are no holes.
  std::vector<std::vector<unsigned char>> Holes;
  /// Ids of points in the output, -1 where left out; empty when all keep theirs.
  std::vector<vtkIdType> NewIds;
  /// Ids in the output of the points of vertices and lines; empty when they share the faces'.
  std::vector<vtkIdType> IdsOfOtherCells;
  vtkIdType NumberOfPoints = 0;
  /// Ids in the input of the vertices and lines of the output.
  std::vector<vtkIdType> OtherCells;

  vtkNew<vtkIdTypeArray> Connectivity;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
};
}

#endif
