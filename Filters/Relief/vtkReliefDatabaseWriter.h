// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefDatabaseWriter
 * @brief   write reliefs to a folder, as a Cinema database of Spec D
 *
 * The input is a relief (vtkImageData), or a composite data set of reliefs. Nested blocks are
 * flattened. For each relief, the writer creates relief_0000.vti etc. (appended data, compressed,
 * with all arrays) and an image of the colours, relief_0000.png etc. Last, it writes the table
 * data.csv, which Cinema viewers open.
 *
 * The folder is created if necessary. An existing folder must be empty or contain a database of
 * reliefs, which is replaced. New files have temporary names until the new table is in place. Then
 * the files of the old database (relief_*.vti, relief_*.png) are removed. If an error or a signal
 * occurs before that, the old database is intact. Other files are not touched.
 *
 * The table has a row of column names and a row for each relief, with numbers in C notation. The
 * columns are
 *
 * - the name of the block;
 * - projection: 0 for parallel, 1 for perspective;
 * - columns and rows: the size in texels;
 * - valid: the fraction of texels with a surface;
 * - position_x, _y and _z: the eye, or for parallel projection the middle of the plane of the
 *   relief;
 * - direction_x, _y and _z: the viewing direction;
 * - up_x, _y and _z: the direction of the columns of texels;
 * - each field array with one number or text, under its name;
 * - FILE: the .vti file, and FILE_image: the image.
 *
 * Write() returns 1 on success. It reports an error (ErrorEvent) and returns 0 if there is no file
 * name or no relief; a block is not a relief (the others are written); the folder contains files,
 * but no database of reliefs; or the folder or a file cannot be written. In the last two cases the
 * old contents are unchanged.
 *
 * @sa vtkReliefDatabaseReader
 */
#ifndef vtkReliefDatabaseWriter_h
#define vtkReliefDatabaseWriter_h

#include "RelevoFiltersReliefModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for names
#include <vector> // for blocks

namespace relevo
{
struct ReliefBlock;
}

class RELEVOFILTERSRELIEF_EXPORT vtkReliefDatabaseWriter : public vtkWriter
{
public:
  static vtkReliefDatabaseWriter* New();
  vtkTypeMacro(vtkReliefDatabaseWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the folder, or of data.csv in it.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /**
   * Set whether an image of the colours of each relief is written, for database viewers; on by
   * default.
   */
  vtkSetMacro(WriteImages, bool);
  vtkGetMacro(WriteImages, bool);
  vtkBooleanMacro(WriteImages, bool);
  //@}

protected:
  vtkReliefDatabaseWriter();
  ~vtkReliefDatabaseWriter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  void WriteData() override;

  char* FileName;
  bool WriteImages;

private:
  vtkReliefDatabaseWriter(const vtkReliefDatabaseWriter&) = delete;
  void operator=(const vtkReliefDatabaseWriter&) = delete;

  void Fail(const std::string& message, unsigned long code);
  void WriteInput();
  std::string WriteReliefs(const std::vector<relevo::ReliefBlock>& blocks);
};

#endif
