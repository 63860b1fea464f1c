// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReliefRepresentation.h"

#include "Arrays/ImageExtents.h"
#include "Changes/Dependencies.h"
#include "FirstRank.h"
#include "MapperMessages.h"
#include "RankReports.h"
#include "RepresentationReports.h"
#include "ViewBounds.h"
#include "VolumePiece.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkExtractBlockUsingDataAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkProperty.h"
#include "vtkReliefMapper.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>
#include <vector>

struct vtkReliefRepresentation::vtkInternals
{
  explicit vtkInternals(vtkReliefRepresentation* self)
    : Messages([self](bool isError, const std::string& message) { self->Report(isError, message); })
  {
  }

  vtkNew<vtkActor> Actor;
  vtkSmartPointer<vtkReliefMapper> Mapper;
  relevo::MapperMessages Messages;
  relevo::VolumePiece Blocks;
  relevo::Dependencies Source; // of the piece
  vtkSmartPointer<vtkMultiBlockDataSet> Piece = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  bool IsMeasuring = false;
  std::vector<relevo::RankReport> Reports; // while the mapper was measured
};

namespace
{
// A single relief is drawn as a block without a name, which users do not know.
const std::string OnlyBlock = "Block 1: ";

bool IsOnlyBlock(vtkMultiBlockDataSet* piece)
{
  return piece && piece->GetNumberOfBlocks() == 1 && !piece->HasMetaData(0u);
}
}

vtkStandardNewMacro(vtkReliefRepresentation);

vtkReliefRepresentation::vtkReliefRepresentation()
  : Internals(new vtkInternals(this))
{
  vtkNew<vtkReliefMapper> mapper;
  this->SetMapper(mapper);
}

vtkReliefRepresentation::~vtkReliefRepresentation() = default;

void vtkReliefRepresentation::SetMapper(vtkReliefMapper* mapper)
{
  vtkInternals& data = *this->Internals;
  if (!mapper)
  {
    vtkErrorMacro("SetMapper() needs a mapper, but it is null.");
    return;
  }
  if (data.Mapper == mapper)
  {
    return;
  }
  data.Messages.Observe(mapper);
  data.Mapper = mapper;
  data.Actor->SetMapper(mapper);
  this->Modified();
}

vtkReliefMapper* vtkReliefRepresentation::GetMapper()
{
  return this->Internals->Mapper;
}

// A server without rendering measures the mapper, too. The process that draws reports the errors.
void vtkReliefRepresentation::Report(bool isError, std::string message)
{
  if (IsOnlyBlock(
        vtkMultiBlockDataSet::SafeDownCast(this->GetMapper()->GetInputDataObject(0, 0))) &&
    message.compare(0, OnlyBlock.size(), OnlyBlock) == 0)
  {
    message.erase(0, OnlyBlock.size());
  }
  if (this->Internals->IsMeasuring)
  {
    this->Internals->Reports.push_back({ isError, message });
  }
  else
  {
    relevo::Report(this, isError, message);
  }
}

void vtkReliefRepresentation::SetVisibility(bool visible)
{
  this->Internals->Actor->SetVisibility(visible);
  this->Superclass::SetVisibility(visible);
}

void vtkReliefRepresentation::SetPosition(double x, double y, double z)
{
  this->Internals->Actor->SetPosition(x, y, z);
}

void vtkReliefRepresentation::SetScale(double x, double y, double z)
{
  this->Internals->Actor->SetScale(x, y, z);
}

void vtkReliefRepresentation::SetOrientation(double x, double y, double z)
{
  this->Internals->Actor->SetOrientation(x, y, z);
}

void vtkReliefRepresentation::SetOrigin(double x, double y, double z)
{
  this->Internals->Actor->SetOrigin(x, y, z);
}

void vtkReliefRepresentation::SetOpacity(double value)
{
  this->Internals->Actor->GetProperty()->SetOpacity(value);
}

void vtkReliefRepresentation::SetAmbient(double value)
{
  this->Internals->Actor->GetProperty()->SetAmbient(value);
}

void vtkReliefRepresentation::SetDiffuse(double value)
{
  this->Internals->Actor->GetProperty()->SetDiffuse(value);
}

void vtkReliefRepresentation::SetSpecular(double value)
{
  this->Internals->Actor->GetProperty()->SetSpecular(value);
}

void vtkReliefRepresentation::SetSpecularPower(double value)
{
  this->Internals->Actor->GetProperty()->SetSpecularPower(value);
}

void vtkReliefRepresentation::SetSpecularColor(double red, double green, double blue)
{
  this->Internals->Actor->GetProperty()->SetSpecularColor(red, green, blue);
}

void vtkReliefRepresentation::SetPickable(int pickable)
{
  this->Internals->Actor->SetPickable(pickable);
}

void vtkReliefRepresentation::SetActiveAssembly(const char* name)
{
  this->Internals->Blocks.GetBlocks()->SetAssemblyName(name);
  this->MarkModified();
}

void vtkReliefRepresentation::AddBlockSelector(const char* selector)
{
  this->Internals->Blocks.GetBlocks()->AddSelector(selector);
  this->MarkModified();
}

void vtkReliefRepresentation::RemoveAllBlockSelectors()
{
  this->Internals->Blocks.GetBlocks()->ClearSelectors();
  this->MarkModified();
}

// ParaView sets the input of all representations of the data, and updates their information when a
// file name changes. So the executive must accept the types of all of them.
int vtkReliefRepresentation::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

// Texels are counted from the first one of the image, so a relief cannot be divided by extents. All
// ranks request the same, because filters may communicate.
int vtkReliefRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* input = inputs[0]->GetInformationObject(i);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    relevo::RequestWholeExtent(input);
  }
  return 1;
}

int vtkReliefRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const bool hasInput = inputs[0]->GetNumberOfInformationObjects() == 1 && relevo::IsFirstRank();
  this->RefreshPiece(hasInput ? vtkDataObject::GetData(inputs[0], 0) : nullptr);
  return this->Superclass::RequestData(request, inputs, outputs);
}

// Changes of a property execute the representation, too. The mapper would upload a new piece.
void vtkReliefRepresentation::RefreshPiece(vtkDataObject* input)
{
  vtkInternals& data = *this->Internals;
  relevo::Dependencies source;
  source.AddObject(input);
  source.AddObject(data.Blocks.GetBlocks());
  for (vtkDataSet* leaf : relevo::VolumePiece::GetDataSets(input))
  {
    source.AddObject(leaf);
  }
  if (!data.Source.Update(source))
  {
    return;
  }
  data.Piece = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const auto piece = data.Blocks.Make(input);
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(piece))
  {
    data.Piece = blocks;
    return;
  }
  for (vtkDataSet* leaf : relevo::VolumePiece::GetDataSets(piece)) // an image, or partitions
  {
    if (leaf->GetNumberOfPoints() > 0) // after an error there are none
    {
      data.Piece->SetBlock(data.Piece->GetNumberOfBlocks(), leaf);
    }
  }
}

bool vtkReliefRepresentation::AddToView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView || !this->Superclass::AddToView(view))
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Internals->Actor);
  return true;
}

bool vtkReliefRepresentation::RemoveFromView(vtkView* view)
{
  if (auto renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetRenderer()->RemoveActor(this->Internals->Actor);
  }
  return this->Superclass::RemoveFromView(view);
}

int vtkReliefRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->GivePiece(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->PrepareFrame(inInfo);
  }
  return 1;
}

void vtkReliefRepresentation::GivePiece(vtkInformation* inInfo, vtkInformation* outInfo)
{
  vtkInternals& data = *this->Internals;
  vtkPVView::SetPiece(inInfo, this, data.Piece);
  // These are the data of the view. In an animation they may be cached, while the pipeline is at
  // another time.
  data.Mapper->SetInputDataObject(vtkPVView::GetPiece(inInfo, this));
  data.IsMeasuring = true;
  double bounds[6];
  data.Mapper->GetBounds(bounds);
  if (data.Actor->HasTranslucentPolygonalGeometry())
  {
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
  }
  data.IsMeasuring = false;
  relevo::GiveBounds(inInfo, this, bounds, data.Actor);
}

void vtkReliefRepresentation::PrepareFrame(vtkInformation* inInfo)
{
  vtkInternals& data = *this->Internals;
  for (const relevo::RankReport& report : data.Reports)
  {
    relevo::Report(this, report.IsError, report.Text);
  }
  data.Reports.clear();
  data.Mapper->SetInputDataObject(vtkPVView::GetDeliveredPiece(inInfo, this));
}

void vtkReliefRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Internals->Mapper->PrintSelf(os, indent.GetNextIndent());
}
