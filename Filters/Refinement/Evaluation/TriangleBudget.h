// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TriangleBudget
 * @brief   how much to add to the tags of all edges so that a wanted number of triangles comes out
 *
 * The number of triangles rises with what is added, the offset, in steps: at the offset that lifts
 * an edge to its next number of segments, its faces take larger patterns. One pass over the faces
 * finds where in an interval of offsets the steps are, and how high, as a histogram; the sums of
 * its bins are the number of triangles by offset. The first interval lies around a guess, the next
 * ones beside it.
 *
 * The offset is a function of the tags alone; the guess saves time and changes nothing. So nothing
 * can oscillate, and along a smooth flight the offset is as smooth as the tags.
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

  /// A mesh with tags that were computed for it. Several share a budget and an offset.
  struct Part
  {
    const RefinementMesh* Mesh;
    const EdgeTags* Tags;
    std::shared_ptr<const PatternFamily> Family;
    /// A byte per face, not 0 for those that do not count; nullptr where all count.
    const unsigned char* Hidden = nullptr;
  };

  /// Offsets are found to this part of a level.
  static constexpr int Resolution = 1024;

  /// How many triangles more than wanted may be taken, as a share, where that comes nearer.
  static constexpr double Tolerance = 0.05;

  /**
   * The offset in [lowest, highest], in levels, at which, with edges of levels up to the maximum,
   * PatternSelection::Select() selects most nearly `target` triangles for all parts together: no
   * more, or within the tolerance. Where so many faces change at one offset that this cannot be
   * had, the offset just before, with fewer. Where the target is out of reach, the offset that just
   * gives all or the least there are. Hidden faces do not count, faces over no-data do. Where other
   * processes have `pieces`, theirs are counted too. Collective.
   */
  double FindOffset(const std::vector<Part>& parts, int maximumLevel, vtkIdType target,
    double lowest, double highest, double guess = 0.0,
    const PieceReduction& pieces = PieceReduction());

  /// Triangles of all parts at an offset, less those of hidden faces, with all patterns that it
  /// takes.
  static vtkIdType CountTriangles(const std::vector<Part>& parts, int maximumLevel, double offset);

private:
  using Bins = std::vector<std::int64_t>;
  struct Interval
  {
    int First; // number of an offset
    int Width;
    Bins Totals; // of triangles, by offset
  };
  static double GetOffset(int number);
  static int GetNumber(double offset);

  void UpdateCounts(const std::vector<Part>& parts, int maximumLevel);
  const TriangleCounts& GetCounts(const Part& part) const;
  void Count(const std::vector<Part>& parts, Interval& interval) const;
  int FindNumber(const std::vector<Part>& parts, double target, int lowest, int highest, int guess,
    const PieceReduction& pieces);

  std::map<vtkMTimeType, std::unique_ptr<TriangleCounts>> Counts; // of families, by their times
  int MaximumLevel = 0;
};
}

#endif
