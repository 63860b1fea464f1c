// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPAdaptiveRefinementFilter
 * @brief   vtkAdaptiveRefinementFilter for surfaces distributed over several processes
 *
 * The refined pieces of all processes fit together bit by bit. Together they equal the result of
 * one process for the whole surface. Input and output are a vtkPolyData or a tree of them. All
 * processes must update the filter; pieces may be empty. Ghost cells are exchanged. Points and
 * cells are sorted by position, independently of the order of the input. "vtkOriginalCellIds" are
 * ids of the local input.
 *
 * The default controller is the global one.
 */
#ifndef vtkPAdaptiveRefinementFilter_h
#define vtkPAdaptiveRefinementFilter_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkAdaptiveRefinementFilter.h"

#include <memory> // for members

class vtkDepthTagMetric;
class vtkDisplacement;
class vtkRefinementSurface;

namespace relevo
{
class PieceFilter;
}

class RELEVOPARAVIEWFILTERS_EXPORT vtkPAdaptiveRefinementFilter : public vtkAdaptiveRefinementFilter
{
public:
  static vtkPAdaptiveRefinementFilter* New();
  vtkTypeMacro(vtkPAdaptiveRefinementFilter, vtkAdaptiveRefinementFilter);

  //@{
  /**
   * Set the metric, surface or displacement of the recipe. Without a recipe, this is an error and
   * changes nothing.
   */
  void SetMetric(vtkDepthTagMetric* metric);
  void SetSurface(vtkRefinementSurface* surface);
  void SetDisplacement(vtkDisplacement* displacement);
  //@}

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkPAdaptiveRefinementFilter();
  ~vtkPAdaptiveRefinementFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  bool HasRecipe(); // reports an ErrorEvent if it is false

  std::unique_ptr<relevo::PieceFilter> Pieces;

  vtkPAdaptiveRefinementFilter(const vtkPAdaptiveRefinementFilter&) = delete;
  void operator=(const vtkPAdaptiveRefinementFilter&) = delete;
};

#endif
