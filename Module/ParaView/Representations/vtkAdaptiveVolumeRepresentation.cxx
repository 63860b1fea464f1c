// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveVolumeRepresentation.h"

#include "Checks/SettingChecks.h"
#include "MapperMessages.h"
#include "MethodChoice.h"
#include "NeighbourCells.h"
#include "Parallel/ProcessReduction.h"
#include "RepresentationReports.h"
#include "ViewBounds.h"
#include "ViewRanks.h"
#include "VolumeCompositing.h"
#include "VolumePiece.h"
#include "VolumeProp.h"
#include "vtkAlgorithm.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExtractBlockUsingDataAssembly.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <string>
#include <vector>

struct vtkAdaptiveVolumeRepresentation::vtkInternals
{
  explicit vtkInternals(vtkAdaptiveVolumeRepresentation* self);

  vtkSmartPointer<vtkGPUUnstructuredGridVolumeMapper> Mapper;
  relevo::MapperMessages Messages;
  relevo::VolumePiece Pieces;
  vtkSmartPointer<vtkDataObject> Piece;
  vtkSmartPointer<vtkDataObject> WithGhosts; // the last piece that got ghost cells
  double UnitDistance = 1.0;                 // of the piece of the view
  vtkSmartPointer<vtkColorTransferFunction> ColorMap;
  vtkMTimeType ColorMapTime = 0;
  vtkSmartPointer<vtkPlane> ClippingPlane;
  vtkNew<vtkPlane> Cut; // a copy for the mapper
  std::string Warning;  // as reported
  std::string ModeWarning;

  std::shared_ptr<relevo::CompositedVolume> Volume = std::make_shared<relevo::CompositedVolume>();
  vtkSmartPointer<relevo::VolumeCompositing> Compositing; // of the view, if several ranks draw
  std::string CompositingError;                           // as reported
};

namespace
{
bool IsPolygonal(vtkDataObject* piece)
{
  const std::vector<vtkDataSet*> sets = relevo::VolumePiece::GetDataSets(piece);
  return !sets.empty() &&
    std::all_of(sets.begin(), sets.end(),
      [](vtkDataSet* set) { return vtkPolyData::SafeDownCast(set) != nullptr; });
}

// Words of the mapper and those of ParaView.
const relevo::MapperWords VolumeWords = {
  { "select an array with SelectScalarArray()", "select an array in Coloring" },
  { "Use SetScalarModeToUseCellFieldData()", "Select the cell array in Coloring" },
  { "Use SetScalarModeToUsePointFieldData()", "Select the point array in Coloring" },
  { "call SetMethodToRayCasting()", "set Method to Ray Casting" },
  relevo::CellDataWords,
  relevo::TooLargeWords,
  { "The volume property has a colour function", "The volume has a color transfer function" },
  { "The volume property has a scalar opacity function",
    "The volume has an opacity transfer function" },
  { "The volume property", "The volume" },
};

// The blend mode of ParaView's Volume that the mapper lacks.
constexpr int SliceMode = 6;

// Return whether a view has visible volumes of other representations. Layers of fragments do not
// represent them.
bool HasOtherVolumes(vtkPVRenderView* view)
{
  vtkVolumeCollection* volumes = view->GetRenderer()->GetVolumes();
  vtkCollectionSimpleIterator iterator;
  volumes->InitTraversal(iterator);
  while (vtkVolume* volume = volumes->GetNextVolume(iterator))
  {
    if (volume->GetVisibility() && !relevo::VolumeProp::SafeDownCast(volume))
    {
      return true;
    }
  }
  return false;
}

// Return whether the data are distributed.
bool HasProcesses()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1;
}
}

vtkAdaptiveVolumeRepresentation::vtkInternals::vtkInternals(vtkAdaptiveVolumeRepresentation* self)
  : Messages([self](bool isError, const std::string& message) { self->Report(isError, message); },
      VolumeWords)
{
}

vtkStandardNewMacro(vtkAdaptiveVolumeRepresentation);

vtkAdaptiveVolumeRepresentation::vtkAdaptiveVolumeRepresentation()
  : Internals(new vtkInternals(this))
{
  vtkInternals& data = *this->Internals;
  data.Volume->Prop = vtkSmartPointer<relevo::VolumeProp>::New();
  data.Volume->Prop->SetComposited(HasProcesses());
  data.Volume->Report = [this](const relevo::RankReport& report)
  { relevo::Report(this, report.IsError, report.Text); };
  this->Actor = data.Volume->Prop;
  this->Actor->SetProperty(this->Property);
  data.Piece = data.Pieces.Make(nullptr);
  vtkNew<vtkGPUUnstructuredGridVolumeMapper> mapper;
  this->SetMapper(mapper);
}

vtkAdaptiveVolumeRepresentation::~vtkAdaptiveVolumeRepresentation() = default;

void vtkAdaptiveVolumeRepresentation::SetMapper(vtkGPUUnstructuredGridVolumeMapper* mapper)
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
  this->Actor->SetMapper(mapper);
  this->Modified();
}

vtkGPUUnstructuredGridVolumeMapper* vtkAdaptiveVolumeRepresentation::GetMapper()
{
  return this->Internals->Mapper;
}

// The messages of several ranks are collected.
void vtkAdaptiveVolumeRepresentation::Report(bool isError, const std::string& message)
{
  relevo::CompositedVolume& volume = *this->Internals->Volume;
  if (volume.Prop->IsComposited())
  {
    volume.Reports.Add(isError, message);
  }
  else
  {
    relevo::Report(this, isError, message);
  }
}

void vtkAdaptiveVolumeRepresentation::SetMethod(int method)
{
  relevo::SetMethod(this, this->Method, method);
}

void vtkAdaptiveVolumeRepresentation::SetBlendMode(int mode)
{
  relevo::SetInRange(this, "BlendMode", this->BlendMode, mode, 0, SliceMode);
}

void vtkAdaptiveVolumeRepresentation::SetVectorMode(int mode)
{
  using Mapper = vtkGPUUnstructuredGridVolumeMapper;
  relevo::SetInRange(this, "VectorMode", this->VectorMode, mode, static_cast<int>(Mapper::DISABLED),
    static_cast<int>(Mapper::COMPONENT));
}

void vtkAdaptiveVolumeRepresentation::SetVectorComponent(int component)
{
  relevo::SetInRange(this, "VectorComponent", this->VectorComponent, component, 0, 3);
}

void vtkAdaptiveVolumeRepresentation::SetColor(vtkColorTransferFunction* colorMap)
{
  this->Internals->ColorMap = colorMap;
  this->Internals->ColorMapTime = 0;
  this->Modified();
}

// Like ParaView's Volume, this ignores the number of colours. A map of discrete colours would have
// a node at each step.
void vtkAdaptiveVolumeRepresentation::UpdateColors()
{
  vtkInternals& data = *this->Internals;
  const vtkMTimeType time = data.ColorMap ? data.ColorMap->GetMTime() : 0;
  if (data.ColorMapTime != time)
  {
    data.ColorMapTime = time;
    vtkNew<vtkColorTransferFunction> colors;
    colors->DeepCopy(data.ColorMap);
    this->Property->SetColor(colors);
  }
}

void vtkAdaptiveVolumeRepresentation::SetClippingPlane(vtkPlane* plane)
{
  this->Internals->ClippingPlane = plane;
  this->Modified();
}

void vtkAdaptiveVolumeRepresentation::SetShade(bool shade)
{
  if ((this->Property->GetShade() != 0) != shade)
  {
    this->Property->SetShade(shade);
    if (HasProcesses())
    {
      this->MarkModified();
    }
  }
}

void vtkAdaptiveVolumeRepresentation::SetAmbient(double value)
{
  this->Property->SetAmbient(value);
}

void vtkAdaptiveVolumeRepresentation::SetDiffuse(double value)
{
  this->Property->SetDiffuse(value);
}

void vtkAdaptiveVolumeRepresentation::SetSpecular(double value)
{
  this->Property->SetSpecular(value);
}

void vtkAdaptiveVolumeRepresentation::SetSpecularPower(double value)
{
  this->Property->SetSpecularPower(value);
}

void vtkAdaptiveVolumeRepresentation::SetNumberOfIsoSurfaceValues(int number)
{
  this->Property->GetIsoSurfaceValues()->SetNumberOfContours(number);
}

void vtkAdaptiveVolumeRepresentation::SetIsoSurfaceValue(int i, double value)
{
  this->Property->GetIsoSurfaceValues()->SetValue(i, value);
}

void vtkAdaptiveVolumeRepresentation::SetActiveAssembly(const char* name)
{
  this->Internals->Pieces.GetBlocks()->SetAssemblyName(name);
  this->MarkModified();
}

void vtkAdaptiveVolumeRepresentation::AddBlockSelector(const char* selector)
{
  this->Internals->Pieces.GetBlocks()->AddSelector(selector);
  this->MarkModified();
}

void vtkAdaptiveVolumeRepresentation::RemoveAllBlockSelectors()
{
  this->Internals->Pieces.GetBlocks()->ClearSelectors();
  this->MarkModified();
}

int vtkAdaptiveVolumeRepresentation::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkAdaptiveVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInternals& data = *this->Internals;
  const bool hasInput = inputs[0]->GetNumberOfInformationObjects() == 1;
  data.Piece = data.Pieces.Make(hasInput ? vtkDataObject::GetData(inputs[0], 0) : nullptr);
  if (this->UseSeparateOpacityArray)
  {
    this->UpdateColors(); // they have the component of the array
    this->AddOpacityArray();
  }
  return this->Superclass::RequestData(request, inputs, outputs);
}

// The base class does not check the arrays.
void vtkAdaptiveVolumeRepresentation::AddOpacityArray()
{
  bool isMissing = false;
  for (vtkDataSet* set : relevo::VolumePiece::GetDataSets(this->Internals->Piece))
  {
    vtkDataSetAttributes* arrays = set->GetAttributes(this->OpacityArrayFieldAssociation);
    vtkDataArray* opacity = arrays ? arrays->GetArray(this->OpacityArrayName.c_str()) : nullptr;
    vtkDataArray* color = this->GetInputArrayToProcess(0, set);
    if (!opacity || !color || opacity->GetNumberOfTuples() != color->GetNumberOfTuples())
    {
      isMissing = isMissing || set->GetNumberOfCells() > 0;
    }
    else
    {
      this->AppendOpacityComponent(set);
    }
  }
  if (isMissing)
  {
    this->Report(true,
      "Opacity array \"" + this->OpacityArrayName +
        "\" must be in every block with the association of the array in Coloring. Select another "
        "OpacityArrayName, or disable UseSeparateOpacityArray.");
  }
}

void vtkAdaptiveVolumeRepresentation::Update()
{
  this->Superclass::Update();
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (HasProcesses() && this->Property->GetShade())
  {
    this->AddGhostCells(controller);
  }
  relevo::VolumePiece::StoreUnitDistance(this->Internals->Piece,
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr,
    controller);
}

// Gradients at points of several pieces depend on the cells of all of them.
void vtkAdaptiveVolumeRepresentation::AddGhostCells(vtkMultiProcessController* controller)
{
  vtkInternals& data = *this->Internals;
  vtkInformation* array = this->GetInputArrayInformation(0);
  const bool isOfPoints = array->Has(vtkDataObject::FIELD_NAME()) &&
    array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const std::string name = isOfPoints ? array->Get(vtkDataObject::FIELD_NAME()) : "";
  std::vector<double> isNew = { data.Piece == data.WithGhosts ? 0.0 : 1.0 };
  relevo::ProcessReduction(controller).TakeLargest(isNew);
  if (isNew[0] > 0.0 && isOfPoints)
  {
    data.WithGhosts = relevo::AddNeighbourCells(
      data.Piece, this->UseSeparateOpacityArray ? name + "_and_opacity" : name, controller);
    data.Piece = data.WithGhosts;
  }
}

bool vtkAdaptiveVolumeRepresentation::AddToView(vtkView* view)
{
  auto renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView || !this->Superclass::AddToView(view))
  {
    return false;
  }
  renderView->GetRenderer()->AddVolume(this->Actor);
  return true;
}

bool vtkAdaptiveVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetRenderer()->RemoveVolume(this->Actor);
    this->StopCompositing(renderView);
  }
  return this->Superclass::RemoveFromView(view);
}

int vtkAdaptiveVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->GivePiece(inInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->ChooseCompositing(inInfo);
    this->PrepareFrame(inInfo);
  }
  return 1;
}

// The volume is composited if several ranks draw the view. With ParaView's volumes, ParaView blends
// the pictures of the ranks in the order of boxes of space, and this volume takes part in that.
void vtkAdaptiveVolumeRepresentation::ChooseCompositing(vtkInformation* inInfo)
{
  vtkInternals& data = *this->Internals;
  auto view = vtkPVRenderView::SafeDownCast(this->GetView());
  const bool isShared = relevo::IsDrawnByRanks(view, inInfo) && HasProcesses() &&
    !(view->GetUseOrderedCompositing() && HasOtherVolumes(view));
  data.Compositing =
    isShared ? relevo::VolumeCompositing::Install(view->GetRenderer()) : data.Compositing;
  data.Volume->Prop->SetComposited(isShared && data.Compositing);
  if (data.Volume->Prop->IsComposited())
  {
    data.Compositing->Add(data.Volume);
  }
  const std::string error = isShared && !data.Compositing
    ? "Volumes on several ranks need IceT. Enable IceT in ParaView."
    : "";
  relevo::ReportError(this, data.CompositingError, error);
}

void vtkAdaptiveVolumeRepresentation::StopCompositing(vtkPVRenderView* view)
{
  vtkInternals& data = *this->Internals;
  if (data.Compositing)
  {
    data.Compositing->Remove(data.Volume, view->GetRenderer());
    data.Compositing = nullptr;
  }
}

void vtkAdaptiveVolumeRepresentation::GivePiece(vtkInformation* inInfo)
{
  vtkInternals& data = *this->Internals;
  vtkPVView::SetPiece(inInfo, this, data.Piece);
  vtkPVRenderView::SetDeliverToClientAndRenderingProcesses(inInfo, this, false, false);
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  const bool isMoved = HasOtherVolumes(vtkPVRenderView::SafeDownCast(this->GetView()));
  vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
    (isMoved ? vtkPVRenderView::DATA_IS_REDISTRIBUTABLE : 0) |
      vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  vtkPVRenderView::SetRedistributionModeToSplitBoundaryCells(inInfo, this);

  // These are the data of the view. In an animation they may be cached, while the pipeline is at
  // another time.
  vtkDataObject* piece = vtkPVView::GetPiece(inInfo, this);
  data.UnitDistance = relevo::VolumePiece::GetUnitDistance(piece);
  relevo::VolumePiece::GetBox(piece).GetBounds(this->DataBounds);
  relevo::GiveBounds(inInfo, this, this->DataBounds, this->Actor);
}

void vtkAdaptiveVolumeRepresentation::PrepareFrame(vtkInformation* inInfo)
{
  vtkInternals& data = *this->Internals;
  vtkDataObject* piece = vtkPVView::GetDeliveredPiece(inInfo, this);
  data.Mapper->SetInputDataObject(piece);

  vtkInformation* array = this->GetInputArrayInformation(0);
  const char* const name =
    array->Has(vtkDataObject::FIELD_NAME()) ? array->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  const int association = array->Has(vtkDataObject::FIELD_ASSOCIATION())
    ? array->Get(vtkDataObject::FIELD_ASSOCIATION())
    : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const std::string selected = name ? name : "";
  this->Actor->SetVisibility(!selected.empty());
  const std::string warning = !selected.empty() ? ""
    : IsPolygonal(piece)                        ? "The input has no 3D cells."
                         : "No array is selected. Select one in Coloring to draw the volume.";
  relevo::ReportWarning(this, data.Warning, warning);
  if (association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    data.Mapper->SetScalarModeToUseCellFieldData();
  }
  else
  {
    data.Mapper->SetScalarModeToUsePointFieldData();
  }
  const std::string used = this->UseSeparateOpacityArray ? selected + "_and_opacity" : selected;
  data.Mapper->SelectScalarArray(used.c_str());
  this->UpdateColors();
  this->Property->SetIndependentComponents(
    this->MapScalars && !this->MultiComponentsMapping && !this->UseSeparateOpacityArray);
  data.Volume->NumberOfComponents =
    relevo::VolumePiece::GetNumberOfComponents(piece, association, used);
  this->ChooseVectorMode();
  this->ChooseModes();

  const bool isDefault = this->ScalarOpacityUnitDistance == this->DefaultScalarOpacityUnitDistance;
  this->Property->SetScalarOpacityUnitDistance(
    isDefault ? data.UnitDistance : this->ScalarOpacityUnitDistance);

  data.Mapper->RemoveAllClippingPlanes();
  if (data.ClippingPlane)
  {
    data.Cut->SetOrigin(data.ClippingPlane->GetOrigin());
    data.Cut->SetNormal(data.ClippingPlane->GetNormal());
    data.Mapper->AddClippingPlane(data.Cut);
  }
}

void vtkAdaptiveVolumeRepresentation::ChooseModes()
{
  vtkInternals& data = *this->Internals;
  using Mapper = vtkGPUUnstructuredGridVolumeMapper;
  data.Mapper->SetMethod(
    relevo::IsCellProjection(this->Method) ? Mapper::CELL_PROJECTION : Mapper::RAY_CASTING);
  const bool isSlice = this->BlendMode == SliceMode;
  data.Mapper->SetBlendMode(isSlice ? static_cast<int>(Mapper::COMPOSITE_BLEND) : this->BlendMode);
  const std::string warning =
    isSlice ? "The BlendMode Slice is not available for Adaptive Volume. Composite is used." : "";
  relevo::ReportWarning(this, data.ModeWarning, warning);
}

// The magnitude of a single component would be its absolute value.
void vtkAdaptiveVolumeRepresentation::ChooseVectorMode()
{
  using Mapper = vtkGPUUnstructuredGridVolumeMapper;
  int mode = this->VectorMode;
  int component = this->VectorComponent;
  if (!this->Property->GetIndependentComponents())
  {
    mode = Mapper::DISABLED;
  }
  else if (this->Internals->Volume->NumberOfComponents == 1)
  {
    mode = Mapper::COMPONENT;
    component = 0;
  }
  else if (mode == Mapper::DISABLED)
  {
    vtkColorTransferFunction* colors = this->Property->GetRGBTransferFunction();
    mode = colors->GetVectorMode() == vtkScalarsToColors::MAGNITUDE ? Mapper::MAGNITUDE
                                                                    : Mapper::COMPONENT;
    component = colors->GetVectorComponent();
  }
  this->Internals->Mapper->SetVectorMode(mode);
  this->Internals->Mapper->SetVectorComponent(component);
}

void vtkAdaptiveVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "VectorMode: " << this->VectorMode << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "ScalarOpacityUnitDistance: " << this->ScalarOpacityUnitDistance << "\n";
  os << indent << "DefaultScalarOpacityUnitDistance: " << this->DefaultScalarOpacityUnitDistance
     << "\n";
  os << indent << "Mapper:\n";
  this->Internals->Mapper->PrintSelf(os, indent.GetNextIndent());
}
