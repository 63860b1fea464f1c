// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMicroMeshReader
 * @brief   read a micro-mesh from an .rmm file
 *
 * The output has the points, triangles and numeric arrays that vtkMicroMeshWriter wrote, to the
 * bit.
 *
 * The reader reports an error (ErrorEvent) and produces an empty output if there is no file name or
 * no such file; the file is not an .rmm file, has a newer version of the format, is truncated or
 * damaged (a checksum is wrong); its arrays are not those of a micro-mesh; or memory is
 * insufficient.
 *
 * @sa vtkMicroMeshWriter vtkMicroMeshSurface
 */
#ifndef vtkMicroMeshReader_h
#define vtkMicroMeshReader_h

#include "RelevoFiltersMicroMeshModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class RELEVOFILTERSMICROMESH_EXPORT vtkMicroMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMicroMeshReader* New();
  vtkTypeMacro(vtkMicroMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the file.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  /**
   * Return 1 if the file begins like an .rmm file, of any version, 0 otherwise.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkMicroMeshReader();
  ~vtkMicroMeshReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkMicroMeshReader(const vtkMicroMeshReader&) = delete;
  void operator=(const vtkMicroMeshReader&) = delete;

  bool ReadMesh(vtkPolyData* output);
};

#endif
