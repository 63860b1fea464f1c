// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPDepthTagFilter
 * @brief   vtkDepthTagFilter for surfaces distributed over several processes
 *
 * The tags equal those that one process computes for the whole surface. Input and output are a
 * vtkPolyData or a tree of them. All processes must update the filter; pieces may be empty. Points
 * that are used by no cell, or only by ghost cells, have the tag 0.
 *
 * The default controller is the global one.
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
