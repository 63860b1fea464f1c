// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefDatabaseReader
 * @brief   read a folder of reliefs, a Cinema database of Spec D
 *
 * The folder contains a table, data.csv, with a row of column names and a row for each relief.
 * Fields with commas are quoted. The relief of a row is the first .vti file in a column whose name
 * begins with FILE, relative to the folder. vtkReliefDatabaseWriter writes such databases.
 *
 * The output is a vtkMultiBlockDataSet with a block for each row, in the order of the table. The
 * column "name" gives the names of the blocks. Reliefs are read as they were written, to the bit.
 *
 * If a column "time" or "TimeValue" contains only numbers, these are the time steps of the
 * pipeline. The output then contains the rows of the last step that is not later than the requested
 * time, or of the first step. Rows without a time are part of all steps.
 *
 * The reader reports an error (ErrorEvent) and produces an empty output if there is no file name or
 * no table; the table has no reliefs, an unterminated quote or NUL bytes; or memory is
 * insufficient. It reports one error for all rows that cannot be read, with the first one and their
 * number: rows with a wrong number of fields, without a .vti file, or with a file that is outside
 * of the folder (".." or an absolute path), missing, damaged or not a relief. Their blocks are
 * empty.
 *
 * @sa vtkReliefDatabaseWriter
 */
#ifndef vtkReliefDatabaseReader_h
#define vtkReliefDatabaseReader_h

#include "RelevoFiltersReliefModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

namespace relevo
{
class ReliefTable;
}

class RELEVOFILTERSRELIEF_EXPORT vtkReliefDatabaseReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkReliefDatabaseReader* New();
  vtkTypeMacro(vtkReliefDatabaseReader, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the folder, or of data.csv in it.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  /**
   * Return 1 if the table exists and a row names a .vti file, 0 otherwise.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkReliefDatabaseReader();
  ~vtkReliefDatabaseReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName;

private:
  vtkReliefDatabaseReader(const vtkReliefDatabaseReader&) = delete;
  void operator=(const vtkReliefDatabaseReader&) = delete;

  bool FindTimes(vtkInformationVector* outputVector);
  bool ReadReliefs(vtkInformationVector* outputVector);
  void ReadRows(const relevo::ReliefTable& table, double time, vtkMultiBlockDataSet* output);
};

#endif
