// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIntegrationPoints
 * @brief   the integration points of cells, with their values
 *
 * The output has a point and a vertex for each value of an array at integration points. Its point
 * data has the array, and "vtkOriginalCellIds" (vtkIdType), the cells within their blocks. The
 * blocks of a composite data set follow each other; blocks without the array are ignored.
 *
 * There are two kinds of arrays:
 *
 * - arrays of the field data with a quadrature scheme, which vtkQuadraturePointInterpolator makes,
 *   and which refer to offsets by vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME().
 * The shape function weights of the vtkQuadratureSchemeDefinition give the points. Cells of types
 *   without a definition have none.
 * - cell arrays with one component for each integration point. These cells have the points of the
 *   usual rules: lines of 1 to 3, quadrilaterals of 1, 4 and 9, hexahedra of 1, 8 and 27 points of
 *   Gauss-Legendre rules, the first parametric coordinate fastest and the third slowest; triangles
 *   of 1 and 3, and tetrahedra of 1 and 4 points, the k-th nearest to corner k; wedges of 1, 2, 6
 *   and 9 points, those of triangles fastest; pyramids of 1 point. Curved cells have the points of
 *   their shape, at the positions of their own shape functions. Other cells have no points, with a
 *   warning.
 *
 * If both exist, the array of the field data is taken. It is an error if no block has the array, if
 * the offsets or schemes are missing or do not fit the cells, or if no cell has points.
 *
 * @sa vtkIntegrationPointAverage vtkQuadraturePointsGenerator
 */
#ifndef vtkIntegrationPoints_h
#define vtkIntegrationPoints_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for names

class RELEVOFILTERSVOLUME_EXPORT vtkIntegrationPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkIntegrationPoints* New();
  vtkTypeMacro(vtkIntegrationPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the name of the array; none by default, which is an error.
   */
  vtkSetStdStringFromCharMacro(ArrayName);
  vtkGetCharFromStdStringMacro(ArrayName);
  //@}

protected:
  vtkIntegrationPoints();
  ~vtkIntegrationPoints() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkIntegrationPoints(const vtkIntegrationPoints&) = delete;
  void operator=(const vtkIntegrationPoints&) = delete;

  std::string ArrayName;
};

#endif
