// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveGeometry
 * @brief   a geometry filter whose output has the line cells of data sets
 *
 * Line cells of unstructured grids become poly-lines of their nodes, see CurveLines.h. Other cells
 * are left out. The structure of composite data sets is that of PlainGeometry.
 *
 * Private to the module.
 */
#ifndef CurveGeometry_h
#define CurveGeometry_h

#include "PlainGeometry.h"

namespace relevo
{
class CurveGeometry : public PlainGeometry
{
public:
  static CurveGeometry* New();
  vtkTypeMacro(CurveGeometry, PlainGeometry);

protected:
  CurveGeometry();
  ~CurveGeometry() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  CurveGeometry(const CurveGeometry&) = delete;
  void operator=(const CurveGeometry&) = delete;
};
}

#endif
