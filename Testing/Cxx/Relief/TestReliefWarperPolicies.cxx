// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefWarper promises identical bits for all policies. The parallel policy follows changes of
// cameras, settings and inputs while it warps.
#include "RelevoCheck.h"
#include "RelevoWarpScenes.h"
#include "vtkReliefWarper.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <chrono>
#include <cstring>
#include <iostream>
#include <thread>

namespace
{
using relevo::ReliefProjection;

constexpr int Width = 61;
constexpr int Height = 47;

bool AreSame(vtkImageData* one, vtkImageData* other)
{
  for (const char* name : { "Color", "Depth", "Normals" })
  {
    vtkDataArray* first = one->GetPointData()->GetArray(name);
    vtkDataArray* second = other->GetPointData()->GetArray(name);
    const size_t bytes = first->GetNumberOfValues() * first->GetDataTypeSize();
    if (first->GetNumberOfValues() != second->GetNumberOfValues() ||
      std::memcmp(first->GetVoidPointer(0), second->GetVoidPointer(0), bytes) != 0)
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkImageData> MakeImage(const char* name, ReliefProjection projection)
{
  for (const RelevoWarpScene& scene : RelevoMakeWarpScenes(Width, Height))
  {
    if (scene.Name == name)
    {
      const auto image = RelevoMakeWarpRelief(scene, Width, Height, projection);
      RelevoAddWarpNormals(image);
      return image;
    }
  }
  return nullptr;
}

vtkSmartPointer<vtkCamera> MakeCamera(double x, double y)
{
  return RelevoMakeWarpCamera(Width, Height, ReliefProjection::Parallel, false, x, y);
}

// The result of a new warper.
vtkSmartPointer<vtkImageData> WarpAlone(vtkImageData* image, vtkCamera* camera)
{
  vtkNew<vtkReliefWarper> warper;
  warper->SetInputData(image);
  warper->SetCamera(camera);
  warper->Update();
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->DeepCopy(warper->GetOutput());
  return result;
}

// Waits until the worker is idle.
bool Finish(vtkReliefWarper* warper)
{
  for (int i = 0; i < 20000 && warper->GetState() != vtkReliefWarper::FINAL; ++i)
  {
    warper->Update();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return warper->GetState() == vtkReliefWarper::FINAL;
}

void TestBits(RelevoCheck& check)
{
  for (const char* name : { "waves", "ball", "steps", "holes", "single texels" })
  {
    for (ReliefProjection projection :
      { ReliefProjection::Parallel, ReliefProjection::Perspective })
    {
      const auto image = MakeImage(name, projection);
      const auto camera = RelevoMakeWarpCamera(Width, Height, projection, false, 25.0, -31.0);
      const auto expected = WarpAlone(image, camera);
      vtkNew<vtkReliefWarper> warper;
      warper->SetInputData(image);
      for (int policy : { vtkReliefWarper::MULTI_THREADED, vtkReliefWarper::ROWS_AND_COLUMNS,
             vtkReliefWarper::PARALLEL })
      {
        warper->SetPolicy(policy);
        for (int threads : { 0, 1, 2, 3, 4, 5, 6, 7, 64 })
        {
          warper->SetNumberOfThreads(threads);
          // Another view in between leaves no trace in the result.
          const int before = warper->GetNumberOfWarps();
          warper->SetCamera(MakeCamera(-5.0 * threads, 3.0));
          warper->Update();
          warper->SetCamera(camera);
          warper->Update();
          const bool isFinished = Finish(warper);
          if (!CHECK(isFinished && warper->GetNumberOfWarps() > before &&
                AreSame(warper->GetOutput(), expected)))
          {
            std::cerr << name << ", policy " << policy << ", " << threads << " threads\n";
          }
        }
      }
    }
  }
}

// Outputs that others hold are not modified, and nothing is warped twice.
void TestOutputs(RelevoCheck& check)
{
  const auto image = MakeImage("waves", ReliefProjection::Parallel);
  const auto camera = MakeCamera(5.0, 8.0);
  vtkNew<vtkReliefWarper> warper;
  warper->SetInputData(image);
  warper->SetCamera(camera);
  CHECK_EQUAL(warper->GetState(), vtkReliefWarper::INITIAL);
  CHECK_EQUAL(warper->GetWarpTime(), 0.0);
  warper->Update();
  CHECK_EQUAL(warper->GetState(), vtkReliefWarper::FINAL);
  CHECK_GREATER(warper->GetWarpTime(), 0.0);
  vtkNew<vtkImageData> held;
  held->ShallowCopy(warper->GetOutput());
  const auto expected = WarpAlone(image, camera);
  camera->SetPosition(camera->GetPosition()[0] + 9.0, 0.0, -70.0);
  warper->Update();
  CHECK(AreSame(held, expected) && !AreSame(warper->GetOutput(), expected));
  CHECK_EQUAL(warper->GetNumberOfWarps(), 2);
  camera->SetViewAngle(12.0);
  camera->Roll(30.0);
  warper->Update();
  CHECK_EQUAL(warper->GetNumberOfWarps(), 2); // the eye has not moved
  warper->SetMaximumStretch(1.0);
  warper->Update();
  CHECK_EQUAL(warper->GetNumberOfWarps(), 3);
  // Gives the same bits, but warps again so that it can be timed.
  warper->SetPolicyToRowsAndColumns();
  warper->Update();
  CHECK_EQUAL(warper->GetNumberOfWarps(), 4);
}

void TestParallel(RelevoCheck& check)
{
  const auto image = MakeImage("ball", ReliefProjection::Parallel);
  const auto camera = MakeCamera(1.0, 0.0);
  const auto first = WarpAlone(image, camera);
  vtkNew<vtkReliefWarper> warper;
  warper->SetPolicyToParallel();
  warper->SetInputData(image);
  warper->SetCamera(camera);
  warper->Update();
  CHECK(warper->GetState() == vtkReliefWarper::FINAL && AreSame(warper->GetOutput(), first));
  // The last picture stays until a new one is ready, which GetMTime() shows.
  const double x = camera->GetPosition()[0];
  camera->SetPosition(x + 20.0, 5.0, -60.0);
  const auto second = WarpAlone(image, camera);
  warper->Update();
  const vtkMTimeType asked = camera->GetMTime();
  CHECK(AreSame(warper->GetOutput(), first) && warper->GetState() != vtkReliefWarper::FINAL);
  for (int i = 0; i < 20000 && warper->GetState() == vtkReliefWarper::WARPING; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK_EQUAL(warper->GetState(), vtkReliefWarper::WAITING);
  CHECK_GREATER(warper->GetMTime(), asked);
  CHECK(AreSame(warper->GetOutput(), first));
  warper->Update();
  CHECK(warper->GetState() == vtkReliefWarper::FINAL && AreSame(warper->GetOutput(), second));
  CHECK_EQUAL(warper->GetNumberOfWarps(), 2);
  // The camera moves during warps, and values of the input change in place.
  for (int i = 0; i < 200; ++i)
  {
    camera->SetPosition(x + 0.1 * i, 5.0, -60.0);
    image->GetPointData()->GetArray("Depth")->SetComponent(Width * 20 + 25, 0, 0.01 * i);
    if (i % 10 == 0)
    {
      image->Modified();
      image->GetPointData()->GetArray("Depth")->Modified();
    }
    warper->SetMaximumStretch(2.0 + i % 3);
    warper->Update();
  }
  warper->SetMaximumStretch(8.0);
  image->GetPointData()->GetArray("Depth")->Modified();
  warper->Update();
  CHECK(Finish(warper) && AreSame(warper->GetOutput(), WarpAlone(image, camera)));
  // After a change of size, the update waits for the new picture.
  const auto flat = RelevoMakeRelief(
    9, 5, ReliefProjection::Parallel, relevo::dmat4(1.0), [](int, int) { return 1.0; });
  camera->SetPosition(x, 6.0, -61.0);
  warper->Update();
  warper->SetInputData(flat);
  warper->Update();
  CHECK_EQUAL(warper->GetOutput()->GetNumberOfPoints(), 45);
  CHECK(Finish(warper));
  // Switches to other policies and back.
  warper->SetInputData(image);
  warper->Update();
  camera->SetPosition(x, 7.0, -61.0);
  warper->Update();
  warper->SetPolicyToSequential();
  warper->Update();
  CHECK(AreSame(warper->GetOutput(), WarpAlone(image, camera)));
}

// Destroys the warper at random times, with and without its input.
void TestDestruction(RelevoCheck& check)
{
  const auto camera = MakeCamera(0.0, 10.0);
  for (int i = 0; i < 50; ++i)
  {
    auto image = MakeImage("waves", ReliefProjection::Parallel);
    vtkNew<vtkReliefWarper> warper;
    warper->SetPolicyToParallel();
    warper->SetInputData(image);
    warper->SetCamera(camera);
    warper->Update();
    camera->SetPosition(i, 20.0, -60.0);
    warper->Update();
    CHECK_EQUAL(warper->GetOutput()->GetNumberOfPoints(), Width * Height);
    if (i % 2 == 0)
    {
      warper->SetInputData(nullptr);
      image = nullptr;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(20 * i));
  }
}
}

int TestReliefWarperPolicies(int, char*[])
{
  RelevoCheck check;
  TestBits(check);
  TestOutputs(check);
  TestParallel(check);
  TestDestruction(check);
  return check.GetResult();
}
