// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ContactScene.h"

#include "Files/MeshReader.h"
#include "Text/PrintableText.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
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

namespace
{
using Filter = vtkSurfaceIntersectionFilter;

const double TubeRadius = 0.0015; // of the diagonal

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

vtkIdType CountCells(vtkPolyData* mesh, int contact)
{
  vtkDataArray* contacts = mesh->GetCellData()->GetArray("Contact");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < contacts->GetNumberOfTuples(); ++i)
  {
    count += contacts->GetTuple1(i) == contact;
  }
  return count;
}

// Cells without an area have none, -1.
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
  this->Filter->SetInputData(0, ReadMesh(options.Input, MeshCells::Flat, messages).Data);
  this->Filter->SetInputData(1, ReadMesh(options.Against, MeshCells::Flat, messages).Data);
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
void ContactScene::AddMeshes()
{
  const std::array<double, 3> colours[2] = { { { 0.87, 0.81, 0.70 } }, { { 0.62, 0.72, 0.84 } } };
  vtkBoundingBox box;
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Filter->GetOutputPort(2 + i));
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
    return std::to_string(CountCells(this->Filter->GetOutput(2), contact)) + " of " +
      ToPrintable(this->Options.Input) + ", " +
      std::to_string(CountCells(this->Filter->GetOutput(3), contact)) + " of " +
      ToPrintable(this->Options.Against);
  };
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
void ContactScene::Draw(vtkRenderWindow* window)
{
  window->Render();
  this->Messages.Check();
}
