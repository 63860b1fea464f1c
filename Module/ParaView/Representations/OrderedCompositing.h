// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   OrderedCompositing
 * @brief   makes each process draw the surface in its own region of space
 *
 * If a prop in a view is translucent, ParaView blends the images of processes in the order of boxes
 * of space. Its redistribution of surfaces into these boxes would cut coarse faces and ignore the
 * refined ones. Here, a process gets from the others the whole coarse faces that can reach its box,
 * and draws the part inside it.
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
   * Set the region of space that the view distributes over the processes: the region of the data,
   * slightly enlarged. Without the enlargement, ParaView cannot order boxes of flat data, and
   * aborts for some.
   */
  static void GiveSpace(
    vtkInformation* inInfo, vtkPVDataRepresentation* representation, const double bounds[6]);

  /**
   * Return the data that this process draws in a view. If no order is needed, these are the
   * delivered data. Faces are exchanged if the data, the boxes, the matrix or the recipe's
   * positions have changed on any process. Collective.
   */
  vtkDataObject* Update(vtkPVRenderView* view, vtkDataObject* delivered,
    vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix);

  /// Take over the boxes of a view, for data that are not exchanged. Return whether an order is
  /// needed.
  bool UpdateRegions(vtkPVRenderView* view);

  /// Make a mapper draw only inside this process's box.
  void Clip(vtkAbstractMapper* mapper);

private:
  void SetRegions(std::vector<vtkBoundingBox> regions);

  std::vector<vtkBoundingBox> Regions; // of the processes; empty if no order is needed
  bool IsClipped = true;               // by the current regions
  vtkSmartPointer<vtkDataObject> Delivered;
  vtkSmartPointer<vtkDataObject> Gathered;
  Dependencies Sources; // of the gathered faces
};
}

#endif
