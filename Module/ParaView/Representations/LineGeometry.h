// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   LineGeometry
 * @brief   a geometry filter whose output has the line cells of data sets
 *
 * Line cells of unstructured grids become poly-lines of their nodes, see CurveLines.h. Other cells
 * are left out. The structure of composite data sets is that of PlainGeometry.
 *
 * Private to the module.
 */
#ifndef LineGeometry_h
#define LineGeometry_h

#include "PlainGeometry.h"

namespace relevo
{
class LineGeometry : public PlainGeometry
{
public:
  static LineGeometry* New();
  vtkTypeMacro(LineGeometry, PlainGeometry);

protected:
  LineGeometry();
  ~LineGeometry() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  LineGeometry(const LineGeometry&) = delete;
  void operator=(const LineGeometry&) = delete;
};
}

#endif
