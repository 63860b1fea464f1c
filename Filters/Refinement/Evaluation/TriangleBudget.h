// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleBudget
 * @brief   finds the offset of all tags that gives a target number of triangles
 *
 * The number of triangles increases with the offset in steps: at the offset where an edge gets its
 * next number of segments, its faces get larger patterns. One pass over the faces computes a
 * histogram of these steps in an interval of offsets. The cumulative sums of its bins are the
 * number of triangles by offset. The first interval contains a guess, and the next intervals are
 * adjacent.
 *
 * The offset depends only on the tags. The guess saves time and does not change the result.
 * Therefore nothing oscillates, and during a smooth flight the offset is as smooth as the tags.
 */
#ifndef TriangleBudget_h
#define TriangleBudget_h

#include "Parallel/PieceReduction.h"       // for the default
#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkIdType

#include <cstddef> // for size_t
#include <cstdint> // for int64_t
#include <map>     // for members
#include <memory>  // for members
#include <utility> // for std::pair
#include <vector>  // for members

namespace relevo
{
class EdgeTags;
class PatternFamily;
class RefinementMesh;
class TriangleCounts;

class RELEVOFILTERSREFINEMENT_EXPORT TriangleBudget
{
public:
  TriangleBudget();
  ~TriangleBudget();
  TriangleBudget(const TriangleBudget&) = delete;
  void operator=(const TriangleBudget&) = delete;

  /// A mesh with its tags. Several parts share a budget and an offset.
  struct Part
  {
    const RefinementMesh* Mesh;
    const EdgeTags* Tags;
    std::shared_ptr<const PatternFamily> Family;
    /// One byte per face, not 0 for faces that are not counted; nullptr if all are counted.
    const unsigned char* Hidden = nullptr;
  };

  /// Offsets are found with a precision of 1 / Resolution levels.
  static constexpr int Resolution = 1024;

  /// The fraction by which the result may exceed the target, if that is nearer.
  static constexpr double Tolerance = 0.05;

  /**
   * Return the offset in [lowest, highest], in levels, at which PatternSelection::Select(), with
   * levels of edges up to the maximum, selects the number of triangles nearest to `target` for all
   * parts together. The number does not exceed the target by more than the tolerance. If too many
   * faces change at one offset, the result is the offset just before, with fewer triangles. If the
   * target is out of reach, the result is the offset that just gives the highest or lowest number.
   * Hidden faces are not counted, faces over missing data are. `pieces` of other processes are
   * counted too. Collective.
   */
  double FindOffset(const std::vector<Part>& parts, int maximumLevel, vtkIdType target,
    double lowest, double highest, double guess = 0.0,
    const PieceReduction& pieces = PieceReduction());

  /// Return the number of triangles of all parts at an offset, without hidden faces. This generates
  /// all patterns in use.
  static vtkIdType CountTriangles(const std::vector<Part>& parts, int maximumLevel, double offset);

private:
  using Bins = std::vector<std::int64_t>;
  struct Interval
  {
    int First; // number of the first offset
    int Width;
    Bins Totals; // triangles by offset
  };
  static double GetOffset(int number);
  static int GetNumber(double offset);

  void UpdateCounts(const std::vector<Part>& parts, int maximumLevel);
  const TriangleCounts& GetCounts(const Part& part) const;
  void Count(const std::vector<Part>& parts, Interval& interval) const;
  int FindNumber(const std::vector<Part>& parts, double target, int lowest, int highest, int guess,
    const PieceReduction& pieces);

  std::map<vtkMTimeType, std::unique_ptr<TriangleCounts>> Counts; // per family, by its time
  int MaximumLevel = 0;
};
}

#endif
