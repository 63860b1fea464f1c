// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementPatternSource
 * @brief   one refinement pattern as polygonal data, to look at
 *
 * The output is what vtkRefinementPatternTable::GetPattern() gives for Levels: points
 * (u, v, w) -> (v, w, 0), counter-clockwise triangles, and the barycentrics in the point array
 * "Barycentrics" (three float components).
 *
 * @sa vtkRefinementPatternTable
 */
#ifndef vtkRefinementPatternSource_h
#define vtkRefinementPatternSource_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the table

class vtkRefinementPatternTable;

class RELEVOFILTERSREFINEMENT_EXPORT vtkRefinementPatternSource : public vtkPolyDataAlgorithm
{
public:
  static vtkRefinementPatternSource* New();
  vtkTypeMacro(vtkRefinementPatternSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Levels of the edges P1P2, P2P3 and P3P1, in any order, each 0 to 7; default (0, 0, 0), the
   * undivided triangle. A level outside is an error and changes nothing; one above the table's
   * MaximumLevel is an error at the update.
   */
  void SetLevels(int i, int j, int k);
  void SetLevels(const int levels[3]) { this->SetLevels(levels[0], levels[1], levels[2]); }
  vtkGetVector3Macro(Levels, int);
  //@}

  //@{
  /**
   * The table that the pattern is taken from; by default its own, with MaximumLevel 7. nullptr
   * restores the default.
   */
  void SetTable(vtkRefinementPatternTable* table);
  vtkRefinementPatternTable* GetTable();
  //@}

  /**
   * Includes the table's time.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkRefinementPatternSource();
  ~vtkRefinementPatternSource() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Levels[3] = { 0, 0, 0 };
  vtkSmartPointer<vtkRefinementPatternTable> Table;

private:
  vtkRefinementPatternSource(const vtkRefinementPatternSource&) = delete;
  void operator=(const vtkRefinementPatternSource&) = delete;
};

#endif
