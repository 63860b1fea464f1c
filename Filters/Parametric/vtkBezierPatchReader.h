// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBezierPatchReader
 * @brief   read Bézier patches (.bpt) as VTK Bézier cells
 *
 * The text file, a common format of the Utah teapot, starts with the number of patches. Each patch
 * has two degrees m and n, 1 to 8, and (m + 1) rows of n + 1 control points with three coordinates.
 * White space separates numbers. The decimal separator is a point in all locales.
 *
 * The output is a vtkUnstructuredGrid with one VTK_BEZIER_QUADRILATERAL per patch. Points are
 * double. The attribute "HigherOrderDegrees" is a cell array (int, 3 components: n, m, 0). The
 * first parametric direction of a cell, of degree n, follows the rows, so that the normals of the
 * teapot, first direction x second direction, point outwards. Control points on borders are merged
 * if their coordinates are equal, so that adjacent patches share their points. In a border that
 * degenerates to a point, that point occurs several times.
 *
 * The reader reports an error with file and line, and produces an empty output, if there is no file
 * name or no file; there are fewer or more numbers than the file declares; the number of patches is
 * negative; a degree is out of 1 to 8; or a coordinate is not a finite number.
 *
 * @sa vtkNURBSSource
 */
#ifndef vtkBezierPatchReader_h
#define vtkBezierPatchReader_h

#include "RelevoFiltersParametricModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class RELEVOFILTERSPARAMETRIC_EXPORT vtkBezierPatchReader : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkBezierPatchReader* New();
  vtkTypeMacro(vtkBezierPatchReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the file. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  /**
   * Return 1 if the file starts with a number of patches and two degrees from 1 to 8, 0 otherwise.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkBezierPatchReader();
  ~vtkBezierPatchReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName;

private:
  vtkBezierPatchReader(const vtkBezierPatchReader&) = delete;
  void operator=(const vtkBezierPatchReader&) = delete;

  int Read(vtkUnstructuredGrid* output);
};

#endif
