// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe/ProbedVolume.h"

#include "Cells/CellCrossing.h"
#include "Cells/PointAverages.h"
#include "Cells/VolumeCells.h"
#include "Rays/ClippingPlanes.h"
#include "Rays/IsoSurfaces.h"
#include "Rays/OpacityDepth.h"
#include "View/WorldView.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPlaneCollection.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

namespace relevo
{
namespace
{
// Return the flat index of a block, or -1 if the input has no blocks.
vtkIdType FindFlatIndex(vtkDataObject* input, vtkDataSet* mesh)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return -1;
  }
  const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    if (blocks->GetCurrentDataObject() == mesh)
    {
      return static_cast<vtkIdType>(blocks->GetCurrentFlatIndex());
    }
  }
  return -1;
}

bool DrawsSurfaces(const ProbeRequest& request)
{
  return request.HasSurfaces &&
    (request.Blending == BlendMode::Composite || request.Blending == BlendMode::IsoSurface);
}
}

ProbedVolume::ProbedVolume() = default;
ProbedVolume::~ProbedVolume() = default;

bool ProbedVolume::Update(const ProbeRequest& request, StageReport& report)
{
  const MapperArray& array = request.Array;
  Dependencies mesh;
  mesh.AddObject(request.Input, request.Input ? GetMeshTime(request.Input) : 0);
  mesh.Add(request.Choice.Component);
  mesh.Add(array.ScalarMode);
  mesh.Add(array.ArrayAccessMode);
  mesh.Add(array.ArrayId);
  mesh.Add(array.ArrayName);
  mesh.Add(request.Property->GetIndependentComponents());
  mesh.Add(DrawsSurfaces(request));
  if (this->KnownMesh.Update(mesh))
  {
    this->KnownFunctions.Clear();
    this->Crossing.reset();
    this->Cells.reset();
    if (request.Input && this->ReadCells(request, report))
    {
      this->Crossing = std::make_unique<CellCrossing>(*this->Cells, true, false);
      this->Crossing->BuildTree();
    }
  }
  if (!this->Crossing)
  {
    return false;
  }
  if (this->KnownFunctions.Update(
        TransferFunctions::FindDependencies(request.Property, this->NumberOfComponents)))
  {
    std::string error;
    std::string warning;
    this->HasFunctions =
      this->Functions.Read(request.Property, this->NumberOfComponents, error, warning);
    if (!this->HasFunctions)
    {
      report.Errors.push_back("The volume property " + error + ".");
    }
  }
  return this->HasFunctions;
}

bool ProbedVolume::ReadCells(const ProbeRequest& request, StageReport& report)
{
  const ScalarChoice& choice = request.Choice;
  this->Meshes.clear();
  this->Scales.clear();
  const bool takesAll = choice.Component == ScalarChoice::All;
  std::string error;
  std::string leftOut; // the mapper reports it
  if (!FindMeshScalars(
        request.Input, MakeArrayRequest(request.Array, takesAll), this->Meshes, error, leftOut))
  {
    report.Errors.push_back("The input " + error + ".");
    return false;
  }
  if (this->Meshes.empty())
  {
    return false;
  }
  if (DrawsSurfaces(request))
  {
    AverageAtPoints(this->Meshes); // the mapper reports it
  }
  const int components = this->Meshes.front().Array->GetNumberOfComponents();
  if (choice.Component >= components)
  {
    report.Errors.push_back("VectorComponent is " + std::to_string(choice.Component) +
      ", but the array has " + std::to_string(components) + " components.");
    return false;
  }
  this->NumberOfComponents = takesAll ? components : 1;
  const bool areColors = this->NumberOfComponents == MaximumComponents &&
    request.Property->GetIndependentComponents() == 0;
  this->Cells = std::make_unique<VolumeCells>();
  this->Cells->KeepSources();
  for (const MeshScalars& mesh : this->Meshes)
  {
    ScalarChoice scaled = choice;
    scaled.Scale = areColors && vtkUnsignedCharArray::SafeDownCast(mesh.Array) ? 1.0 / 255.0 : 1.0;
    this->Scales.push_back(scaled.Scale);
    for (const std::string& reason :
      this->Cells->Add(mesh.Mesh, mesh.Array, mesh.AreOfCells, scaled))
    {
      report.Errors.push_back(mesh.GetPrefix() + reason);
    }
  }
  this->Cells->ConvertCurved();
  return this->Cells->GetCounts().GetSum().Drawn > 0;
}

bool ProbedVolume::Find(const ProbeRequest& request, vtkMatrix4x4* matrix, const Ray& ray,
  double threshold, VolumeHit& hit) const
{
  const Ray clipped = ClippingPlanes(request.ClippingPlanes).Clip(ray);
  const dmat4 toWorld = MakeMatrix(matrix);
  const dmat4 toMesh = inverse(toWorld);
  const dvec3 way = dmat3(toMesh) * clipped.Direction;
  const double scale = 1.0 / length(way); // world lengths per length in the mesh
  const Ray inMesh = { dvec3(toMesh * dvec4(clipped.Origin, 1.0)), way * scale,
    clipped.Length / scale };
  this->Crossing->SetGradientTransform(transpose(dmat3(toMesh)));
  std::vector<RayPart> parts = this->Crossing->Cross(inMesh);
  for (RayPart& part : parts)
  {
    part.Begin *= scale;
    part.End *= scale;
  }
  const IsoSurfaces surfaces =
    request.HasSurfaces ? IsoSurfaces(request.Property, this->Functions) : IsoSurfaces();
  RayPosition at;
  if (!OpacityDepth(this->Functions, request.Blending, surfaces).Find(parts, threshold, at))
  {
    return false;
  }
  const RayPart& part = parts[at.Part];
  const double depth = (1.0 - at.Share) * part.Begin + at.Share * part.End;
  hit.Distance = dot(clipped.Origin - ray.Origin, ray.Direction) + depth;
  hit.Position = clipped.Origin + depth * clipped.Direction;
  hit.MeshPosition = inMesh.Origin + depth / scale * inMesh.Direction;
  size_t block = 0;
  vtkIdType cell = this->Cells->GetSource(part.Cell);
  for (; cell >= this->Meshes[block].Mesh->GetNumberOfCells(); ++block)
  {
    cell -= this->Meshes[block].Mesh->GetNumberOfCells();
  }
  hit.Mesh = this->Meshes[block].Mesh;
  hit.FlatIndex = FindFlatIndex(request.Input, hit.Mesh);
  hit.Cell = ProbedCell::Find(hit.Mesh, cell, hit.MeshPosition);
  hit.Values = this->Crossing->Evaluate(part.Cell, hit.MeshPosition);
  hit.Gradient = this->Crossing->ComputeGradients(part.Cell, hit.MeshPosition)[0];
  for (double& value : hit.Values)
  {
    value /= this->Scales[block];
  }
  return true;
}
}
