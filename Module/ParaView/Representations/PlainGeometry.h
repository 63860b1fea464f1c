// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PlainGeometry
 * @brief   the geometry filter of ParaView's representations, without changes of cells
 *
 * It ignores the settings that triangulate faces or replace them by feature edges, and keeps the
 * ids of cells and points like that filter in a representation.
 *
 * The class of that filter is vtkPVGeometryFilter. ParaView 6.2 deprecates it, and its
 * representations use VTK's vtkGeometryFilterDispatcher, which has the same methods. This has been
 * compared with the source of ParaView 6.2, but not yet run with it.
 *
 * Private to the module.
 */
#ifndef PlainGeometry_h
#define PlainGeometry_h

#include "vtkPVVersion.h"

#if PARAVIEW_VERSION_NUMBER >= PARAVIEW_VERSION_CHECK(6, 2, 0)
#include "vtkGeometryFilterDispatcher.h"
#else
#include "vtkPVGeometryFilter.h"
#endif

namespace relevo
{
#if PARAVIEW_VERSION_NUMBER >= PARAVIEW_VERSION_CHECK(6, 2, 0)
using RepresentationGeometry = vtkGeometryFilterDispatcher;
#else
using RepresentationGeometry = vtkPVGeometryFilter;
#endif

class PlainGeometry : public RepresentationGeometry
{
public:
  vtkAbstractTypeMacro(PlainGeometry, RepresentationGeometry);

protected:
  PlainGeometry()
  {
    this->SetUseOutline(0);
    this->SetPassThroughCellIds(1);
    this->SetPassThroughPointIds(1);
  }
  ~PlainGeometry() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override
  {
    // Their setters are not virtual in all versions.
    this->SetTriangulate(false);
    this->SetGenerateFeatureEdges(false);
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }

private:
  PlainGeometry(const PlainGeometry&) = delete;
  void operator=(const PlainGeometry&) = delete;
};
}

#endif
