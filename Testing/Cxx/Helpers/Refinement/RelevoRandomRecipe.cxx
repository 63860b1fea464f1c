// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoRandomRecipe.h"

#include "vtkExecutive.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>
#include <vector>

namespace RelevoRandomRecipe
{
using namespace RelevoMeshes;

Dice::Dice(unsigned int seed)
  : Engine(seed)
{
}

double Dice::Between(double low, double high)
{
  return low + (high - low) * (this->Engine() / 4294967296.0);
}

double Dice::Scale(double low, double high)
{
  return std::exp(this->Between(std::log(low), std::log(high)));
}

Point RandomPoint(Dice& dice, bool onLattice)
{
  Point point;
  for (double& x : point)
  {
    x = onLattice ? dice.Choose(3) - 1.0 : dice.Between(-1.0, 1.0);
    x = x == 0.0 && dice.Once(2) ? -0.0 : x;
  }
  if (dice.Once(100))
  {
    point[dice.Choose(3)] = dice.Once(2) ? std::numeric_limits<double>::quiet_NaN()
                                         : -std::numeric_limits<double>::infinity();
  }
  return point;
}

vtkSmartPointer<vtkFloatArray> RandomArray(
  Dice& dice, const char* name, vtkIdType size, double low, double high, int oneNaNIn)
{
  vtkSmartPointer<vtkFloatArray> array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < size; ++i)
  {
    array->InsertNextValue(dice.Once(oneNaNIn) ? std::numeric_limits<float>::quiet_NaN()
                                               : static_cast<float>(dice.Between(low, high)));
  }
  return array;
}

Mesh RandomFaces(Dice& dice)
{
  const bool onLattice = dice.Once(2);
  std::vector<Point> corners;
  for (int i = 3 + dice.Choose(6); i > 0; --i)
  {
    corners.push_back(RandomPoint(dice, onLattice));
  }
  const int numberOfCorners = static_cast<int>(corners.size());
  const bool shared = dice.Once(2);
  std::vector<Point> points;
  if (shared)
  {
    points = corners;
  }
  std::vector<Triangle> triangles;
  for (int i = 1 + dice.Choose(6); i > 0; --i)
  {
    Triangle triangle;
    for (vtkIdType& id : triangle)
    {
      id = dice.Choose(numberOfCorners);
      if (!shared)
      {
        points.push_back(corners[static_cast<size_t>(id)]);
        id = static_cast<vtkIdType>(points.size()) - 1;
      }
    }
    triangles.push_back(triangle);
  }
  return FromTriangles(points, triangles);
}

Mesh RandomMesh(Dice& dice)
{
  const double none[3] = { 0.0, 0.0, 0.0 };
  Mesh mesh = Moved(RandomFaces(dice), 1.0, none, dice.Once(3) ? VTK_DOUBLE : VTK_FLOAT);
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  vtkPointData* data = mesh->GetPointData();
  constexpr int Never = std::numeric_limits<int>::max();
  data->AddArray(RandomArray(dice, "Corner", numberOfPoints, 0.0, 1.0, Never));
  data->AddArray(RandomArray(dice, "Field", numberOfPoints, -1.0, 1.0, 20));
  if (dice.Once(3))
  {
    data->AddArray(RandomArray(dice, "DepthTag", numberOfPoints, -2.0, 6.0, 500));
  }
  AddRandomTextureCoordinates(mesh, static_cast<unsigned int>(dice.Choose(1000)));
  if (dice.Once(3))
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < numberOfPoints; ++i)
    {
      double normal[3] = { dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0),
        dice.Between(-1.0, 1.0) };
      vtkMath::Normalize(normal);
      normals->InsertNextTuple(normal);
    }
    data->SetNormals(normals);
  }
  return mesh;
}

Machine::Machine()
{
  this->Heights->FillRandom(13, 9, 1);
  this->Displacement->SetHeightMap(this->Heights);
  this->Variation->SetArrayName("Field");
  this->Region->SetCenter(0.3, 0.1, -0.2);
  this->Composite->AddMetric(this->ScreenEdge);
  this->Composite->AddMetric(this->Distance);
  this->LinearNormals->QuadraticNormalsOff();
  this->Filter->SetRefinement(this->Recipe);
  this->Filter->SetCamera(this->Camera);
  for (vtkObject* object : std::initializer_list<vtkObject*>{ this->Filter,
         this->Filter->GetExecutive(), this->ScreenEdge, this->Distance, this->Silhouette,
         this->ViewDependent, this->Region, this->Variation, this->Curvature, this->Composite })
  {
    object->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    object->AddObserver(vtkCommand::WarningEvent, this->Observer);
  }
}

void Machine::Shuffle(Dice& dice)
{
  this->ShuffleMetrics(dice);
  this->ShuffleRecipe(dice);
  this->Input = RandomMesh(dice);
  this->ShuffleCamera(dice);
  this->Filter->SetInputData(this->Input);
  this->Filter->SetViewportSize(1 + dice.Choose(2000), 1 + dice.Choose(2000));
}

bool Machine::Run()
{
  this->Observer->Clear();
  this->Filter->Update();
  return !this->Observer->GetError();
}

void Machine::ShuffleMetrics(Dice& dice)
{
  this->ScreenEdge->SetReferenceLength(dice.Scale(0.5, 500.0));
  this->Distance->SetMaximumDistance(dice.Scale(0.1, 10.0));
  this->Silhouette->SetCriterion(dice.Choose(2));
  this->ViewDependent->SetEdgeOnWeight(dice.Between(0.0, 1.0));
  this->Region->SetRadius(dice.Between(0.1, 2.0));
  this->Region->SetFallOff(dice.Between(0.0, 2.0));
  this->Composite->SetMode(dice.Choose(3));
  const std::array<vtkDepthTagMetric*, 9> metrics = { this->ScreenEdge, this->ScreenEdge,
    this->Distance, this->Silhouette, this->ViewDependent, this->Region, this->Variation,
    this->Curvature, this->Composite };
  this->Recipe->SetMetric(dice.Once(12) ? nullptr : metrics[static_cast<size_t>(dice.Choose(9))]);
}

void Machine::ShuffleRecipe(Dice& dice)
{
  this->Recipe->SetMaximumLevel(dice.Once(200) ? dice.Choose(8) : dice.Choose(5));
  this->Recipe->SetLevelRule(dice.Choose(2));
  this->Recipe->SetLevelOffset(dice.Once(2) ? 0.0 : dice.Between(-2.0, 2.0));
  this->Recipe->SetSegmentPolicy(
    dice.Once(3) ? vtkAdaptiveRefinement::WHOLE_NUMBERS : vtkAdaptiveRefinement::POWERS_OF_TWO);
  this->Recipe->SetGeomorphing(dice.Choose(3));
  const std::array<vtkRefinementSurface*, 4> surfaces = { nullptr, this->Linear, this->Quadratic,
    this->LinearNormals };
  this->Recipe->SetSurface(surfaces[static_cast<size_t>(dice.Choose(4))]);
  this->Displacement->SetScale(dice.Between(-0.5, 0.5));
  if (dice.Once(2))
  {
    this->Displacement->SetDirectionToNormal();
  }
  else
  {
    this->Displacement->SetDirection(0.3, -1.0, 2.0);
  }
  this->Recipe->SetDisplacement(dice.Once(2) ? this->Displacement.Get() : nullptr);
}

void Machine::ShuffleCamera(Dice& dice)
{
  double eye[3];
  double focus[3];
  for (int c = 0; c < 3; ++c)
  {
    eye[c] = dice.Between(-3.0, 3.0);
    focus[c] = dice.Between(-1.0, 1.0);
  }
  if (dice.Once(10)) // at a point of the mesh
  {
    this->Input->GetPoint(dice.Choose(3), eye);
  }
  this->Camera->SetPosition(eye);
  this->Camera->SetFocalPoint(dice.Once(50) ? eye : focus);
  this->Camera->SetViewUp(dice.Between(-1.0, 1.0), 1.0, dice.Between(-1.0, 1.0));
  this->Camera->SetParallelProjection(dice.Once(3));
  this->Camera->SetParallelScale(dice.Scale(0.01, 100.0));
  this->Camera->SetViewAngle(dice.Between(1.0, 170.0));
  const double nearest = dice.Scale(1e-3, 2.0);
  this->Camera->SetClippingRange(nearest, nearest * dice.Scale(1.1, 1000.0));
}
}
