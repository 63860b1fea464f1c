// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPDepthTagFilter
 * @brief   vtkDepthTagFilter for surfaces whose pieces several processes have
 *
 * The tags are those that one process would give to the whole. Input and output are a vtkPolyData
 * or a tree of them. All processes update the filter; pieces may be empty. Points that no cell
 * uses, or only ghosts, have the tag 0.
 *
 * The controller is the global one at first.
 */
#ifndef vtkPDepthTagFilter_h
#define vtkPDepthTagFilter_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkDepthTagFilter.h"

#include <memory> // for members

namespace relevo
{
class PieceFilter;
}

class RELEVOPARAVIEWFILTERS_EXPORT vtkPDepthTagFilter : public vtkDepthTagFilter
{
public:
  static vtkPDepthTagFilter* New();
  vtkTypeMacro(vtkPDepthTagFilter, vtkDepthTagFilter);

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkPDepthTagFilter();
  ~vtkPDepthTagFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::unique_ptr<relevo::PieceFilter> Pieces;

  vtkPDepthTagFilter(const vtkPDepthTagFilter&) = delete;
  void operator=(const vtkPDepthTagFilter&) = delete;
};

#endif
