// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveCurveRepresentation.h"

#include "CurveTree.h"
#include "InputCells.h"
#include "LineGeometry.h"
#include "MapperMessages.h"
#include "OrderedCompositing.h"
#include "RepresentationReports.h"
#include "ViewBounds.h"
#include "vtkAdaptiveCurveMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPolyDataMapper.h"

#include <string>

struct vtkAdaptiveCurveRepresentation::vtkInternals
{
  explicit vtkInternals(vtkAdaptiveCurveRepresentation* self)
    : Messages([self](bool isError, const std::string& message)
        { relevo::Report(self, isError, relevo::NameOwnRank(message)); },
        { relevo::TooLargeWords })
  {
  }

  vtkNew<vtkPatchErrorDepthTagMetric> Metric;
  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveCurveMapper> Mapper;
  vtkNew<vtkAdaptiveCurveMapper> Measure; // of bounds, before data reach the process that draws
  vtkNew<vtkPolyDataMapper> Unused;       // replaces the mapper where the base class sets it
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  relevo::CurveTree Curves;
  relevo::CurveTree MeasuredCurves;
  relevo::MapperMessages Messages;
  std::string Warning; // reported last
};

vtkStandardNewMacro(vtkAdaptiveCurveRepresentation);

vtkAdaptiveCurveRepresentation::vtkAdaptiveCurveRepresentation()
  : Internals(new vtkInternals(this))
{
  vtkInternals& data = *this->Internals;
  data.Recipe->SetMetric(data.Metric);
  data.Recipe->SetSegmentPolicy(vtkAdaptiveRefinement::WHOLE_NUMBERS);
  data.Recipe->SetMaximumLevel(7);
  data.Mapper->SetRefinement(data.Recipe);
  data.Measure->SetRefinement(data.Recipe);
  data.Messages.Observe(data.Mapper);

  auto* geometry = relevo::LineGeometry::New();
  this->GeometryFilter->Delete();
  this->GeometryFilter = geometry;
  this->MultiBlockMaker->SetInputConnection(geometry->GetOutputPort());

  // The base class would draw decimated data with its own mapper while the view moves.
  this->SuppressLOD = true;
  this->Mapper->UnRegister(this);
  this->Mapper = data.Mapper;
  this->Mapper->Register(this);
  this->Actor->SetMapper(this->Mapper);
}

vtkAdaptiveCurveRepresentation::~vtkAdaptiveCurveRepresentation() = default;

vtkAdaptiveCurveMapper* vtkAdaptiveCurveRepresentation::GetMapper()
{
  return this->Internals->Mapper;
}

void vtkAdaptiveCurveRepresentation::SetScreenSpaceError(double pixels)
{
  this->Internals->Metric->SetScreenSpaceError(pixels);
}

double vtkAdaptiveCurveRepresentation::GetScreenSpaceError()
{
  return this->Internals->Metric->GetScreenSpaceError();
}

void vtkAdaptiveCurveRepresentation::SetCurveRepresentation(int representation)
{
  this->Internals->Mapper->SetRepresentation(representation);
}

int vtkAdaptiveCurveRepresentation::GetCurveRepresentation()
{
  return this->Internals->Mapper->GetRepresentation();
}

void vtkAdaptiveCurveRepresentation::SetRadius(double radius)
{
  this->Internals->Mapper->SetRadius(radius);
}

double vtkAdaptiveCurveRepresentation::GetRadius()
{
  return this->Internals->Mapper->GetRadius();
}

void vtkAdaptiveCurveRepresentation::SetRadiusArrayName(const char* name)
{
  this->Internals->Mapper->SetRadiusArrayName(name);
}

const char* vtkAdaptiveCurveRepresentation::GetRadiusArrayName()
{
  return this->Internals->Mapper->GetRadiusArrayName();
}

void vtkAdaptiveCurveRepresentation::SetNumberOfSides(int sides)
{
  this->Internals->Mapper->SetNumberOfSides(sides);
}

int vtkAdaptiveCurveRepresentation::GetNumberOfSides()
{
  return this->Internals->Mapper->GetNumberOfSides();
}

void vtkAdaptiveCurveRepresentation::SetSuppressLOD(bool)
{
}

void vtkAdaptiveCurveRepresentation::SetArrayIdNames(const char*, const char*)
{
}

void vtkAdaptiveCurveRepresentation::Update()
{
  this->Superclass::Update();
  const bool hasNone = relevo::HasCellsButNone(
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr,
    relevo::CountLines(this->MultiBlockMaker->GetOutputDataObject(0)),
    vtkMultiProcessController::GetGlobalController());
  const std::string warning =
    hasNone ? "The data have no line cells, so Adaptive Curves draws nothing." : "";
  relevo::ReportWarning(this, this->Internals->Warning, warning);
}

bool vtkAdaptiveCurveRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  // The ids that the mapper draws are not those of the input's cells.
  vtkPVRenderView::SafeDownCast(view)->UnRegisterPropForHardwareSelection(
    this, this->GetRenderedProp());
  return true;
}

int vtkAdaptiveCurveRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_RENDER())
  {
    return this->RequestRender(request, inInfo, outInfo);
  }
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->GiveBounds(inInfo);
    // The view would cut the nodes of curves.
    relevo::OrderedCompositing::GiveSpace(inInfo, this, this->VisibleDataBounds);
  }
  return 1;
}

void vtkAdaptiveCurveRepresentation::GiveBounds(vtkInformation* inInfo)
{
  vtkInternals& data = *this->Internals;
  vtkDataObject* lines = vtkPVView::GetPiece(inInfo, this);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  this->PopulateBlockAttributes(attributes, lines);
  data.Measure->SetRepresentation(data.Mapper->GetRepresentation());
  data.Measure->SetRadius(data.Mapper->GetRadius());
  data.Measure->SetRadiusArrayName(data.Mapper->GetRadiusArrayName());
  data.Measure->SetInputDataObject(data.MeasuredCurves.Make(lines, attributes));
  relevo::MeasureBounds(data.Measure, this->VisibleDataBounds);
  relevo::GiveBounds(inInfo, this, this->VisibleDataBounds, this->Actor);
}

int vtkAdaptiveCurveRepresentation::RequestRender(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  vtkInternals& data = *this->Internals;
  this->Mapper = data.Unused;
  const int result = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
  this->Mapper = data.Mapper;
  if (!result)
  {
    return 0;
  }
  vtkDataObject* lines = vtkPVView::GetDeliveredPiece(inInfo, this);
  this->PopulateBlockAttributes(data.Attributes, lines);
  data.Mapper->SetInputDataObject(data.Curves.Make(lines, data.Attributes));
  this->UpdateColoringParameters();
  this->BackfaceActor->SetVisibility(0);
  return 1;
}

void vtkAdaptiveCurveRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScreenSpaceError: " << this->Internals->Metric->GetScreenSpaceError() << "\n";
  os << indent << "Mapper:\n";
  this->Internals->Mapper->PrintSelf(os, indent.GetNextIndent());
}
