// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that results requested between two frames describe the last frame, even if recipe, input
// and heights have changed or been deleted since. Sanitizers make this test most useful.
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkDisplacement.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRefinementPatternTable.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <sstream>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;

struct Numbers
{
  vtkIdType Triangles;
  vtkIdType CoarseFaces;
  vtkIdType CulledFaces;
  int DrawCalls;
  int UsedPatterns;

  explicit Numbers(Mapper* mapper)
    : Triangles(mapper->GetNumberOfDrawnTriangles())
    , CoarseFaces(mapper->GetNumberOfCoarseFaces())
    , CulledFaces(mapper->GetNumberOfCulledFaces())
    , DrawCalls(mapper->GetNumberOfDrawCalls())
    , UsedPatterns(mapper->GetNumberOfUsedPatterns())
  {
  }
  bool operator==(const Numbers& other) const
  {
    return this->Triangles == other.Triangles && this->CoarseFaces == other.CoarseFaces &&
      this->CulledFaces == other.CulledFaces && this->DrawCalls == other.DrawCalls &&
      this->UsedPatterns == other.UsedPatterns;
  }
};

// A scene whose results are requested only after the change. A second scene requests them before
// it.
struct Frame
{
  RelevoScene Scene{ RelevoScene::Refining };
  vtkSmartPointer<RelevoHeights> Heights = vtk::TakeSmartPointer(RelevoHeights::New());
  vtkNew<vtkDisplacement> Displacement;
  vtkSmartPointer<vtkAdaptiveRefinement> Recipe;
  Mesh Input = Torus(14, 9);

  Frame(int method, int device, bool hasHoles)
  {
    this->Heights->FillWavesWithHoles();
    this->Displacement->SetHeightMap(this->Heights);
    this->Displacement->SetScale(0.05);
    vtkNew<vtkPNTriangleSurface> surface;
    this->Recipe = MakeRecipe(3, surface, hasHoles ? this->Displacement.Get() : nullptr);
    AddTags(this->Input, 3, 3);
    this->Scene.Window->SetSize(40, 40);
    this->Scene.Add(this->Input, this->Recipe);
    this->GetMapper()->SetMethod(method);
    this->GetMapper()->SetSelectionDevice(device);
    this->Scene.ResetCameras();
    this->Scene.Renderer->GetActiveCamera()->Zoom(3.0);
    this->Scene.Render();
  }
  Mapper* GetMapper() { return this->Scene.GetMapper(0); }
};

using Change = std::function<void(Frame&)>;

struct Case
{
  const char* Name;
  Change Make;
};

void TakeRecipe(Frame& frame)
{
  frame.Recipe = nullptr;
  frame.GetMapper()->SetRefinement(nullptr);
}

void AskBounds(Frame& frame)
{
  RelevoErrors errors(frame.GetMapper());
  frame.GetMapper()->GetBounds();
}

std::vector<Case> GetCases()
{
  return {
    { "another recipe",
      [](Frame& frame)
      {
        frame.Recipe = MakeRecipe(1);
        frame.GetMapper()->SetRefinement(frame.Recipe);
      } },
    { "no recipe", TakeRecipe },
    { "no recipe, bounds asked",
      [](Frame& frame)
      {
        TakeRecipe(frame);
        AskBounds(frame);
      } },
    { "a smaller input, bounds asked",
      [](Frame& frame)
      {
        frame.Input = Plane(1, 1);
        frame.GetMapper()->SetInputData(frame.Input);
        AskBounds(frame);
      } },
    { "no input",
      [](Frame& frame)
      {
        frame.Input = nullptr;
        frame.GetMapper()->RemoveAllInputs();
        frame.GetMapper()->GetBounds();
      } },
    { "changed parts of the recipe",
      [](Frame& frame)
      {
        frame.Recipe->SetDisplacement(nullptr);
        frame.Recipe->SetSurface(nullptr);
        frame.Recipe->SetMaximumLevel(1);
        vtkNew<vtkScreenEdgeDepthTagMetric> metric;
        frame.Recipe->SetMetric(metric);
      } },
    { "another pattern table", [](Frame& frame) { frame.Recipe->SetPatternTable(nullptr); } },
    { "other heights, bounds asked",
      [](Frame& frame)
      {
        frame.Heights->FillRandom(3, 2, 1);
        frame.GetMapper()->GetBounds();
      } },
    { "holes filled", [](Frame& frame) { frame.Displacement->SetNoDataPolicyToFill(); } },
  };
}

void TestCases(RelevoCheck& check, int method, int device, bool hasHoles)
{
  Frame frame(method, device, hasHoles);
  const Numbers before(frame.GetMapper());
  CHECK_GREATER(before.Triangles, 100);
  CHECK_GREATER(before.UsedPatterns, 3);
  for (const Case& change : GetCases())
  {
    Frame other(method, device, hasHoles); // requests its first count too late
    change.Make(other);
    const std::string name = std::string(change.Name) + ", method " + std::to_string(method) +
      (hasHoles ? ", with holes" : "") + (device == Mapper::SELECTION_DEVICE_GPU ? ", GPU" : "");
    if (!(Numbers(other.GetMapper()) == before))
    {
      check.Fail(__FILE__, __LINE__,
        name + ": " + std::to_string(Numbers(other.GetMapper()).Triangles) + " triangles, not " +
          std::to_string(before.Triangles));
    }
    std::ostringstream text;
    other.GetMapper()->Print(text);
    CHECK_NOT_EQUAL(text.str().find("NumberOfDrawnTriangles: " + std::to_string(before.Triangles)),
      std::string::npos);
  }
}

// A table reads other patterns that replace those in use.
void TestReadPatterns(RelevoCheck& check, const std::string& folder, int method)
{
  const std::string file = folder + "/BetweenFrames.patterns";
  Frame frame(method, Mapper::SELECTION_DEVICE_CPU, false);
  const Numbers before(frame.GetMapper());
  frame.Recipe->GetPatternTable()->SetMaximumLevel(frame.Recipe->GetMaximumLevel());
  CHECK(frame.Recipe->GetPatternTable()->Write(file.c_str()));
  Frame other(method, Mapper::SELECTION_DEVICE_CPU, false);
  CHECK(other.Recipe->GetPatternTable()->Read(file.c_str()));
  CHECK_EQUAL(Numbers(other.GetMapper()), before);
  other.Scene.Render();
  CHECK_EQUAL(Numbers(other.GetMapper()), before);
}

// Nested patterns belong to the recipe's table, and live as long as the frame if both are deleted.
void TestMorphing(RelevoCheck& check, int device)
{
  Frame frame(Mapper::METHOD_ARKFPI, device, false);
  const auto morph = [](Frame& each)
  {
    each.Recipe->GeomorphingOn();
    each.Scene.Render();
  };
  morph(frame);
  const Numbers before(frame.GetMapper());
  CHECK_GREATER(before.Triangles, 100);
  CHECK_GREATER(before.UsedPatterns, 3);
  for (const Change& change :
    { Change(TakeRecipe), Change([](Frame& other) { other.Recipe->SetPatternTable(nullptr); }) })
  {
    Frame other(Mapper::METHOD_ARKFPI, device, false);
    morph(other);
    change(other);
    CHECK_EQUAL(Numbers(other.GetMapper()), before);
  }
}

// The next frame reports what it draws.
void TestNextFrame(RelevoCheck& check)
{
  Frame frame(Mapper::METHOD_ARKFPI, Mapper::SELECTION_DEVICE_CPU, true);
  const vtkIdType holed = frame.GetMapper()->GetNumberOfDrawnTriangles();
  frame.Displacement->SetNoDataPolicyToFill();
  frame.Scene.Render();
  const vtkIdType filled = frame.GetMapper()->GetNumberOfDrawnTriangles();
  CHECK_GREATER(filled, holed);
  frame.Displacement->SetNoDataPolicyToHole();
  frame.Scene.Render();
  CHECK_EQUAL(frame.GetMapper()->GetNumberOfDrawnTriangles(), holed);
}

// A metric's normals and spreads for one mesh are deleted when it evaluates another. The graphics
// card selects levels again from the same tags, for other patterns.
void TestMetricData(RelevoCheck& check)
{
  Frame frame(Mapper::METHOD_ARKFPI, Mapper::SELECTION_DEVICE_GPU, false);
  Frame other(Mapper::METHOD_ARKFPI, Mapper::SELECTION_DEVICE_GPU, false);
  vtkNew<vtkViewDependentDepthTagMetric> metric;
  Mesh small = Plane(1, 1);
  other.GetMapper()->SetInputData(small);
  for (Frame* each : { &frame, &other })
  {
    each->Input->GetPointData()->RemoveArray("DepthTag");
    each->Recipe->SetMetric(metric);
    each->Recipe->GeomorphingOff();
    each->Scene.Render();
  }
  const vtkIdType before = frame.GetMapper()->GetNumberOfDrawnTriangles();
  for (int mode : { vtkAdaptiveRefinement::GEOMORPHING_ON, vtkAdaptiveRefinement::GEOMORPHING_OFF })
  {
    frame.Recipe->SetGeomorphing(mode);
    frame.Scene.Render();
    other.Scene.Render();
  }
  CHECK_EQUAL(frame.GetMapper()->GetNumberOfDrawnTriangles(), before);
}
}

int TestAdaptiveRefinementMapperBetweenFrames(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoComparison comparison(check, argc, argv);
  for (int method = Mapper::METHOD_ARKFPI; method <= Mapper::METHOD_UNIFORM; ++method)
  {
    TestCases(check, method, Mapper::SELECTION_DEVICE_CPU, method == Mapper::METHOD_ARK);
    TestReadPatterns(check, comparison.GetFolder(), method);
  }
  TestCases(check, Mapper::METHOD_ARKFPI, Mapper::SELECTION_DEVICE_CPU, true);
  TestCases(check, Mapper::METHOD_ARKFPI, Mapper::SELECTION_DEVICE_GPU, true);
  TestMorphing(check, Mapper::SELECTION_DEVICE_CPU);
  TestMorphing(check, Mapper::SELECTION_DEVICE_GPU);
  TestNextFrame(check);
  TestMetricData(check);
  return check.GetResult();
}
