// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBezierPatchReader
 * @brief   reads Bézier patches (.bpt) as VTK's Bézier cells
 *
 * The text has the number of patches, then, for each, its two degrees m and n, 1 to 8, and (m + 1)
 * rows of n + 1 control points of three coordinates; space, of any kind, is between all numbers,
 * whose decimal point is a point in every locale. The teapot is kept so.
 *
 * Output: a vtkUnstructuredGrid with a VTK_BEZIER_QUADRILATERAL for each patch, points in double,
 * and the cell array "HigherOrderDegrees" (int, 3 components: n, m, 0), which is their attribute.
 * A cell's first parametric direction leads along the rows, with the degree n: so the normals of
 * the teapot, first direction x second, point outwards. Control points of the patches' borders that
 * have equal coordinates are one point, so patches that have a border in common share its points,
 * and a border that is one place is one point several times.
 *
 * Errors, with an empty output, name file and line: no file name, or no file; fewer or more
 * numbers than the file tells of; a number of patches below 0; a degree out of 1 to 8; a
 * coordinate that is no finite number.
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
   * The file to read; needed.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  /**
   * 1 if the file begins with a number of patches and with degrees from 1 to 8, else 0.
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
