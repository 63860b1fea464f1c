// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinementRepresentation.h"

#include "FirstRank.h"
#include "FrameAgreement.h"
#include "MapperMessages.h"
#include "MethodChoice.h"
#include "OrderedCompositing.h"
#include "RepresentationReports.h"
#include "SurfacePieces.h"
#include "ViewBounds.h"
#include "vtkAdaptiveLICMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkScalarTaggedSurface.h"
#include "vtkSelection.h"

#include <string>
#include <vector>

namespace
{
const relevo::MapperWords SurfaceWords = { relevo::CellDataWords, relevo::TooLargeWords };

using UsedArrays = std::vector<relevo::PieceCheck::Array>;

void AddVectors(vtkAdaptiveRefinementMapper* mapper, UsedArrays& arrays)
{
  vtkInformation* vectors =
    vtkAdaptiveLICMapper::SafeDownCast(mapper) ? mapper->GetInputArrayInformation(0) : nullptr;
  if (vectors && vectors->Has(vtkDataObject::FIELD_NAME()))
  {
    const bool isOfCells =
      vectors->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
    arrays.push_back(
      { vectors->Get(vtkDataObject::FIELD_NAME()), isOfCells, "SelectInputVectors" });
  }
}

// Return the arrays that the mapper uses if the mesh has them. Metrics report arrays that they
// need.
UsedArrays FindUsedArrays(vtkAdaptiveRefinementMapper* mapper)
{
  UsedArrays arrays;
  AddVectors(mapper, arrays);
  vtkAdaptiveRefinement* recipe = mapper->GetRefinement();
  if (!recipe)
  {
    return arrays;
  }
  arrays.push_back({ recipe->GetDepthTagArrayName(), false, "DepthTagArrayName" });
  if (auto tagged = vtkScalarTaggedSurface::SafeDownCast(recipe->GetSurface()))
  {
    arrays.push_back({ tagged->GetSharpnessArrayName(), false, "SharpnessArrayName" });
    arrays.push_back({ tagged->GetTensionArrayName(), false, "TensionArrayName" });
    arrays.push_back({ tagged->GetBiasArrayName(), false, "BiasArrayName" });
    arrays.push_back({ tagged->GetDirectionArrayName(), false, "DirectionArrayName" });
  }
  return arrays;
}
}

struct vtkAdaptiveRefinementRepresentation::vtkInternals
{
  explicit vtkInternals(vtkAdaptiveRefinementRepresentation* self);

  relevo::SurfacePieces Pieces;
  relevo::OrderedCompositing Order;
  relevo::MapperMessages Messages;
  relevo::FrameAgreement Agreement;
  // Errors that were reported last.
  std::string MissingError;
  std::string NotFiniteError;
};

vtkAdaptiveRefinementRepresentation::vtkInternals::vtkInternals(
  vtkAdaptiveRefinementRepresentation* self)
  : Messages([self](bool isError, const std::string& message)
      { relevo::Report(self, isError, relevo::NameOwnRank(message)); },
      SurfaceWords)
  , Agreement(self,
      [self](vtkMultiProcessController* ranks, vtkRenderer* ren)
      { self->GetMapper()->AgreeWithProcesses(ranks, ren, self->Actor); })
{
}

vtkStandardNewMacro(vtkAdaptiveRefinementRepresentation);

vtkAdaptiveRefinementRepresentation::vtkAdaptiveRefinementRepresentation()
  : Internals(new vtkInternals(this))
{
  this->Internals->Pieces.SetChecked(true);
  // The base class would draw a decimated surface with its own mapper while the view moves.
  this->SuppressLOD = true;
  // Without these calls, vtkPVLODActor creates a shader property in each frame, and shaders are
  // rebuilt.
  this->Actor->GetShaderProperty();
  this->BackfaceActor->GetShaderProperty();
  vtkNew<vtkAdaptiveRefinementMapper> mapper;
  this->SetMapper(mapper);
}

vtkAdaptiveRefinementRepresentation::~vtkAdaptiveRefinementRepresentation() = default;

void vtkAdaptiveRefinementRepresentation::SetMapper(vtkAdaptiveRefinementMapper* mapper)
{
  if (!mapper)
  {
    vtkErrorMacro("SetMapper() needs a mapper, but it is null.");
    return;
  }
  if (this->Mapper == mapper)
  {
    return;
  }
  mapper->SetProcessIdArrayName("vtkProcessId");
  mapper->SetCompositeIdArrayName("vtkCompositeIndex");
  vtkNew<vtkSelection> selection;
  mapper->SetSelection(selection);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkInternals& data = *this->Internals;
  data.Messages.Observe(mapper);
  mapper->Register(this);
  this->Mapper->UnRegister(this);
  this->Mapper = mapper;
  mapper->SetMethod(relevo::GetRefinementMethod(this->Method));
  this->Actor->SetMapper(mapper);
  this->BackfaceActor->SetMapper(mapper);
  this->SetArrayIdNames(nullptr, nullptr);
  data.Order = relevo::OrderedCompositing(); // a new object, which clips the new mapper
  this->BlockAttrChanged = true;
  this->Modified();
}

vtkAdaptiveRefinementMapper* vtkAdaptiveRefinementRepresentation::GetMapper()
{
  return vtkAdaptiveRefinementMapper::SafeDownCast(this->Mapper);
}

void vtkAdaptiveRefinementRepresentation::SetMethod(int method)
{
  relevo::SetMethod(this, this->Method, method);
  this->GetMapper()->SetMethod(relevo::GetRefinementMethod(this->Method));
}

void vtkAdaptiveRefinementRepresentation::SetRefinementColorMode(int mode)
{
  if (mode < 0 || mode > vtkAdaptiveRefinementMapper::COLOR_BY_METRIC)
  {
    vtkErrorMacro("RefinementColorMode must be in [0, 3], got " << mode << ".");
    return;
  }
  if (this->RefinementColorMode != mode)
  {
    this->RefinementColorMode = mode;
    this->Modified();
  }
}

// The base class's settings reset the mode to scalars.
void vtkAdaptiveRefinementRepresentation::ApplyColorMode()
{
  vtkAdaptiveRefinementMapper* mapper = this->GetMapper();
  switch (this->RefinementColorMode)
  {
    case vtkAdaptiveRefinementMapper::COLOR_BY_LEVEL:
      mapper->SetColorModeToLevel();
      break;
    case vtkAdaptiveRefinementMapper::COLOR_BY_PATTERN:
      mapper->SetColorModeToPattern();
      break;
    case vtkAdaptiveRefinementMapper::COLOR_BY_METRIC:
      mapper->SetColorModeToMetric();
      break;
    default:
      mapper->SetColorModeToScalars();
  }
}

void vtkAdaptiveRefinementRepresentation::SetSuppressLOD(bool)
{
}

void vtkAdaptiveRefinementRepresentation::SetArrayIdNames(
  const char* pointArray, const char* cellArray)
{
  vtkAdaptiveRefinementMapper* mapper = this->GetMapper();
  mapper->SetPointIdArrayName(pointArray ? pointArray : "vtkOriginalPointIds");
  mapper->SetCellIdArrayName(cellArray ? cellArray : "vtkOriginalCellIds");
}

void vtkAdaptiveRefinementRepresentation::Update()
{
  this->Superclass::Update();
  this->Internals->Pieces.Update(
    vtkDataObjectTree::SafeDownCast(this->MultiBlockMaker->GetOutputDataObject(0)),
    vtkMultiProcessController::GetGlobalController());
}

// Each process knows the problems of all processes. The first one reports them, because a client
// shows its messages only.
void vtkAdaptiveRefinementRepresentation::ReportProblems()
{
  if (!relevo::IsFirstRank())
  {
    return;
  }
  vtkInternals& data = *this->Internals;
  const relevo::PieceCheck& check = data.Pieces.GetCheck();
  relevo::ReportError(this, data.NotFiniteError, check.DescribeNotFinite());
  relevo::ReportError(
    this, data.MissingError, check.DescribeMissing(FindUsedArrays(this->GetMapper())));
}

bool vtkAdaptiveRefinementRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  this->Internals->Agreement.Start(view);
  return true;
}

bool vtkAdaptiveRefinementRepresentation::RemoveFromView(vtkView* view)
{
  this->Internals->Agreement.Stop();
  return this->Superclass::RemoveFromView(view);
}

vtkDataObject* vtkAdaptiveRefinementRepresentation::ConvertPieces(vtkDataObject* pieces)
{
  return pieces;
}

void vtkAdaptiveRefinementRepresentation::UseCurvedFaces()
{
  this->Internals->Pieces.SetSharedFacesRemoved(true);
}

int vtkAdaptiveRefinementRepresentation::ProcessViewRequest(
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
    if (!this->UseDataPartitions)
    {
      relevo::OrderedCompositing::GiveSpace(inInfo, this, this->VisibleDataBounds);
    }
  }
  return 1;
}

int vtkAdaptiveRefinementRepresentation::RequestRender(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  const bool attributesChanged = this->BlockAttrChanged;
  // The base class sets the delivered data as its mapper's input. If these are not the data to
  // draw, this would rebuild all buffers in each frame.
  vtkMapper* mapper = this->Mapper;
  this->Mapper = this->Unused;
  const int result = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
  this->Mapper = mapper;
  if (!result)
  {
    return 0;
  }
  vtkDataObject* data = vtkPVView::GetDeliveredPiece(inInfo, this);
  if (auto view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW())))
  {
    vtkNew<vtkMatrix4x4> matrix;
    this->Actor->GetMatrix(matrix);
    data = this->Internals->Order.Update(view, data, this->GetMapper()->GetRefinement(), matrix);
  }
  data = this->ConvertPieces(data);
  this->ReportProblems();
  this->Internals->Order.Clip(mapper);
  mapper->SetInputDataObject(data);
  this->UpdateColoringParameters();
  this->ApplyColorMode();
  // The base class does this only for VTK's composite mapper.
  if (data && (attributesChanged || this->AttributesTime != data->GetMTime()))
  {
    this->PopulateBlockAttributes(this->GetMapper()->GetCompositeDataDisplayAttributes(), data);
    this->AttributesTime = data->GetMTime();
  }
  return 1;
}

void vtkAdaptiveRefinementRepresentation::GiveBounds(vtkInformation* inInfo)
{
  // These are the data of the view. In an animation they may be cached, while the pipeline is at
  // another time.
  vtkDataObject* data = this->ConvertPieces(vtkPVView::GetPiece(inInfo, this));
  this->Measure->SetRefinement(this->GetMapper()->GetRefinement());
  this->Measure->SetInputDataObject(data);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  this->PopulateBlockAttributes(attributes, data);
  this->Measure->SetCompositeDataDisplayAttributes(attributes);
  relevo::MeasureBounds(this->Measure, this->VisibleDataBounds);
  relevo::GiveBounds(inInfo, this, this->VisibleDataBounds, this->Actor);
}

void vtkAdaptiveRefinementRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
