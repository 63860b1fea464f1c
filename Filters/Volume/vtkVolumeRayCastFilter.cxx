// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeRayCastFilter.h"

#include "Arrays/ImageExtents.h"
#include "Cells/CellCrossing.h"
#include "Cells/CellReports.h"
#include "Cells/MeshScalars.h"
#include "Cells/PointAverages.h"
#include "Cells/SharedFaces.h"
#include "Cells/VolumeCells.h"
#include "Changes/LatestTime.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Rays/Blending.h"
#include "Rays/ClippingPlanes.h"
#include "Rays/PixelRays.h"
#include "Rays/Shading.h"
#include "Tiles/PixelCells.h"
#include "Tiles/TileCaster.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
// Tiles of pixels are distributed to threads. Between batches, progress is reported.
constexpr vtkIdType NumberOfBatches = 20;
constexpr vtkIdType TilesPerBatch = 64;
}

vtkStandardNewMacro(vtkVolumeRayCastFilter);

vtkVolumeRayCastFilter::vtkVolumeRayCastFilter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

vtkVolumeRayCastFilter::~vtkVolumeRayCastFilter() = default;

int vtkVolumeRayCastFilter::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkVolumeRayCastFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  relevo::SetImageSize(information, this->ViewportSize[0], this->ViewportSize[1]);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_DOUBLE, 4);
  return 1;
}

// Requests the whole mesh.
int vtkVolumeRayCastFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  relevo::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  return 1;
}

int vtkVolumeRayCastFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!this->Camera || !this->VolumeProperty)
  {
    vtkErrorMacro("There is no " << (this->Camera ? "volume property: call SetVolumeProperty()."
                                                  : "camera: call SetCamera()."));
    return 0;
  }
  bool isCast = false;
  const auto cast = [&]
  {
    relevo::VolumeCells cells;
    relevo::TransferFunctions functions;
    if (!this->Read(vtkDataObject::GetData(inputVector[0]), cells, functions))
    {
      return;
    }
    // The headlight of a renderer.
    relevo::dvec3 forward;
    this->Camera->GetDirectionOfProjection(&forward.x);
    const relevo::Shading shading(this->VolumeProperty, functions, -forward);
    const relevo::CellCrossing crossing(cells, functions.NeedSteepness(), shading.IsOn());
    this->Cast(crossing, functions, shading, output);
    isCast = true;
  };
  if (!relevo::FitsMemory(cast))
  {
    output->Initialize();
    vtkErrorMacro("Not enough memory for the input or for " << this->ViewportSize[0] << " x "
                                                            << this->ViewportSize[1] << " pixels.");
  }
  return isCast ? 1 : 0;
}

bool vtkVolumeRayCastFilter::Read(
  vtkDataObject* input, relevo::VolumeCells& cells, relevo::TransferFunctions& functions)
{
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  const std::string name =
    wanted->Has(vtkDataObject::FIELD_NAME()) ? wanted->Get(vtkDataObject::FIELD_NAME()) : "";
  relevo::ScalarChoice choice =
    relevo::ChooseScalars(this->VolumeProperty, this->VectorMode, this->VectorComponent);
  const bool takesAll = choice.Component == relevo::ScalarChoice::All;
  std::vector<relevo::MeshScalars> meshes;
  std::string error;
  std::string leftOut;
  const relevo::ArrayRequest request = { [this](vtkDataSet* mesh, int& association)
    { return this->GetInputArrayToProcess(0, mesh, association); },
    name, wanted->Get(vtkDataObject::FIELD_ASSOCIATION()), relevo::AdviseInputArray(name),
    takesAll ? relevo::MaximumComponents : VTK_INT_MAX, "SetInputArrayToProcess()" };
  const std::string wrong = relevo::FindTypeError(input, this->GetInputPortInformation(0));
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
  }
  if (!relevo::FindMeshScalars(input, request, meshes, error, leftOut))
  {
    vtkErrorMacro("The input " << error << ".");
    return false;
  }
  const int components = meshes.empty() ? 1 : meshes.front().Array->GetNumberOfComponents();
  if (!meshes.empty() && choice.Component >= components)
  {
    vtkErrorMacro("VectorComponent is " << choice.Component << ", but the array has " << components
                                        << " components.");
    return false;
  }
  const bool showsSurfaces = this->BlendMode == ISOSURFACE_BLEND ||
    (this->BlendMode == COMPOSITE_BLEND && this->IsoSurfaces);
  const std::string averaged = showsSurfaces ? relevo::AverageAtPoints(meshes) : "";
  std::string warning;
  if (!functions.Read(this->VolumeProperty, takesAll ? components : 1, error, warning))
  {
    vtkErrorMacro("The volume property " << error << ".");
    return false;
  }
  bool hasErrors = false;
  for (const relevo::MeshScalars& mesh : meshes)
  {
    const bool areBytes = functions.AreColors() && vtkUnsignedCharArray::SafeDownCast(mesh.Array);
    choice.Scale = areBytes ? 1.0 / 255.0 : 1.0;
    for (const std::string& reason : cells.Add(mesh.Mesh, mesh.Array, mesh.AreOfCells, choice))
    {
      vtkErrorMacro(<< mesh.GetPrefix() << reason);
      hasErrors = true;
    }
  }
  cells.ConvertCurved();
  if (cells.GetCounts().GetSum().Solid == 0 && !meshes.empty())
  {
    if (!hasErrors)
    {
      vtkErrorMacro("The input has no 3D cells.");
    }
    return false;
  }
  const std::string ofProperty = warning.empty() ? warning : "The volume property " + warning + ".";
  for (const std::string& text : { leftOut, averaged, ofProperty })
  {
    if (!text.empty())
    {
      vtkWarningMacro(<< text);
    }
  }
  this->ReportBadCells(cells, meshes);
  return true;
}

void vtkVolumeRayCastFilter::ReportBadCells(
  const relevo::VolumeCells& cells, const std::vector<relevo::MeshScalars>& meshes)
{
  for (const std::string& bad : relevo::DescribeBadCells(cells.GetCounts(), meshes))
  {
    vtkWarningMacro(<< bad);
  }
  const std::string missing = relevo::DescribeMissingValues(cells.GetCounts(), meshes);
  if (!missing.empty())
  {
    vtkWarningMacro(<< missing);
  }
  if (const size_t number = relevo::CountSharedFaces(cells))
  {
    vtkWarningMacro(<< relevo::DescribeSharedFaces(number));
  }
}

void vtkVolumeRayCastFilter::ReportMissingSurfaces(const relevo::VolumeCells& cells, int component)
{
  if (cells.GetCells().empty() && !cells.HasCurvedParts())
  {
    return;
  }
  relevo::SurfaceData data = { 0.0, 0.0 };
  cells.GetRange(component, data.Low, data.High);
  const std::string missing = relevo::IsoSurfaces::DescribeMissing(this->VolumeProperty, data);
  if (!missing.empty())
  {
    vtkWarningMacro(<< missing);
  }
}

void vtkVolumeRayCastFilter::Cast(const relevo::CellCrossing& crossing,
  const relevo::TransferFunctions& functions, const relevo::Shading& shading, vtkImageData* output)
{
  const int width = this->ViewportSize[0];
  const int height = this->ViewportSize[1];
  const relevo::PixelRays rays(this->Camera, width, height);
  const relevo::ClippingPlanes planes(this->ClippingPlanes);
  const auto mode = static_cast<relevo::BlendMode>(this->BlendMode);
  const bool showSurfaces = this->IsoSurfaces || mode == relevo::BlendMode::IsoSurface;
  const relevo::IsoSurfaces surfaces =
    showSurfaces ? relevo::IsoSurfaces(this->VolumeProperty, functions) : relevo::IsoSurfaces();
  if (showSurfaces &&
    (mode == relevo::BlendMode::IsoSurface || mode == relevo::BlendMode::Composite))
  {
    this->ReportMissingSurfaces(crossing.GetCells(), surfaces.GetComponent());
  }
  const relevo::Blending blending(functions, mode, surfaces, shading);
  vtkNew<vtkDoubleArray> colors;
  colors->SetName("RGBA");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(width) * height);
  double* all = colors->GetPointer(0);
  const relevo::PixelCells pixels(crossing.GetCells(), this->Camera, width, height);
  const relevo::TileScene scene = { crossing, pixels, rays, planes, blending };
  vtkSMPThreadLocal<relevo::TileCaster> casters;
  const auto castTile = [&](int number)
  {
    const std::vector<relevo::dvec4>& seen = casters.Local().Cast(scene, number);
    const relevo::PixelCells::Tile tile = pixels.GetTile(number);
    const int columns = tile.Right - tile.Left;
    for (size_t i = 0; i < seen.size(); ++i)
    {
      const int row = tile.Bottom + static_cast<int>(i) / columns;
      const int column = tile.Left + static_cast<int>(i) % columns;
      double* color = all + 4 * (static_cast<vtkIdType>(row) * width + column);
      std::copy(&seen[i].x, &seen[i].x + 4, color);
    }
  };
  const vtkIdType tiles = pixels.GetNumberOfTiles();
  const vtkIdType batch = std::max<vtkIdType>(tiles / NumberOfBatches, TilesPerBatch);
  for (vtkIdType begin = 0; begin < tiles && !relevo::IsAborted(this); begin += batch)
  {
    this->UpdateProgress(static_cast<double>(begin) / static_cast<double>(tiles));
    vtkSMPTools::For(begin, std::min(begin + batch, tiles), 1,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType tile = first; tile < last; ++tile)
        {
          castTile(static_cast<int>(tile));
        }
      });
  }
  if (relevo::IsAborted(this))
  {
    return;
  }
  output->SetExtent(0, width - 1, 0, height - 1, 0, 0);
  output->GetPointData()->SetScalars(colors);
}

vtkCxxSetSmartPointerMacro(vtkVolumeRayCastFilter, Camera, vtkCamera);

vtkCamera* vtkVolumeRayCastFilter::GetCamera()
{
  return this->Camera;
}

vtkCxxSetSmartPointerMacro(vtkVolumeRayCastFilter, VolumeProperty, vtkVolumeProperty);

vtkVolumeProperty* vtkVolumeRayCastFilter::GetVolumeProperty()
{
  return this->VolumeProperty;
}

void vtkVolumeRayCastFilter::SetViewportSize(int width, int height)
{
  relevo::SetPixelSize(this, "ViewportSize", this->ViewportSize, width, height);
}

void vtkVolumeRayCastFilter::SetVectorMode(int mode)
{
  relevo::SetInRange(this, "VectorMode", this->VectorMode, mode, static_cast<int>(DISABLED),
    static_cast<int>(COMPONENT));
}

void vtkVolumeRayCastFilter::SetVectorComponent(int component)
{
  relevo::SetInRange(
    this, "VectorComponent", this->VectorComponent, component, 0, relevo::MaximumComponents - 1);
}

void vtkVolumeRayCastFilter::SetBlendMode(int mode)
{
  relevo::SetChoice(this, "BlendMode", this->BlendMode, mode,
    { "COMPOSITE_BLEND", "MAXIMUM_INTENSITY_BLEND", "MINIMUM_INTENSITY_BLEND",
      "AVERAGE_INTENSITY_BLEND", "ADDITIVE_BLEND", "ISOSURFACE_BLEND" });
}

void vtkVolumeRayCastFilter::AddClippingPlane(vtkPlane* plane)
{
  if (!plane)
  {
    vtkErrorMacro("Cannot add the clipping plane: it is null.");
    return;
  }
  if (!this->ClippingPlanes)
  {
    this->ClippingPlanes = vtkSmartPointer<vtkPlaneCollection>::New();
  }
  this->ClippingPlanes->AddItem(plane);
  this->Modified();
}

void vtkVolumeRayCastFilter::RemoveClippingPlane(vtkPlane* plane)
{
  if (!this->ClippingPlanes || this->ClippingPlanes->IsItemPresent(plane) == 0)
  {
    vtkErrorMacro("Cannot remove the plane: it is not one of the clipping planes.");
    return;
  }
  this->ClippingPlanes->RemoveItem(plane);
  this->Modified();
}

void vtkVolumeRayCastFilter::RemoveAllClippingPlanes()
{
  if (this->ClippingPlanes && this->ClippingPlanes->GetNumberOfItems() > 0)
  {
    this->ClippingPlanes->RemoveAllItems();
    this->Modified();
  }
}

vtkCxxSetSmartPointerMacro(vtkVolumeRayCastFilter, ClippingPlanes, vtkPlaneCollection);

void vtkVolumeRayCastFilter::SetClippingPlanes(vtkPlanes* planes)
{
  constexpr int most = 6;
  if (!planes)
  {
    return;
  }
  this->RemoveAllClippingPlanes();
  for (int i = 0; i < std::min(planes->GetNumberOfPlanes(), most); ++i)
  {
    vtkNew<vtkPlane> plane;
    planes->GetPlane(i, plane);
    this->AddClippingPlane(plane);
  }
}

vtkPlaneCollection* vtkVolumeRayCastFilter::GetClippingPlanes()
{
  return this->ClippingPlanes;
}

vtkMTimeType vtkVolumeRayCastFilter::GetMTime()
{
  vtkMTimeType time = relevo::GetLatestTime(
    this->Superclass::GetMTime(), { this->Camera, this->VolumeProperty, this->ClippingPlanes });
  for (int i = 0; this->ClippingPlanes && i < this->ClippingPlanes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, this->ClippingPlanes->GetItemAsObject(i)->GetMTime());
  }
  return time;
}

void vtkVolumeRayCastFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ViewportSize: " << this->ViewportSize[0] << " " << this->ViewportSize[1] << "\n";
  os << indent << "VectorMode: " << this->VectorMode << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "BlendMode: " << this->BlendMode << "\n";
  os << indent << "IsoSurfaces: " << (this->IsoSurfaces ? "On" : "Off") << "\n";
  os << indent << "ClippingPlanes: " << this->ClippingPlanes << "\n";
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "VolumeProperty: " << this->VolumeProperty << "\n";
}
