// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIntegrationPointAverage
 * @brief   average values at integration points in each cell
 *
 * The output is the input with a cell array for each array of its field data that has values at
 * integration points. The cell array has the same name and components, of type double. Its tuples
 * are the arithmetic means of the values in each cell, and NaN in cells without integration points.
 * A cell array that has this name already is kept, and there is no average then.
 *
 * An array of values at integration points refers to a cell array of offsets by
 * vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME(), as vtkQuadraturePointInterpolator
 * makes it. XML files of VTK store this. An array whose offsets or schemes are missing or too short
 * is left out, with a warning.
 *
 * For cell arrays with one component for each integration point, use the quantity "mean of A" of
 * vtkArrayQuantityFilter.
 *
 * @sa vtkIntegrationPoints vtkQuadraturePointInterpolator
 */
#ifndef vtkIntegrationPointAverage_h
#define vtkIntegrationPointAverage_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

class RELEVOFILTERSVOLUME_EXPORT vtkIntegrationPointAverage : public vtkPassInputTypeAlgorithm
{
public:
  static vtkIntegrationPointAverage* New();
  vtkTypeMacro(vtkIntegrationPointAverage, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkIntegrationPointAverage();
  ~vtkIntegrationPointAverage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkIntegrationPointAverage(const vtkIntegrationPointAverage&) = delete;
  void operator=(const vtkIntegrationPointAverage&) = delete;
};

#endif
