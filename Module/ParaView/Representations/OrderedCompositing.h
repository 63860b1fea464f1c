// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OrderedCompositing
 * @brief   has each process draw a surface in its own part of space
 *
 * Where something in a view is translucent, ParaView blends the pictures of processes in the order
 * of boxes of space. Its own way to get all surfaces into these boxes would cut coarse faces and
 * not know where the refined ones lie. Here a process gets the coarse faces that can reach its box
 * from the others, whole, and draws what of them lies in it.
 *
 * Private to the module.
 */
#ifndef OrderedCompositing_h
#define OrderedCompositing_h

#include "Changes/Dependencies.h"
#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkAbstractMapper;
class vtkAdaptiveRefinement;
class vtkDataObject;
class vtkInformation;
class vtkMatrix4x4;
class vtkPVDataRepresentation;
class vtkPVRenderView;

namespace relevo
{
class OrderedCompositing
{
public:
  /**
   * Tell the view which part of space is to be shared among processes: that of the data, and a
   * little around these bounds, without which ParaView cannot order boxes of flat data, and aborts
   * on some.
   */
  static void GiveSpace(
    vtkInformation* inInfo, vtkPVDataRepresentation* representation, const double bounds[6]);

  /**
   * The data that this process draws in a view, of the delivered ones of all: these themselves
   * where nothing needs an order. Faces are exchanged if the data, the boxes, the matrix or where
   * the recipe puts points have changed on any process. Collective.
   */
  vtkDataObject* Update(vtkPVRenderView* view, vtkDataObject* delivered,
    vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix);

  /// Have a mapper draw only what lies in this process's box.
  void Clip(vtkAbstractMapper* mapper);

private:
  void SetRegions(std::vector<vtkBoundingBox> regions);

  std::vector<vtkBoundingBox> Regions; // of the processes; empty where nothing needs an order
  bool IsClipped = true;               // by the regions as they are now
  vtkSmartPointer<vtkDataObject> Delivered;
  vtkSmartPointer<vtkDataObject> Gathered;
  Dependencies Sources; // of what was gathered
};
}

#endif
