// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CurveTree
 * @brief   converts a tree of poly-lines to a tree of curves
 *
 * Private to the module.
 */
#ifndef CurveTree_h
#define CurveTree_h

#include "Changes/Dependencies.h"
#include "vtkSmartPointer.h"

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;

namespace relevo
{
class CurveTree
{
public:
  /**
   * Return the curves of the visible blocks of lines, which may be nullptr; see CurveLines.h. They
   * stay the same objects until the lines or the visibility of blocks change.
   */
  vtkDataObject* Make(vtkDataObject* lines, vtkCompositeDataDisplayAttributes* attributes);

private:
  Dependencies Sources;
  vtkSmartPointer<vtkDataObject> Lines; // owned so that no other object gets its address
  vtkSmartPointer<vtkDataObject> Curves;
};
}

#endif
