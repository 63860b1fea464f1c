// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPAdaptiveRefinementFilter
 * @brief   vtkAdaptiveRefinementFilter for surfaces whose pieces several processes have
 *
 * The refined pieces of all processes fit together to the bit, and are together what one process
 * makes of the whole. Input and output are a vtkPolyData or a tree of them. All processes update
 * the filter; pieces may be empty. Ghosts are exchanged. Points and cells come in the order of
 * where they lie, whatever the order of the input; "vtkOriginalCellIds" are ids of the process's
 * own input.
 *
 * The controller is the global one at first.
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
   * Set them of the recipe. Without a recipe it is an error, and changes nothing.
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
  bool HasRecipe(); // false after an ErrorEvent

  std::unique_ptr<relevo::PieceFilter> Pieces;

  vtkPAdaptiveRefinementFilter(const vtkPAdaptiveRefinementFilter&) = delete;
  void operator=(const vtkPAdaptiveRefinementFilter&) = delete;
};

#endif
