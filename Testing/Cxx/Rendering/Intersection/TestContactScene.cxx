// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkContactScene promises the pairs of moving actors, the boxes of their metrics, and the curves
// of vtkSurfaceIntersectionFilter.
#include "RelevoCheck.h"
#include "RelevoDisplacements.h"
#include "RelevoIntersections.h"
#include "RelevoTestMeshes.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkContactScene.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProximityDepthTagMetric.h"
#include "vtkSurfaceIntersectionFilter.h"

#include <cmath>
#include <string>

namespace
{
// An actor with a recipe without a metric.
struct RefinedActor
{
  explicit RefinedActor(vtkPolyData* mesh)
  {
    this->Mapper->SetInputData(mesh);
    this->Mapper->SetRefinement(this->Recipe);
    this->Actor->SetMapper(this->Mapper);
  }
  vtkProximityDepthTagMetric* GetMetric()
  {
    return vtkProximityDepthTagMetric::SafeDownCast(this->Recipe->GetMetric());
  }
  int GetNumberOfBoxes() { return this->GetMetric()->GetNumberOfBoxes(); }

  vtkNew<vtkAdaptiveRefinement> Recipe;
  vtkNew<vtkAdaptiveRefinementMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

bool IsBox(vtkProximityDepthTagMetric* metric, int index, const std::array<double, 6>& expected)
{
  double box[6] = { 0, 0, 0, 0, 0, 0 };
  metric->GetBox(index, box);
  bool isSame = true;
  for (int i = 0; i < 6; ++i)
  {
    isSame = isSame && std::abs(box[i] - expected[i]) < 1e-12;
  }
  return isSame;
}

// Whether a block is the filter's result for two actors, or for their recipes.
bool IsOfFilter(vtkContactScene* scene, unsigned int block, int first, int second)
{
  vtkMultiBlockDataSet* contacts = scene->GetContacts();
  vtkPolyData* curves = vtkPolyData::SafeDownCast(contacts->GetBlock(block));
  vtkNew<vtkSurfaceIntersectionFilter> filter;
  const int numbers[2] = { first, second };
  for (int i = 0; i < 2; ++i)
  {
    vtkActor* actor = scene->GetActor(numbers[i]);
    actor->ComputeMatrix();
    filter->SetMatrix(i, actor->GetMatrix());
    filter->SetInputDataObject(i, actor->GetMapper()->GetInputDataObject(0, 0));
    if (scene->GetRefinedContacts())
    {
      filter->SetRefinement(
        i, vtkAdaptiveRefinementMapper::SafeDownCast(actor->GetMapper())->GetRefinement());
    }
  }
  filter->SetTolerance(scene->GetTolerance());
  filter->Update();
  vtkDataArray* told = curves ? curves->GetFieldData()->GetArray("Actors") : nullptr;
  const std::string name = "Actors " + std::to_string(first) + " and " + std::to_string(second);
  return curves && curves->GetNumberOfCells() > 0 &&
    RelevoIsSameMesh(curves, filter->GetOutput()) && told && told->GetNumberOfValues() == 2 &&
    told->GetTuple1(0) == first && told->GetTuple1(1) == second &&
    name == contacts->GetMetaData(block)->Get(vtkCompositeDataSet::NAME());
}

void TestMotion(RelevoCheck& check)
{
  RefinedActor first(RelevoMakeBox(0, 1));
  RefinedActor second(RelevoMakeSphere(12, { { 0, 0, 0 } }, 0.5));
  RefinedActor third(RelevoMakeBox(10, 11));
  vtkNew<vtkContactScene> scene;
  scene->SetDistance(0.25);
  for (RefinedActor* actor : { &first, &second, &third })
  {
    scene->AddActor(actor->Actor);
  }
  RelevoErrors errors(scene);
  scene->Update();
  vtkMultiBlockDataSet* contacts = scene->GetContacts();
  CHECK_EQUAL(scene->GetNumberOfActors(), 3);
  CHECK_EQUAL(scene->GetActor(2), third.Actor);
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 1);
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 1);
  CHECK(contacts->GetNumberOfBlocks() == 1 && IsOfFilter(scene, 0, 0, 1));
  CHECK(first.GetMetric() != second.GetMetric() && first.GetMetric()->GetDistance() == 0.25);
  const double reach = second.Actor->GetBounds()[1];
  CHECK_EQUAL(first.GetNumberOfBoxes(), 1);
  CHECK_EQUAL(second.GetNumberOfBoxes(), 1);
  CHECK_EQUAL(third.GetNumberOfBoxes(), 0);
  for (RefinedActor* actor : { &first, &second })
  {
    const double* b = second.Actor->GetBounds();
    CHECK(IsBox(actor->GetMetric(), 0, { { 0, reach, 0, b[3], 0, b[5] } }));
  }
  // Without motion nothing changes.
  vtkMTimeType times[3] = { contacts->GetMTime(), first.GetMetric()->GetMTime(),
    second.Recipe->GetMTime() };
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 1);
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 0);
  CHECK(contacts->GetMTime() == times[0] && first.GetMetric()->GetMTime() == times[1]);
  CHECK_EQUAL(second.Recipe->GetMTime(), times[2]);
  // The second actor moves into the third, which the first does not touch. Results of actors that
  // did not move are reused.
  third.Actor->SetPosition(-9.75, -9.75, -10.5);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 3);
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 2);
  CHECK_EQUAL(contacts->GetNumberOfBlocks(), 3);
  CHECK_EQUAL(first.GetNumberOfBoxes(), 2);
  CHECK(IsOfFilter(scene, 0, 0, 1) && IsOfFilter(scene, 1, 0, 2) && IsOfFilter(scene, 2, 1, 2));
  // Every kind of motion takes effect.
  second.Actor->RotateWXYZ(33, 1, 2, 3);
  second.Actor->SetScale(1.1, 0.9, 1.0);
  vtkNew<vtkMatrix4x4> user;
  user->SetElement(0, 3, 0.125);
  second.Actor->SetUserMatrix(user);
  scene->Update();
  CHECK(scene->GetNumberOfIntersections() == 2 && IsOfFilter(scene, 0, 0, 1));
  user->SetElement(0, 3, 100.0);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 1);
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 0);
  CHECK(contacts->GetNumberOfBlocks() == 1 && IsOfFilter(scene, 0, 0, 2));
  CHECK_EQUAL(second.GetNumberOfBoxes(), 0);
  scene->SetDistance(0.5);
  scene->Update();
  CHECK(first.GetMetric()->GetDistance() == 0.5 && errors.None());
}

// The boxes intersect, but the surfaces do not. The pair stays the same when they touch.
void TestCandidatesAlone(RelevoCheck& check)
{
  RefinedActor first(RelevoMakeSphere(10, { { 0, 0, 0 } }, 1.0));
  RefinedActor second(RelevoMakeSphere(10, { { 0, 0, 0 } }, 1.0));
  second.Actor->SetPosition(1.5, 1.5, 1.5);
  vtkNew<vtkContactScene> scene;
  scene->AddActor(first.Actor);
  scene->AddActor(second.Actor);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 1);
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 1);
  CHECK_EQUAL(scene->GetContacts()->GetNumberOfBlocks(), 0);
  CHECK_EQUAL(first.GetNumberOfBoxes(), 1);
  scene->ExactContactsOff();
  second.Actor->SetPosition(0.5, 0.5, 0.5);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 0);
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 1);
  CHECK_EQUAL(scene->GetContacts()->GetNumberOfBlocks(), 0);
  scene->ExactContactsOn();
  scene->Update();
  CHECK(scene->GetNumberOfIntersections() == 1 && IsOfFilter(scene, 0, 0, 1));
  // Another input takes effect.
  auto box = RelevoMakeBox(0, 1);
  second.Mapper->SetInputData(box);
  scene->Update();
  CHECK(scene->GetNumberOfIntersections() == 1 && IsOfFilter(scene, 0, 0, 1));
  box->GetPoints()->SetPoint(0, -0.25, 0, 0);
  box->GetPoints()->Modified();
  scene->Update();
  CHECK(scene->GetNumberOfIntersections() == 1 && IsOfFilter(scene, 0, 0, 1));
}

// An actor that rests on another touches it.
void TestTouching(RelevoCheck& check)
{
  RefinedActor first(RelevoMakeBox(0, 1));
  RefinedActor second(RelevoMakeBox(0, 1));
  second.Actor->SetPosition(0.25, 0.25, 1.0);
  vtkNew<vtkContactScene> scene;
  scene->AddActor(first.Actor);
  scene->AddActor(second.Actor);
  scene->Update();
  CHECK(IsOfFilter(scene, 0, 0, 1));
  second.Actor->SetPosition(0.25, 0.25, 1.0001);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 0);
  CHECK_EQUAL(scene->GetContacts()->GetNumberOfBlocks(), 0);
}

// Custom metrics, shared recipes, other mappers, and removed actors. For contacts of refined
// surfaces, the recipes' metrics, which change with every motion, have no effect.
void TestRefinedContacts(RelevoCheck& check)
{
  RefinedActor first(RelevoMeshes::Torus());
  RefinedActor second(RelevoMakeSphere(8, { { 0, 0, 0 } }, 0.5));
  vtkNew<vtkPNTriangleSurface> surface;
  second.Recipe->SetSurface(surface);
  second.Recipe->SetMaximumLevel(5);
  second.Actor->SetPosition(1.0, 0.0, 0.55);
  vtkNew<vtkContactScene> scene;
  scene->AddActor(first.Actor);
  scene->AddActor(second.Actor);
  scene->Update();
  CHECK(IsOfFilter(scene, 0, 0, 1));
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  flat->ShallowCopy(scene->GetContacts()->GetBlock(0));
  scene->RefinedContactsOn();
  scene->SetTolerance(0.002);
  scene->Update();
  CHECK(scene->GetNumberOfIntersections() == 1 && IsOfFilter(scene, 0, 0, 1));
  CHECK(!RelevoIsSameMesh(vtkPolyData::SafeDownCast(scene->GetContacts()->GetBlock(0)), flat));
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 0);
  second.Recipe->SetMetric(vtkNew<vtkCurvatureDepthTagMetric>());
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 0);
  second.Recipe->SetDisplacement(RelevoMeshes::MakeDisplacement(nullptr, 1.0, 0.1));
  scene->Update();
  CHECK(scene->GetNumberOfIntersections() == 1 && IsOfFilter(scene, 0, 0, 1));
  second.Recipe->SetDisplacement(nullptr);
  scene->RefinedContactsOff();
  scene->Update();
  CHECK(RelevoIsSameMesh(vtkPolyData::SafeDownCast(scene->GetContacts()->GetBlock(0)), flat));
  RelevoErrors errors(scene);
  scene->SetTolerance(-1.0);
  CHECK(errors.Said("Tolerance") && scene->GetTolerance() == 0.002);
}

void TestMetrics(RelevoCheck& check)
{
  RefinedActor first(RelevoMakeBox(0, 1));
  vtkNew<vtkProximityDepthTagMetric> own;
  vtkNew<vtkCompositeDepthTagMetric> composite;
  vtkNew<vtkCurvatureDepthTagMetric> curvature;
  composite->AddMetric(curvature);
  composite->AddMetric(own);
  own->SetDistance(3.0);
  first.Recipe->SetMetric(composite);
  RefinedActor second(RelevoMakeBox(0.25, 2));
  second.Recipe->SetMetric(curvature);
  RefinedActor third(RelevoMakeBox(0.5, 3));
  third.Mapper->SetRefinement(first.Recipe);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(RelevoMakeBox(0.75, 4));
  vtkNew<vtkActor> plain;
  plain->SetMapper(mapper);
  vtkNew<vtkActor> empty;
  vtkNew<vtkContactScene> scene;
  for (vtkActor* actor :
    { first.Actor.Get(), second.Actor.Get(), third.Actor.Get(), plain.Get(), empty.Get() })
  {
    scene->AddActor(actor);
  }
  RelevoErrors errors(scene);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 6);
  CHECK_EQUAL(scene->GetContacts()->GetNumberOfBlocks(), 6);
  CHECK_EQUAL(first.Recipe->GetMetric(), composite);
  CHECK_EQUAL(second.Recipe->GetMetric(), curvature);
  // The boxes belong to all pairs except that of the second and the plain actor. The pair of the
  // first and the third occurs once.
  CHECK(own->GetNumberOfBoxes() == 5 && own->GetDistance() == 3.0);
  scene->RemoveActor(plain);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfActors(), 4);
  CHECK_EQUAL(own->GetNumberOfBoxes(), 3);
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 0);
  CHECK_EQUAL(scene->GetContacts()->GetNumberOfBlocks(), 3);
  // The numbers follow after a removal.
  scene->RemoveActor(second.Actor);
  scene->Update();
  CHECK(scene->GetContacts()->GetNumberOfBlocks() == 1 && IsOfFilter(scene, 0, 0, 1));
  scene->RemoveAllActors();
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfActors(), 0);
  CHECK_EQUAL(own->GetNumberOfBoxes(), 0);
  CHECK(scene->GetContacts()->GetNumberOfBlocks() == 0 && errors.None());
}

void TestErrors(RelevoCheck& check)
{
  RefinedActor first(RelevoMakeBox(0, 1));
  RefinedActor second(RelevoMakeBox(0.5, 2));
  vtkNew<vtkContactScene> scene;
  RelevoErrors errors(scene);
  scene->AddActor(nullptr);
  CHECK(errors.Said("Cannot add the actor: it is null."));
  scene->AddActor(first.Actor);
  scene->AddActor(first.Actor);
  CHECK(errors.Said("Cannot add the actor: it is already in the scene."));
  scene->RemoveActor(second.Actor);
  scene->SetDistance(-1.0);
  CHECK(errors.Said("Distance must be at least 0 and finite, got -1."));
  CHECK(!scene->GetActor(1) && !scene->GetActor(-1) && scene->GetNumberOfActors() == 1);
  scene->AddActor(second.Actor);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 0.0);
  matrix->SetElement(0, 3, 0.75);
  second.Actor->SetUserMatrix(matrix);
  scene->Update();
  CHECK(errors.Said("Actors 0 and 1 cannot be intersected: "));
  CHECK_EQUAL(scene->GetContacts()->GetNumberOfBlocks(), 0);
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 1);
  // The error is reported once for all motions.
  scene->Update();
  matrix->SetElement(0, 3, 0.8);
  scene->Update();
  CHECK(errors.None() && scene->GetNumberOfIntersections() == 1);
  matrix->SetElement(0, 0, std::nan(""));
  scene->Update();
  CHECK(errors.None() && scene->GetNumberOfCandidates() == 0);
  matrix->Identity();
  scene->Update();
  CHECK(errors.None() && IsOfFilter(scene, 0, 0, 1));
  // The warning is issued once for all motions.
  auto flat = RelevoMakePolygons(
    { { { 0, 0, 0 } }, { { 1, 1, 1 } }, { { 0, 1, 0.5 } } }, { { 0, 1, 2 }, { 0, 1, 1 } });
  second.Mapper->SetInputData(flat);
  scene->Update();
  CHECK(errors.Warned("Actors 0 and 1"));
  second.Actor->SetPosition(0.1, 0, 0);
  scene->Update();
  CHECK(errors.None() && scene->GetNumberOfIntersections() == 1);
  // Lines have a bounding box, but no surface.
  auto lines = RelevoMakeBox(0, 1);
  lines->SetLines(lines->GetPolys());
  lines->SetPolys(nullptr);
  second.Mapper->SetInputData(lines);
  scene->Update();
  CHECK_EQUAL(scene->GetNumberOfCandidates(), 1);
  CHECK_EQUAL(scene->GetNumberOfIntersections(), 0);
  CHECK(errors.None() && scene->GetContacts()->GetNumberOfBlocks() == 0);
}
}

int TestContactScene(int, char*[])
{
  RelevoCheck check;
  TestMotion(check);
  TestCandidatesAlone(check);
  TestTouching(check);
  TestRefinedContacts(check);
  TestMetrics(check);
  TestErrors(check);
  return check.GetResult();
}
