// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoCurveScene.h"

#include "RelevoCurves.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <random>

namespace
{
constexpr int NumberOfChains = 12;
constexpr int CurvesOfChain = 2;

void AddArrays(vtkUnstructuredGrid* grid, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(0.0, 1.0);
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radii");
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(share(random)));
    radii->InsertNextValue(0.02 + 0.05 * share(random));
    vectors->InsertNextTuple3(share(random), share(random), share(random));
    colors->InsertNextTuple3(255 * share(random), 255 * share(random), 255 * share(random));
  }
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Numbers");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i) / grid->GetNumberOfCells());
  }
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(values), static_cast<vtkDataArray*>(radii),
      static_cast<vtkDataArray*>(vectors), static_cast<vtkDataArray*>(colors) })
  {
    grid->GetPointData()->AddArray(array);
  }
  grid->GetCellData()->AddArray(numbers);
}
}

vtkSmartPointer<vtkUnstructuredGrid> RelevoMakeCurves(int degree, bool isLagrange, bool isRational)
{
  std::mt19937 random(static_cast<unsigned int>(degree));
  std::uniform_real_distribution<double> across(-1.0, 1.0);
  std::vector<RelevoPosition> places;
  std::vector<std::vector<vtkIdType>> cells;
  const double step = 0.7 / degree;
  const double aside = isLagrange ? 0.5 * step / degree : step; // nodes amplify it
  for (int chain = 0; chain < NumberOfChains; ++chain)
  {
    RelevoPosition place{ across(random), across(random), 0.0 };
    places.push_back(place);
    for (int curve = 0; curve < CurvesOfChain; ++curve)
    {
      std::vector<vtkIdType> points;
      for (int i = 0; i <= degree; ++i)
      {
        points.push_back(static_cast<vtkIdType>(places.size()) - 1);
        if (i < degree)
        {
          place = { place[0] + aside * across(random), place[1] + aside * across(random),
            place[2] + step };
          places.push_back(place);
        }
      }
      // VTK stores both ends first.
      points.insert(points.begin() + 1, points.back());
      points.pop_back();
      cells.push_back(points);
    }
  }
  auto grid = RelevoNewGrid(places);
  for (const std::vector<vtkIdType>& points : cells)
  {
    grid->InsertNextCell(isLagrange ? VTK_LAGRANGE_CURVE : VTK_BEZIER_CURVE,
      static_cast<vtkIdType>(points.size()), points.data());
  }
  if (isRational)
  {
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("RationalWeights");
    for (size_t i = 0; i < places.size(); ++i)
    {
      weights->InsertNextValue(1.5 + across(random));
    }
    grid->GetPointData()->SetRationalWeights(weights);
  }
  AddArrays(grid, random);
  return grid;
}

RelevoCurveScene::RelevoCurveScene(vtkDataObject* curves, int width, int height)
{
  this->Recipe->SetMaximumLevel(4);
  this->Mapper->SetInputDataObject(curves);
  this->Mapper->SetRefinement(this->Recipe);
  this->Mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(this->Mapper);
  this->Renderer->AddActor(this->Actor);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->GetCamera()->SetPosition(2.0, -4.0, 2.5);
  this->GetCamera()->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCamera();
  this->Filter->SetInputDataObject(curves);
  this->Filter->SetRefinement(this->Recipe);
  this->Filter->SetCamera(this->GetCamera());
  this->Twin->SetInputConnection(this->Filter->GetOutputPort());
}

RelevoPicture RelevoCurveScene::Draw()
{
  this->Actor->SetMapper(this->Mapper);
  this->Window->Render();
  return RelevoPicture(this->Window);
}

RelevoPicture RelevoCurveScene::DrawTwin()
{
  this->Filter->SetViewportSize(this->Window->GetSize()[0], this->Window->GetSize()[1]);
  this->Filter->SetModelToWorld(this->Actor->GetMatrix());
  this->Filter->SetRepresentation(this->Mapper->GetRepresentation());
  this->Filter->SetRadius(this->Mapper->GetRadius());
  this->Filter->SetRadiusArrayName(this->Mapper->GetRadiusArrayName());
  this->Filter->SetNumberOfSides(this->Mapper->GetNumberOfSides());
  this->Twin->vtkMapper::ShallowCopy(this->Mapper);
  this->Twin->SetInputConnection(this->Filter->GetOutputPort());
  this->Actor->SetMapper(this->Twin);
  this->Window->Render();
  const RelevoPicture picture(this->Window);
  this->Actor->SetMapper(this->Mapper);
  return picture;
}
