// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReliefDatabaseWriter
 * @brief   writes reliefs into a folder, as Cinema's Spec D
 *
 * Input: a relief, which is a vtkImageData, or a composite data set whose blocks are reliefs. The
 * folder, which is made if there is none, gets a file relief_0000.vti and so on for each (appended
 * data, compressed, all arrays as they are), a picture of its colours, relief_0000.png, and at last
 * the table data.csv, which Cinema's viewers open. A folder that is there has to be empty or to
 * have a database of reliefs, which is replaced: the files of the new one are written under
 * temporary names, and those of the old one (relief_*.vti, relief_*.png) are removed once the new
 * table is in its place. An error or a signal before leaves the old database; other files stay.
 *
 * The table has a row of names, and then one for each relief: the block's name; projection (0
 * parallel, 1 perspective); columns and rows; valid, the share of texels with a surface;
 * position_x, _y and _z, the eye, or in parallel projection the middle of the relief's plane;
 * direction_x, _y and _z, that it looks in; up_x, _y and _z, the direction of its columns of
 * texels; each field array of one number or text, by its name; FILE, the .vti file; FILE_image, the
 * picture. Numbers are in C's notation. Blocks of blocks become one list.
 *
 * Write() returns 1 if all was written. Errors (ErrorEvent of this object, 0 is returned): no file
 * name; nothing to write; a block that is no relief, which is left out; a folder with files but no
 * database of reliefs, or a folder or file that cannot be written, with the old database unchanged.
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
   * The folder, or data.csv in it.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /**
   * Whether each relief gets a picture of its colours, for viewers of databases; on by default.
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
