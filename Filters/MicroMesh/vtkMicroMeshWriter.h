// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMicroMeshWriter
 * @brief   write a micro-mesh to a compressed .rmm file
 *
 * The input is the output of vtkMicroMeshFilter. All its numeric arrays are written without loss.
 * Displacements take 8, 11 or 16 bits before compression, depending on the largest one. Other
 * arrays, for example of strings, are left out with a warning. The file is smaller than a .vtp file
 * with zlib. vtkXMLPolyDataWriter writes the same mesh as a .vtp file, which other programs can
 * read.
 *
 * The format is little-endian: a header with the version of the format and the size of the file,
 * and chunks with checksums (CRC-32), compressed by zlib.
 *
 * The file is written under a temporary name and replaces an old file only when it is complete.
 *
 * Write() returns 1 on success. It reports an error (ErrorEvent), returns 0 and keeps the old file
 * if there is no file name, the input is not a micro-mesh, or the file cannot be written.
 *
 * @sa vtkMicroMeshReader vtkMicroMeshFilter
 */
#ifndef vtkMicroMeshWriter_h
#define vtkMicroMeshWriter_h

#include "RelevoFiltersMicroMeshModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for errors

class vtkPolyData;

class RELEVOFILTERSMICROMESH_EXPORT vtkMicroMeshWriter : public vtkWriter
{
public:
  static vtkMicroMeshWriter* New();
  vtkTypeMacro(vtkMicroMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the file, usually with the extension .rmm.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

protected:
  vtkMicroMeshWriter();
  ~vtkMicroMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkMicroMeshWriter(const vtkMicroMeshWriter&) = delete;
  void operator=(const vtkMicroMeshWriter&) = delete;

  void Fail(const std::string& message, unsigned long code);
  void WriteMesh(vtkPolyData* mesh);
};

#endif
