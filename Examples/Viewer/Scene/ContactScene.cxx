// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ContactScene.h"

#include "Code/DataCode.h"
#include "Files/MeshReader.h"
#include "Files/ResultFile.h"
#include "Files/StepFilter.h"
#include "Scene/ViewerPatches.h"
#include "Text/PrintableText.h"

#include "vtkActor.h"
#include "vtkAdaptivePatchMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPatchSurface.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>

namespace
{
using Filter = vtkSurfaceIntersectionFilter;

const double TubeRadius = 0.0015; // relative to the diagonal

double MeasureLength(vtkPolyData* curves)
{
  double length = 0.0;
  auto lines = vtk::TakeSmartPointer(curves->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCurrentCell(size, points);
    for (vtkIdType i = 1; i < size; ++i)
    {
      double ends[2][3];
      curves->GetPoint(points[i - 1], ends[0]);
      curves->GetPoint(points[i], ends[1]);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(ends[0], ends[1]));
    }
  }
  return length;
}

double MeasureArea(vtkPolyData* overlaps)
{
  double area = 0.0;
  auto polygons = vtk::TakeSmartPointer(overlaps->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    polygons->GetCurrentCell(size, points);
    double normal[3];
    area += vtkPolygon::ComputeArea(overlaps->GetPoints(), size, points, normal);
  }
  return area;
}

vtkIdType CountComponents(vtkPolyData* curves)
{
  return curves->GetNumberOfCells() > 0
    ? static_cast<vtkIdType>(curves->GetCellData()->GetArray("ComponentId")->GetRange()[1]) + 1
    : 0;
}

// Counts the faces of curved cells, each of which may have several triangles: a face is cut, near
// or inside if one of its triangles is.
vtkIdType CountFaces(vtkPolyData* mesh, int contact)
{
  vtkDataArray* contacts = mesh->GetCellData()->GetArray("Contact");
  vtkDataArray* patches = mesh->GetCellData()->GetArray("PatchIds");
  std::set<vtkIdType> faces;
  for (vtkIdType i = 0; i < contacts->GetNumberOfTuples(); ++i)
  {
    if (contacts->GetTuple1(i) == contact)
    {
      faces.insert(patches ? static_cast<vtkIdType>(patches->GetTuple1(i)) : i);
    }
  }
  return static_cast<vtkIdType>(faces.size());
}

// Cells without area have the distance -1.
double FindLeastDistance(vtkPolyData* mesh)
{
  vtkDataArray* distances = mesh->GetCellData()->GetArray("Distance");
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; distances && i < distances->GetNumberOfTuples(); ++i)
  {
    const double distance = distances->GetTuple1(i);
    least = distance >= 0.0 ? std::min(least, distance) : least;
  }
  return least;
}

vtkSmartPointer<vtkLookupTable> MakeContactTable(const std::array<double, 3>& free)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(4);
  table->SetTableRange(-0.5, 3.5);
  table->SetTableValue(Filter::FREE, free[0], free[1], free[2]);
  table->SetTableValue(Filter::NEAR_BY, 1.0, 0.6, 0.15);
  table->SetTableValue(Filter::CUT, 0.85, 0.1, 0.1);
  table->SetTableValue(Filter::INSIDE, 0.55, 0.35, 0.6);
  return table;
}
}

//------------------------------------------------------------------------------
ContactScene::ContactScene(const ViewerOptions& options, ViewerMessages& messages)
  : ViewerScene(options, messages)
{
  messages.Observe(this->Filter, "intersecting");
  this->ReadMeshes();
  this->RefineCurvedMeshes();
  this->Filter->JoinSegmentsOn();
  if (options.ContactDistance)
  {
    this->Filter->ClassifyOn();
    this->Filter->SetContactDistance(*options.ContactDistance);
  }
  this->Filter->Update();
  messages.Check();
  this->AddMeshes();
}

//------------------------------------------------------------------------------
ContactScene::~ContactScene() = default;

//------------------------------------------------------------------------------
void ContactScene::ReadMeshes()
{
  const std::string* files[2] = { &this->Options.Input, &this->Options.Against };
  for (int i = 0; i < 2; ++i)
  {
    ResultFile file(*files[i], this->Messages);
    StepFilter unchanged({}, "");
    this->Meshes[i] = MeshReader(file, this->Messages).Read(0, unchanged, MeshCells::Curved).Data;
    this->Filter->SetInputData(i, this->Meshes[i]);
    this->Messages.Name("input " + std::to_string(i), *files[i]);
  }
}

//------------------------------------------------------------------------------
void ContactScene::RefineCurvedMeshes()
{
  const double share = 1e-4;
  double tolerance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i)
  {
    if (HasPatches(this->Meshes[i]))
    {
      this->Recipes[i] = vtkSmartPointer<vtkAdaptiveRefinement>::New();
      this->Messages.Observe(this->Recipes[i]);
      this->Recipes[i]->SetSurface(vtkNew<vtkPatchSurface>());
      this->Recipes[i]->SetMaximumLevel(7);
      this->Recipes[i]->SetMetric(vtkNew<vtkPatchErrorDepthTagMetric>());
      this->Recipes[i]->SetLevelRuleToPerEdge();
      this->Recipes[i]->SetSegmentPolicyToWholeNumbers();
      this->Filter->SetRefinement(i, this->Recipes[i]);
      tolerance = std::min(tolerance, share * this->Meshes[i]->GetLength());
      this->Filter->SetTolerance(tolerance);
    }
  }
}

//------------------------------------------------------------------------------
void ContactScene::AddMeshes()
{
  const std::array<double, 3> colours[2] = { { { 0.87, 0.81, 0.70 } }, { { 0.62, 0.72, 0.84 } } };
  vtkBoundingBox box;
  for (int i = 0; i < 2; ++i)
  {
    const auto mapper = this->MakeMapper(i);
    mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectColorArray("Contact");
    mapper->SetColorModeToMapScalars();
    mapper->SetLookupTable(MakeContactTable(colours[i]));
    mapper->UseLookupTableScalarRangeOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Messages.Observe(mapper);
    this->Renderer->AddActor(actor);
    box.AddBounds(this->Filter->GetOutput(2 + i)->GetBounds());
  }
  this->AddCurves(TubeRadius * box.GetDiagonalLength());
  double bounds[6];
  box.GetBounds(bounds);
  this->SetView(bounds);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkMapper> ContactScene::MakeMapper(int mesh)
{
  vtkSmartPointer<vtkMapper> mapper;
  if (this->Recipes[mesh])
  {
    vtkNew<vtkAdaptivePatchMapper> patches;
    patches->SetRefinement(this->Recipes[mesh]);
    mapper = patches;
  }
  else
  {
    mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  }
  mapper->SetInputConnection(this->Filter->GetOutputPort(2 + mesh));
  return mapper;
}

//------------------------------------------------------------------------------
void ContactScene::AddCurves(double radius)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(this->Filter->GetOutputPort(0));
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(8);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.05, 0.05, 0.05);
  this->Renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
void ContactScene::Report()
{
  vtkPolyData* curves = this->Filter->GetOutput(0);
  const auto count = [this](int contact)
  {
    return std::to_string(CountFaces(this->Filter->GetOutput(2), contact)) + " of " +
      ToPrintable(this->Options.Input) + ", " +
      std::to_string(CountFaces(this->Filter->GetOutput(3), contact)) + " of " +
      ToPrintable(this->Options.Against);
  };
  for (int i = 0; i < 2; ++i)
  {
    if (this->Recipes[i])
    {
      std::cout << "curved cells: "
                << ToPrintable(i == 0 ? this->Options.Input : this->Options.Against)
                << ", followed to within " << this->Filter->GetTolerance() << "\n";
    }
  }
  std::cout << "cut faces: " << count(Filter::CUT) << "\n"
            << "curves: " << CountComponents(curves) << ", length " << MeasureLength(curves) << "\n"
            << "overlap area: " << MeasureArea(this->Filter->GetOutput(1)) << std::endl;
  if (this->Options.ContactDistance)
  {
    std::cout << "near faces: " << count(Filter::NEAR_BY) << "\n"
              << "faces inside: " << count(Filter::INSIDE) << "\n"
              << "least distance: " << FindLeastDistance(this->Filter->GetOutput(2)) << std::endl;
  }
}

//------------------------------------------------------------------------------
void ContactScene::AddDataCode(SceneCode& code)
{
  const std::string* files[2] = { &this->Options.Input, &this->Options.Against };
  for (int i = 0; i < 2; ++i)
  {
    DataPreparation preparation;
    preparation.Input = *files[i];
    preparation.HasPatches = this->Recipes[i] != nullptr;
    AddSurfaceDataCode(code, preparation, this->Meshes[i], nullptr);
  }
}

//------------------------------------------------------------------------------
void ContactScene::Draw(vtkRenderWindow* window)
{
  window->Render();
  this->Messages.Check();
}
