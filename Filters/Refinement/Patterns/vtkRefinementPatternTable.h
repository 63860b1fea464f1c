// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementPatternTable
 * @brief   the subdivided triangles that every refined surface is drawn from
 *
 * A pattern [i, j, k] subdivides a triangle (P1, P2, P3) so that its edges P1P2, P2P3 and P3P1
 * carry 2^i, 2^j and 2^k equal segments. Only the canonical patterns, i >= j >= k, are kept; the
 * other orders are the same pattern read with permuted barycentrics (Lenz 2009, sections 4.2
 * to 4.4). With levels 0..L the table has (L+1)(L+2)(L+3)/6 patterns. Patterns are made on first
 * use, and are the same on every machine. A table shows them, and writes and reads files of them;
 * recipes that are given one table share its patterns (vtkAdaptiveRefinement::SetPatternTable()).
 *
 * [d, d, d] is the regular subdivision into 4^d triangles. The others are Delaunay triangulations
 * in the equilateral triangle that grow coarser from the finer edges inwards; they take between
 * 0.8 times the geometric and 1.5 times the arithmetic mean of 4^i, 4^j and 4^k triangles. Their
 * smallest angle is near the largest that is possible at a corner whose two edges differ by d
 * levels: 30, 20, 17.6, 13.9, 11.3, 9.3 and 8.2 degrees for d = 1 to 7.
 *
 * Internally a pattern is known by its segments per edge, any whole numbers up to 128, so that
 * levels are one policy among others.
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
   * The highest level a table can hold: 2^7 = 128 segments on an edge.
   */
  static constexpr int HighestLevel = 7;

  //@{
  /**
   * The highest level of an edge, 0 to 7, default 5, that the table gives and writes. How deep a
   * recipe refines is its own MaximumLevel; but no deeper than this one, once it was set or read
   * from a file. A value outside, or above the levels of the file, is an error and changes nothing.
   */
  void SetMaximumLevel(int level);
  vtkGetMacro(MaximumLevel, int);
  //@}

  /**
   * Number of canonical patterns for the current MaximumLevel L: (L+1)(L+2)(L+3)/6.
   */
  int GetNumberOfPatterns();

  /**
   * The pattern of levels (i, j, k), in any order, as points (u, v, w) -> (v, w, 0), that is with
   * P1 = (0,0), P2 = (1,0), P3 = (0,1), and counter-clockwise triangles. The point data hold the
   * barycentrics in the array "Barycentrics". Returns false, after an ErrorEvent, when a level is
   * out of [0, MaximumLevel].
   */
  bool GetPattern(int i, int j, int k, vtkPolyData* output);

  /**
   * Sort levels (or segments) in place into descending order by conditional swaps and return
   * lambda (Lenz 2009, figs. 4.8 to 4.11): swap IJ adds 1, swap IK adds 2, swap JK adds 4.
   */
  static int Canonicalize(int ijk[3]);

  /**
   * For each of P1, P2, P3, which of the canonical pattern's weights (0 = u, 1 = v, 2 = w) it
   * takes under lambda (Lenz 2009, tab. 4.2).
   */
  static void GetPermutation(int lambda, int permutation[3]);

  /**
   * Whether the permutation of lambda mirrors the pattern, so that its triangles must be turned to
   * keep their winding.
   */
  static bool IsOdd(int lambda);

  /**
   * Bytes held by the patterns made so far, those that morph included; of the table that a recipe
   * brings, by those of all such tables.
   */
  vtkTypeInt64 GetMemorySize();

  //@{
  /**
   * Write every canonical pattern up to MaximumLevel to a file, or replace the patterns by those
   * of such a file, which also sets MaximumLevel. Returns false, after an ErrorEvent that says what
   * is wrong, on failure; the table is then as it was. Every pattern that is read is checked.
   * All surfaces are refined with the patterns of a file; they cannot morph, so that recipes with
   * GEOMORPHING_AUTOMATIC do without, and they have 2^level segments on an edge.
   *
   * A file name that ends in .vtp means a vtkPolyData of all patterns side by side, as equilateral
   * triangles: the point array "Barycentrics" holds (u, v, w), the int point and cell arrays
   * "Pattern" the pattern's GetPatternIndex(), the int field array "MaximumLevel" the level.
   *
   * Any other name means a binary, little-endian file: the eight bytes "RelevoRP"; the format's
   * version (1), MaximumLevel and the number of patterns; then for each pattern, by index, its
   * three numbers of segments, V vertices and T triangles, followed by 3 V weights (float32) and
   * 3 T vertices of triangles. All but the weights are uint32.
   */
  bool Write(const char* fileName);
  bool Read(const char* fileName);
  //@}

  /**
   * Position of the canonical levels i >= j >= k in a list of all patterns: the order [0,0,0],
   * [1,0,0], [1,1,0], [1,1,1], [2,0,0], ..., which does not depend on MaximumLevel.
   */
  static int GetPatternIndex(int i, int j, int k);

#ifndef __VTK_WRAP__
  /**
   * A table of all levels. Patterns that such tables make are made once and kept once for all of
   * them, as long as there is one.
   */
  static vtkSmartPointer<vtkRefinementPatternTable> MakeDefault();

  /**
   * The canonical pattern with segments 128 >= n1 >= n2 >= n3 >= 1 on its edges. Made on first use,
   * in 20 ms at most on an ordinary machine; safe to call from several threads. Who has the pointer
   * has the pattern, whatever becomes of the table. Other numbers are an error and give the
   * undivided triangle.
   */
  std::shared_ptr<const relevo::RefinementPattern> GetPatternOfSegments(int n1, int n2, int n3);

  /**
   * The highest level that recipes with this table refine to: MaximumLevel where it was set or read
   * from a file, else HighestLevel.
   */
  int GetHighestOfRecipes() const
  {
    return this->HighestOfRecipes;
  }

  /**
   * The patterns for surfaces: another library after each Read().
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
