// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OrderedCompositing.h"

#include "RegionFaces.h"
#include "SpaceRegions.h"
#include "vtkAbstractMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDisplacement.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace relevo
{
namespace
{
std::vector<vtkBoundingBox> GetCuts(vtkPVRenderView* view)
{
  auto manager = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  return manager && view->GetUseOrderedCompositing() ? manager->GetCuts()
                                                     : std::vector<vtkBoundingBox>();
}

Dependencies GetSources(vtkDataObject* delivered, vtkAdaptiveRefinement* recipe,
  vtkMatrix4x4* matrix, const std::vector<vtkBoundingBox>& regions)
{
  Dependencies sources;
  sources.AddObject(delivered);
  sources.AddObject(recipe ? recipe->GetSurface() : nullptr);
  sources.AddObject(recipe ? recipe->GetDisplacement() : nullptr);
  for (int i = 0; i < 16; ++i)
  {
    sources.Add(matrix->GetElement(i / 4, i % 4));
  }
  for (const vtkBoundingBox& region : regions)
  {
    for (int side = 0; side < 6; ++side)
    {
      sources.Add(region.GetBound(side));
    }
  }
  return sources;
}
}

void OrderedCompositing::GiveSpace(
  vtkInformation* inInfo, vtkPVDataRepresentation* representation, const double bounds[6])
{
  // The view does not redistribute the data themselves.
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, representation, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);

  vtkNew<vtkPolyData> corners;
  vtkBoundingBox box(bounds);
  if (box.IsValid())
  {
    box.Inflate(0.01 * box.GetDiagonalLength() + 1e-6 * (1.0 + std::abs(box.GetBound(0))));
    double low[3];
    double high[3];
    box.GetMinPoint(low);
    box.GetMaxPoint(high);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkIdType ids[2] = { points->InsertNextPoint(low), points->InsertNextPoint(high) };
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(2, ids);
    corners->SetPoints(points);
    corners->SetVerts(cells);
  }
  constexpr int port = 1; // port 0 has the data to draw
  constexpr unsigned long size = 1;
  vtkPVView::SetPiece(inInfo, representation, corners, size, port);
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, representation, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING, nullptr, port);
}

void OrderedCompositing::SetRegions(std::vector<vtkBoundingBox> regions)
{
  if (this->Regions != regions)
  {
    this->Regions = std::move(regions);
    this->IsClipped = false;
  }
}

bool OrderedCompositing::UpdateRegions(vtkPVRenderView* view)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const std::vector<vtkBoundingBox> cuts = GetCuts(view);
  const bool isOrdered = controller && controller->GetNumberOfProcesses() > 1 &&
    cuts.size() == static_cast<std::size_t>(controller->GetNumberOfProcesses());
  this->SetRegions(isOrdered ? ShareSpace(cuts) : std::vector<vtkBoundingBox>());
  return isOrdered;
}

vtkDataObject* OrderedCompositing::Update(vtkPVRenderView* view, vtkDataObject* delivered,
  vtkAdaptiveRefinement* recipe, vtkMatrix4x4* matrix)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!this->UpdateRegions(view))
  {
    this->Delivered = nullptr;
    this->Gathered = nullptr;
    this->Sources.Clear();
    return delivered;
  }
  const int own = this->Sources.Update(GetSources(delivered, recipe, matrix, this->Regions));
  int any = own;
  controller->AllReduce(&own, &any, 1, vtkCommunicator::MAX_OP);
  if (any)
  {
    this->Delivered = delivered; // owned so that no other object gets its address
    this->Gathered = GatherRegionFaces(
      vtkDataObjectTree::SafeDownCast(delivered), recipe, matrix, this->Regions, controller);
  }
  return this->Gathered;
}

void OrderedCompositing::Clip(vtkAbstractMapper* mapper)
{
  if (this->IsClipped)
  {
    return;
  }
  this->IsClipped = true;
  mapper->RemoveAllClippingPlanes();
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  for (int side = 0; side < 6 && !this->Regions.empty(); ++side)
  {
    const double bound =
      this->Regions[static_cast<std::size_t>(controller->GetLocalProcessId())].GetBound(side);
    if (std::abs(bound) < VTK_DOUBLE_MAX)
    {
      double origin[3] = { 0.0, 0.0, 0.0 };
      double normal[3] = { 0.0, 0.0, 0.0 };
      origin[side / 2] = bound;
      normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(origin);
      plane->SetNormal(normal);
      mapper->AddClippingPlane(plane);
    }
  }
}
}
