// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefDatabaseReader
 * @brief   reads the reliefs of a folder, as Cinema's Spec D
 *
 * The folder has a table, data.csv: a row of names, and one for each relief, fields in quotes where
 * they have commas. Of columns whose names begin with FILE the first in a row that names a .vti
 * file counts; names are relative to the folder. As vtkReliefDatabaseWriter makes them, or any
 * other database of that kind.
 *
 * Output: a vtkMultiBlockDataSet with a block for each row, in their order, called as its column
 * "name" says: reliefs to the bit as they were written.
 *
 * If all that a column "time" or "TimeValue" has are numbers, these are the time steps of the
 * pipeline, and the output has the rows of one of them: the last that is not later than the time
 * asked for, or the first. Rows without a number there belong to all.
 *
 * Errors (ErrorEvent of this object), with an empty output: no file name; no table; one without
 * rows of reliefs, with a quote that is not closed, or with NUL bytes; not enough memory. One error
 * for all rows that cannot be read, with the first of them and their number, for a row with more or
 * fewer fields than there are names, without a .vti file, or with one outside of the folder ("..",
 * or an absolute path); for a file that is missing, damaged or no relief. Their blocks stay empty
 * and the rest is read.
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
   * The folder, or data.csv in it.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  /**
   * 1 if there is a table there and a row of it names a .vti file, else 0.
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
