// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainRepresentation.h"

#include "Checks/SettingChecks.h"
#include "FrameAgreement.h"
#include "MapperMessages.h"
#include "OrderedCompositing.h"
#include "RepresentationReports.h"
#include "ViewBounds.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkStringArray.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"
#include "vtkVariant.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{
constexpr double SmallestTerrainError = 0.01;
constexpr double SmallestTerrainMemory = 4194304.0;
constexpr double LargestTerrainMemory = 1e15;
constexpr double LargestSteepness = 100.0; // of a terrain without a warning

// Words of the mapper and those of ParaView.
const relevo::MapperWords TerrainWords = {
  { "Set a larger screen-space error", "Set a larger ScreenSpaceError" },
  { "Set a larger memory limit", "Set a larger MemoryLimit" },
};

vtkDataArray* FindFieldArray(vtkDataObject* data, const char* name)
{
  return data ? data->GetFieldData()->GetArray(name) : nullptr;
}

std::string FindFieldText(vtkDataObject* data, const char* name)
{
  auto array =
    data ? vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name)) : nullptr;
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : "";
}

double FindSteepness(vtkDataObject* data)
{
  auto mesh = vtkDataSet::SafeDownCast(data);
  if (!mesh || mesh->GetNumberOfPoints() == 0)
  {
    return 0.0;
  }
  double bounds[6];
  mesh->GetBounds(bounds);
  const double width = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  return width > 0.0 ? (bounds[5] - bounds[4]) / width : 0.0;
}
}

struct vtkTerrainRepresentation::vtkInternals
{
  explicit vtkInternals(vtkTerrainRepresentation* self);

  vtkTerrainMapper* Mapper = nullptr; // the one of the base class
  vtkNew<vtkTerrainPyramid> Pyramid;
  vtkNew<vtkPolyDataMapper> Unused; // replaces the mapper where the base class sets its input
  relevo::MapperMessages Messages;
  relevo::MapperMessages PyramidMessages;
  std::array<unsigned long, 2> Tags = { { 0, 0 } }; // of the other observers of the mapper
  int Timer = -1;                                   // of the next frame
  unsigned long TimerTag = 0;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; // that has the timer
  bool IsTerrain = false;                               // the input is that of a reader
  std::array<double, 3> Offset = { { 0.0, 0.0, 0.0 } }; // of the reader
  std::array<double, 3> Position = { { 0.0, 0.0, 0.0 } };
  std::array<double, 3> Origin = { { 0.0, 0.0, 0.0 } };
  relevo::OrderedCompositing Order;
  bool IsOrdered = false;
  relevo::FrameAgreement Agreement;
  std::string Error; // those reported last
  std::string Warning;
  std::string MemoryWarning;
  std::string ExaggerationWarning;
  double Steepness = 0.0; // the height of the input divided by its width, on the first rank
};

vtkTerrainRepresentation::vtkInternals::vtkInternals(vtkTerrainRepresentation* self)
  : Messages([self](bool isError, const std::string& message)
      { relevo::Report(self, isError, message); },
      TerrainWords)
  , PyramidMessages([self](bool isError, const std::string& message)
      { relevo::Report(self, isError, message); },
      TerrainWords)
  // Clipping planes divide a translucent terrain, in the boxes that the view blends in order.
  , Agreement(self,
      [self, this](vtkMultiProcessController* ranks, vtkRenderer* renderer)
      { this->Mapper->AgreeWithProcesses(ranks, renderer, self->Actor, !this->IsOrdered); })
{
}

vtkStandardNewMacro(vtkTerrainRepresentation);

vtkTerrainRepresentation::vtkTerrainRepresentation()
  : Internals(new vtkInternals(this))
{
  // The base class would draw a decimated surface with its own mapper while the view moves.
  this->SuppressLOD = true;
  // Without these calls, vtkPVLODActor creates a shader property in each frame, and shaders are
  // rebuilt.
  this->Actor->GetShaderProperty();
  this->BackfaceActor->GetShaderProperty();
  this->Internals->PyramidMessages.Observe(this->Internals->Pyramid);
  vtkNew<vtkTerrainMapper> mapper;
  this->SetMapper(mapper);
}

vtkTerrainRepresentation::~vtkTerrainRepresentation()
{
  for (unsigned long tag : this->Internals->Tags)
  {
    this->Internals->Mapper->RemoveObserver(tag);
  }
  if (this->Internals->Interactor)
  {
    this->Internals->Interactor->RemoveObserver(this->Internals->TimerTag);
  }
}

void vtkTerrainRepresentation::SetMapper(vtkTerrainMapper* mapper)
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
  if (data.Mapper)
  {
    for (unsigned long tag : data.Tags)
    {
      data.Mapper->RemoveObserver(tag);
    }
  }
  data.Messages.Observe(mapper);
  data.Tags = { { mapper->AddObserver(
                    vtkCommand::EndEvent, this, &vtkTerrainRepresentation::ReportMemory),
    mapper->AddObserver(vtkCommand::UpdateEvent, this, &vtkTerrainRepresentation::RequestFrame) } };
  mapper->SetLookupTable(this->Mapper->GetLookupTable());
  mapper->Register(this);
  this->Mapper->UnRegister(this);
  this->Mapper = mapper;
  data.Mapper = mapper;
  this->Actor->SetMapper(mapper);
  this->BackfaceActor->SetMapper(mapper);
  this->Modified();
}

vtkTerrainMapper* vtkTerrainRepresentation::GetMapper()
{
  return this->Internals->Mapper;
}

//------------------------------------------------------------------------------
// Settings

void vtkTerrainRepresentation::SetTerrainColorMode(int mode)
{
  if (mode != COLORING && (mode < HILLSHADE || mode > RASTER))
  {
    vtkErrorMacro("TerrainColorMode must be 0 (Coloring), 4 (Hillshade), 5 (Imagery) or 6 "
                  "(Raster), got "
      << mode << ".");
    return;
  }
  if (this->TerrainColorMode != mode)
  {
    this->TerrainColorMode = mode;
    this->Modified();
  }
}

void vtkTerrainRepresentation::SetScreenSpaceError(double pixels)
{
  relevo::SetInRange(this, "ScreenSpaceError", this->ScreenSpaceError, pixels, SmallestTerrainError,
    relevo::LargestDouble);
}

void vtkTerrainRepresentation::SetInteractiveScreenSpaceError(double pixels)
{
  relevo::SetInRange(this, "InteractiveScreenSpaceError", this->InteractiveScreenSpaceError, pixels,
    SmallestTerrainError, relevo::LargestDouble);
}

void vtkTerrainRepresentation::SetMemoryLimit(double bytes)
{
  relevo::SetInRange(
    this, "MemoryLimit", this->MemoryLimit, bytes, SmallestTerrainMemory, LargestTerrainMemory);
}

void vtkTerrainRepresentation::SetLoadingMode(int mode)
{
  relevo::SetChoice(this, "LoadingMode", this->LoadingMode, mode, { "BACKGROUND", "COMPLETE" });
}

void vtkTerrainRepresentation::SetPosition(double x, double y, double z)
{
  this->Internals->Position = { { x, y, z } };
  this->ApplyPosition();
}

void vtkTerrainRepresentation::SetOrigin(double x, double y, double z)
{
  this->Internals->Origin = { { x, y, z } };
  this->ApplyPosition();
}

// A translation by the offset comes before the actor's transform.
void vtkTerrainRepresentation::ApplyPosition()
{
  const vtkInternals& data = *this->Internals;
  std::array<double, 3> position = data.Position;
  std::array<double, 3> origin = data.Origin;
  for (int axis = 0; axis < 3; ++axis)
  {
    position[axis] += data.Offset[axis];
    origin[axis] -= data.Offset[axis];
  }
  this->Superclass::SetPosition(position[0], position[1], position[2]);
  this->Superclass::SetOrigin(origin[0], origin[1], origin[2]);
}

// Without a raster, the mapper would report an error when the view asks for its bounds.
void vtkTerrainRepresentation::SetVisibility(bool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  this->Actor->SetVisibility(isVisible && this->Internals->IsTerrain);
  this->BackfaceActor->SetVisibility(
    this->BackfaceActor->GetVisibility() && this->Internals->IsTerrain);
}

void vtkTerrainRepresentation::SetSuppressLOD(bool)
{
}

void vtkTerrainRepresentation::SetArrayIdNames(const char*, const char*)
{
}

//------------------------------------------------------------------------------
// Data

int vtkTerrainRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInternals& data = *this->Internals;
  vtkDataObject* input = inputVector[0]->GetNumberOfInformationObjects() > 0
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
  const std::string name = FindFieldText(input, "FileName");
  vtkDataArray* offset = FindFieldArray(input, "Offset");
  data.Steepness = FindSteepness(input);
  data.IsTerrain = !name.empty() && offset && offset->GetNumberOfComponents() == 3;
  std::fill(data.Offset.begin(), data.Offset.end(), 0.0);
  if (data.IsTerrain)
  {
    data.Pyramid->SetFileName(name.c_str());
    offset->GetTuple(0, data.Offset.data());
  }
  this->ApplyPosition();
  this->SetVisibility(this->GetVisibility());
  const std::string error =
    input && !data.IsTerrain && input->GetNumberOfElements(vtkDataObject::POINT) > 0
    ? "Terrain draws the output of a Terrain Reader. Select another representation."
    : "";
  relevo::ReportError(this, data.Error, error);
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

bool vtkTerrainRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  // A selection would contain the numbers of triangles of a frame.
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  this->Internals->Agreement.Start(view);
  return true;
}

bool vtkTerrainRepresentation::RemoveFromView(vtkView* view)
{
  this->Internals->Agreement.Stop();
  return this->Superclass::RemoveFromView(view);
}

// The next frame shows tiles that have arrived. The timer leaves time for events of the user.
void vtkTerrainRepresentation::RequestFrame()
{
  constexpr unsigned long milliseconds = 50;
  vtkInternals& data = *this->Internals;
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  vtkRenderWindowInteractor* interactor = view ? view->GetInteractor() : nullptr;
  if (!interactor || (data.Timer >= 0 && data.Interactor == interactor))
  {
    return;
  }
  data.Interactor = interactor;
  data.TimerTag =
    interactor->AddObserver(vtkCommand::TimerEvent, this, &vtkTerrainRepresentation::RenderAgain);
  data.Timer = interactor->CreateOneShotTimer(milliseconds);
}

void vtkTerrainRepresentation::RenderAgain(vtkObject*, unsigned long, void* timer)
{
  vtkInternals& data = *this->Internals;
  if (!timer || *static_cast<int*>(timer) != data.Timer || !data.Interactor)
  {
    return;
  }
  data.Interactor->RemoveObserver(data.TimerTag);
  data.Timer = -1;
  data.Interactor->Render(); // ParaView renders the view when it observes this call
}

// A frame that has waited for its tiles is not complete if they do not fit into memory.
void vtkTerrainRepresentation::ReportMemory()
{
  vtkInternals& data = *this->Internals;
  const bool isTooSmall = data.Mapper->GetLoadingMode() == vtkTerrainMapper::COMPLETE &&
    data.IsTerrain && !data.Mapper->IsComplete() && data.Pyramid->IsErrorKnown() &&
    data.Mapper->GetScreenSpaceErrorInUse() > this->ScreenSpaceError;
  const std::string warning = isTooSmall
    ? "MemoryLimit does not suffice for a ScreenSpaceError of " +
      vtkVariant(this->ScreenSpaceError).ToString() +
      " in this view. The terrain is drawn coarser. Set a larger MemoryLimit or ScreenSpaceError."
    : "";
  relevo::ReportWarning(this, data.MemoryWarning, warning);
}

// The heights of some rasters are steep as they are.
void vtkTerrainRepresentation::ReportExaggeration()
{
  vtkInternals& data = *this->Internals;
  const double factor = data.Mapper->GetExaggeration();
  const bool isTooLarge = factor > 1.0 && factor * data.Steepness > LargestSteepness;
  const std::string warning = isTooLarge && this->GetVisibility()
    ? "With an Exaggeration of " + vtkVariant(factor).ToString() +
      ", the terrain is more than 100 times as high as wide. Set a smaller Exaggeration."
    : "";
  relevo::ReportWarning(this, data.ExaggerationWarning, warning);
}

int vtkTerrainRepresentation::ProcessViewRequest(
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
    // The raster is where the reader is.
    vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
    this->GiveBounds(inInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  return 1;
}

void vtkTerrainRepresentation::GiveBounds(vtkInformation* inInfo)
{
  vtkInternals& data = *this->Internals;
  double bounds[6];
  vtkMath::UninitializeBounds(bounds);
  if (data.IsTerrain)
  {
    this->ApplySettings(false);
    data.Mapper->GetBounds(bounds);
    this->ReportExaggeration();
  }
  relevo::GiveBounds(inInfo, this, bounds, this->Actor);
  relevo::OrderedCompositing::GiveSpace(
    inInfo, this, data.IsTerrain ? this->Actor->GetBounds() : bounds);
}

int vtkTerrainRepresentation::RequestRender(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  vtkInternals& data = *this->Internals;
  // The base class would set the delivered mesh as the input of its mapper.
  vtkMapper* mapper = this->Mapper;
  this->Mapper = data.Unused;
  const int result = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
  this->Mapper = mapper;
  if (!result)
  {
    return 0;
  }
  this->SetVisibility(true); // the base class may show the back faces
  if (auto view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW())))
  {
    this->ApplySettings(view->GetRenderWindow()->GetDesiredUpdateRate() >= 1.0);
    data.IsOrdered = data.Order.UpdateRegions(view);
    data.Order.Clip(mapper);
  }
  return 1;
}

// The array in Coloring, as a mode of the mapper.
int vtkTerrainRepresentation::FindColorMode()
{
  if (this->TerrainColorMode != COLORING)
  {
    return this->TerrainColorMode;
  }
  const char* array = this->GetColorArrayName();
  const std::string name = array ? array : "";
  const int mode = name == "Height" ? vtkTerrainMapper::COLOR_BY_ELEVATION
    : name == "Slope"               ? vtkTerrainMapper::COLOR_BY_SLOPE
    : name == "Aspect"              ? vtkTerrainMapper::COLOR_BY_ASPECT
                                    : vtkTerrainMapper::COLOR_SOLID;
  const std::string warning = name.empty() || mode != vtkTerrainMapper::COLOR_SOLID
    ? ""
    : "The array " + name +
      " in Coloring is not drawn. Terrain draws Height, Slope and Aspect. Select one of them.";
  relevo::ReportWarning(this, this->Internals->Warning, warning);
  return mode;
}

void vtkTerrainRepresentation::ApplySettings(bool isInteractive)
{
  vtkInternals& data = *this->Internals;
  data.Mapper->SetPyramid(data.IsTerrain ? data.Pyramid.Get() : nullptr);
  data.Mapper->SetTerrainColorMode(this->FindColorMode());
  data.Mapper->SetScreenSpaceError(isInteractive
      ? std::max(this->ScreenSpaceError, this->InteractiveScreenSpaceError)
      : this->ScreenSpaceError);
  data.Mapper->SetMemoryLimit(static_cast<vtkTypeInt64>(this->MemoryLimit));
  data.Mapper->SetLoadingMode(isInteractive ? vtkTerrainMapper::BACKGROUND : this->LoadingMode);
}

void vtkTerrainRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TerrainColorMode: " << this->TerrainColorMode << "\n";
  os << indent << "ScreenSpaceError: " << this->ScreenSpaceError << "\n";
  os << indent << "InteractiveScreenSpaceError: " << this->InteractiveScreenSpaceError << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "LoadingMode: " << this->LoadingMode << "\n";
  os << indent << "Mapper:\n";
  this->Internals->Mapper->PrintSelf(os, indent.GetNextIndent());
}
