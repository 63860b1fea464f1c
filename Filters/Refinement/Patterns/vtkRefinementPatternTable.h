// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementPatternTable
 * @brief   the subdivided triangles that refined surfaces are made of
 *
 * A pattern [i, j, k] subdivides a triangle (P1, P2, P3) so that its edges P1P2, P2P3 and P3P1 have
 * 2^i, 2^j and 2^k equal segments. Only the canonical patterns with i >= j >= k are stored. The
 * other orders are the same patterns with permuted barycentric coordinates (Lenz 2009, sections 4.2
 * to 4.4). With levels 0..L, the table has (L+1)(L+2)(L+3)/6 patterns. Patterns are generated on
 * first use and are the same on all machines. Use a table to look at patterns and to write them to
 * and read them from files. Recipes that use one table share its patterns
 * (vtkAdaptiveRefinement::SetPatternTable()).
 *
 * [d, d, d] is the regular subdivision into 4^d triangles. The other patterns are Delaunay
 * triangulations in an equilateral triangle that become coarser from the finer edges inwards. Their
 * number of triangles is between 0.8 times the geometric mean and 1.5 times the arithmetic mean of
 * 4^i, 4^j and 4^k. Their smallest angle is near the largest possible angle at a corner whose two
 * edges differ by d levels: 30, 20, 17.6, 13.9, 11.3, 9.3 and 8.2 degrees for d = 1 to 7.
 *
 * Internally, a pattern is identified by its numbers of segments per edge, any whole numbers up to
 * 128. Levels are one way to choose them.
 *
 * @sa vtkRefinementPatternSource vtkAdaptiveRefinement
 */
#ifndef vtkRefinementPatternTable_h
#define vtkRefinementPatternTable_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for MakeDefault()

#include <memory> // for pointers

class vtkPolyData;

namespace relevo
{
struct RefinementPattern;
class PatternLibrary;
}

class RELEVOFILTERSREFINEMENT_EXPORT vtkRefinementPatternTable : public vtkObject
{
public:
  static vtkRefinementPatternTable* New();
  vtkTypeMacro(vtkRefinementPatternTable, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The highest level of a table: 2^7 = 128 segments on an edge.
   */
  static constexpr int HighestLevel = 7;

  //@{
  /**
   * Set the highest level of an edge that the table returns and writes, 0 to 7. The default is 5. A
   * level that you set here or that was read from a file also limits the MaximumLevel of recipes.
   * Values out of range, or above the level of the file, are rejected with an error.
   */
  void SetMaximumLevel(int level);
  vtkGetMacro(MaximumLevel, int);
  //@}

  /**
   * Return the number of canonical patterns for MaximumLevel L: (L+1)(L+2)(L+3)/6.
   */
  int GetNumberOfPatterns();

  /**
   * Get the pattern of levels (i, j, k), in any order. Points are at (u, v, w) -> (v, w, 0), that
   * is P1 = (0,0), P2 = (1,0), P3 = (0,1). Triangles are counter-clockwise. The point array
   * "Barycentrics" has the barycentric coordinates. Returns false after reporting an error if a
   * level is out of [0, MaximumLevel].
   */
  bool GetPattern(int i, int j, int k, vtkPolyData* output);

  /**
   * Sort levels or segments in place into descending order by conditional swaps and return lambda
   * (Lenz 2009, figs. 4.8 to 4.11): swapping I and J adds 1, I and K adds 2, J and K adds 4.
   */
  static int Canonicalize(int ijk[3]);

  /**
   * Get the index of the canonical pattern's weight (0 = u, 1 = v, 2 = w) that each of P1, P2, P3
   * takes for lambda (Lenz 2009, tab. 4.2).
   */
  static void GetPermutation(int lambda, int permutation[3]);

  /**
   * Return whether the permutation of lambda mirrors the pattern, so that triangles must be
   * reversed to keep their winding.
   */
  static bool IsOdd(int lambda);

  /**
   * Return the memory of the patterns generated so far in bytes, including those for geomorphing.
   * For the default table of a recipe, this is the memory of all default tables.
   */
  vtkTypeInt64 GetMemorySize();

  //@{
  /**
   * Write all canonical patterns up to MaximumLevel to a file, or read a file and replace the
   * patterns and MaximumLevel. Returns false after reporting an error, and the table then does not
   * change. All patterns that are read are checked. Patterns from a file have 2^level segments on
   * an edge and cannot morph: GEOMORPHING_AUTOMATIC turns geomorphing off for them.
   *
   * A file name that ends in .vtp writes a vtkPolyData of all patterns side by side, as equilateral
   * triangles. The point array "Barycentrics" has (u, v, w), the int point and cell arrays
   * "Pattern" have the GetPatternIndex() of the pattern, and the int field array "MaximumLevel" has
   * the level.
   *
   * Any other name writes a binary, little-endian file. It starts with the eight bytes "RelevoRP",
   * the version of the format (1), MaximumLevel and the number of patterns. Then each pattern
   * follows in the order of indices: its three numbers of segments, the number of vertices V, the
   * number of triangles T, 3 V weights (float32) and 3 T vertex indices of triangles. All numbers
   * except the weights are uint32.
   */
  bool Write(const char* fileName);
  bool Read(const char* fileName);
  //@}

  /**
   * Return the index of the canonical levels i >= j >= k in the list of all patterns. The order is
   * [0,0,0], [1,0,0], [1,1,0], [1,1,1], [2,0,0], ..., and does not depend on MaximumLevel.
   */
  static int GetPatternIndex(int i, int j, int k);

#ifndef __VTK_WRAP__
  /**
   * Create a table of all levels. These tables share one cache of patterns, which exists as long as
   * one of the tables does.
   */
  static vtkSmartPointer<vtkRefinementPatternTable> MakeDefault();

  /**
   * Return the canonical pattern with segments 128 >= n1 >= n2 >= n3 >= 1 on its edges. It is
   * generated on first use, in at most 20 ms on an ordinary machine. Thread-safe. The pointer
   * remains valid when the table is deleted. Values out of range report an error and return the
   * undivided triangle.
   */
  std::shared_ptr<const relevo::RefinementPattern> GetPatternOfSegments(int n1, int n2, int n3);

  /**
   * Return the highest level of recipes that use this table: MaximumLevel if it was set or read
   * from a file, otherwise HighestLevel.
   */
  int GetHighestOfRecipes() const
  {
    return this->HighestOfRecipes;
  }

  /**
   * Return the patterns for surfaces. Read() replaces the library.
   */
  const std::shared_ptr<const relevo::PatternLibrary>& GetLibrary() const
  {
    return this->Library;
  }
#endif

protected:
  vtkRefinementPatternTable();
  ~vtkRefinementPatternTable() override;

  int MaximumLevel = 5;

private:
  vtkRefinementPatternTable(const vtkRefinementPatternTable&) = delete;
  void operator=(const vtkRefinementPatternTable&) = delete;

  int HighestOfRecipes = HighestLevel;
  std::shared_ptr<const relevo::PatternLibrary> Library;
};

#endif
