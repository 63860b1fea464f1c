// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementPatternSource
 * @brief   show one refinement pattern as polygonal data
 *
 * The output is that of vtkRefinementPatternTable::GetPattern() for Levels: points at
 * (u, v, w) -> (v, w, 0), counter-clockwise triangles, and the barycentric coordinates in the point
 * array "Barycentrics" (three float components).
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
   * Set the levels of the edges P1P2, P2P3 and P3P1, in any order, each 0 to 7. The default is
   * (0, 0, 0), the undivided triangle. Levels out of range are rejected with an error. A level
   * above the table's MaximumLevel is an error in the update.
   */
  void SetLevels(int i, int j, int k);
  void SetLevels(const int levels[3]) { this->SetLevels(levels[0], levels[1], levels[2]); }
  vtkGetVector3Macro(Levels, int);
  //@}

  //@{
  /**
   * Set the table of patterns. By default the source has a table with MaximumLevel 7. nullptr
   * restores the default.
   */
  void SetTable(vtkRefinementPatternTable* table);
  vtkRefinementPatternTable* GetTable();
  //@}

  /**
   * Return the time of the latest change of the source or the table.
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
