// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves for composite input that errors of blocks are reported, that counters include all blocks,
// and that all sub-pieces are drawn.
#include "RelevoPieceSource.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkCellArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <limits>

namespace
{
using namespace RelevoMeshes;
using Mapper = vtkAdaptiveRefinementMapper;
using Blocks = vtkSmartPointer<vtkMultiBlockDataSet>;

// Stores the messages that are shown.
class Shown : public vtkOutputWindow
{
public:
  static Shown* New() { VTK_STANDARD_NEW_BODY(Shown); }
  vtkTypeMacro(Shown, vtkOutputWindow);
  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayWarningText(const char* text) override { this->Warnings.emplace_back(text); }
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

bool IsOne(const std::vector<std::string>& texts, const char* words)
{
  return texts.size() == 1 && texts[0].find(words) != std::string::npos;
}

Mesh At(double x)
{
  const double place[3] = { x, 0.0, 0.0 };
  return Moved(Plane(3, 3), 1.0, place, VTK_FLOAT);
}

Blocks MakeBlocks(const std::vector<Mesh>& meshes)
{
  auto blocks = Blocks::New();
  for (const Mesh& mesh : meshes)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), mesh);
  }
  return blocks;
}

// Without observers, errors and warnings are shown, once for all blocks.
void TestOutputWindow(RelevoCheck& check)
{
  vtkNew<Shown> shown;
  vtkOutputWindow::SetInstance(shown);
  const Blocks blocks = MakeBlocks({ At(0.0), At(2.0) });
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(blocks, MakeRecipe(1));
  scene.ResetCameras();
  scene.Render();
  CHECK(shown->Errors.empty() && shown->Warnings.empty());

  Mapper* mapper = scene.GetMapper(0);
  const vtkSmartPointer<vtkAdaptiveRefinement> recipe = mapper->GetRefinement();
  mapper->SetRefinement(nullptr);
  scene.Render();
  CHECK(IsOne(shown->Errors, "no recipe"));
  CHECK(shown->Warnings.empty());
  shown->Errors.clear();
  mapper->SetRefinement(recipe);
  scene.Render();
  CHECK(shown->Errors.empty());

  Mesh degenerate = At(4.0);
  degenerate->GetPolys()->InsertNextCell({ 0, 0, 1 });
  blocks->SetBlock(2, degenerate);
  scene.Render();
  CHECK(IsOne(shown->Warnings, "degenerate"));
  CHECK(shown->Errors.empty());
  shown->Warnings.clear();

  vtkObject::GlobalWarningDisplayOff();
  mapper->SetRefinement(nullptr);
  scene.Render();
  vtkObject::GlobalWarningDisplayOn();
  CHECK(shown->Errors.empty());

  // With an observer, they go to the observer and are not shown.
  RelevoErrors errors(mapper);
  mapper->SetRefinement(recipe);
  scene.Render();
  mapper->SetRefinement(nullptr);
  scene.Render();
  CHECK(errors.Said("no recipe"));
  CHECK(shown->Errors.empty() && shown->Warnings.empty());
  vtkOutputWindow::SetInstance(nullptr);
}

struct Counts
{
  vtkIdType Selections;
  vtkIdType BufferBuilds;
  vtkIdType ShaderBuilds;

  explicit Counts(Mapper* mapper)
    : Selections(mapper->GetNumberOfSelections())
    , BufferBuilds(mapper->GetNumberOfBufferBuilds())
    , ShaderBuilds(mapper->GetNumberOfShaderBuilds())
  {
  }
  bool operator==(const Counts& other) const
  {
    return this->Selections == other.Selections && this->BufferBuilds == other.BufferBuilds &&
      this->ShaderBuilds == other.ShaderBuilds;
  }
  bool IsAtLeast(const Counts& other) const
  {
    return this->Selections >= other.Selections && this->BufferBuilds >= other.BufferBuilds &&
      this->ShaderBuilds >= other.ShaderBuilds;
  }
};

// Blocks replace a mesh, and a mesh replaces blocks.
void TestReplaced(RelevoCheck& check, int device)
{
  const Mesh mesh = Sphere(40, 30);
  const Blocks blocks = MakeBlocks({ At(0.0), At(2.0) });
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(mesh, MakeRecipe(2));
  Mapper* mapper = scene.GetMapper(0);
  mapper->SetSelectionDevice(device);
  scene.ResetCameras();
  scene.Render();
  const vtkIdType triangles = mapper->GetNumberOfDrawnTriangles();
  const vtkTypeInt64 memory = mapper->GetGraphicsMemorySize();
  const Counts before(mapper);

  // Bounds may be requested between frames. The counters still describe the last frame.
  mapper->SetInputDataObject(blocks);
  mapper->GetBounds();
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), triangles);
  CHECK_EQUAL(Counts(mapper), before);
  scene.ResetCameras();
  scene.Render();
  RelevoScene alone(RelevoScene::Refining);
  alone.Add(blocks, MakeRecipe(2));
  Mapper* expected = alone.GetMapper(0);
  expected->SetSelectionDevice(device);
  alone.ResetCameras();
  alone.Render();
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), expected->GetNumberOfDrawnTriangles());
  CHECK_EQUAL(mapper->GetNumberOfCoarseFaces(), expected->GetNumberOfCoarseFaces());
  CHECK_EQUAL(mapper->GetNumberOfCulledFaces(), expected->GetNumberOfCulledFaces());
  CHECK_EQUAL(mapper->GetNumberOfDrawCalls(), expected->GetNumberOfDrawCalls());
  CHECK_EQUAL(mapper->GetNumberOfUsedPatterns(), expected->GetNumberOfUsedPatterns());
  CHECK_EQUAL(mapper->GetSelectionDeviceInUse(), expected->GetSelectionDeviceInUse());
  CHECK_EQUAL(mapper->GetGraphicsMemorySize(), expected->GetGraphicsMemorySize());
  CHECK_LESS(mapper->GetGraphicsMemorySize(), memory);
  const Counts after(mapper);
  CHECK(after.IsAtLeast(before) && after.Selections > before.Selections);

  // The last frame has counted a block that is removed afterwards.
  blocks->RemoveBlock(1u);
  scene.Render();
  CHECK(Counts(mapper).IsAtLeast(after));
  mapper->SetInputData(mesh);
  scene.ResetCameras();
  scene.Render();
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), triangles);
  CHECK_EQUAL(mapper->GetGraphicsMemorySize(), memory);
  CHECK(Counts(mapper).IsAtLeast(after));
}

// An input that cannot be drawn has no faces and no culled faces.
void TestFailed(RelevoCheck& check, int device)
{
  const Mesh mesh = Sphere(12, 9);
  AddTags(mesh, 2, 3);
  RelevoScene scene(RelevoScene::Refining);
  scene.Add(mesh, MakeRecipe(2));
  Mapper* mapper = scene.GetMapper(0);
  mapper->SetSelectionDevice(device);
  scene.ResetCameras();
  scene.Renderer->GetActiveCamera()->Zoom(3.0);
  scene.Render();
  CHECK_GREATER(mapper->GetNumberOfCulledFaces(), 0);
  CHECK_LESS(mapper->GetNumberOfCulledFaces(), mapper->GetNumberOfCoarseFaces());
  vtkDataArray* tags = mesh->GetPointData()->GetArray("DepthTag");
  tags->SetComponent(0, 0, std::numeric_limits<double>::quiet_NaN());
  tags->Modified();
  RelevoErrors errors(mapper);
  scene.Render();
  CHECK(errors.Said("NaN"));
  CHECK_EQUAL(mapper->GetNumberOfCulledFaces(), 0);
  CHECK_EQUAL(mapper->GetNumberOfCoarseFaces(), 0);
  CHECK_EQUAL(mapper->GetNumberOfUsedPatterns(), 0);
  CHECK_EQUAL(mapper->GetNumberOfDrawnTriangles(), 0);
}

void TestSubPieces(RelevoCheck& check, RelevoComparison& comparison)
{
  // Each piece has two blocks at separate positions.
  vtkNew<RelevoPieceSource<vtkMultiBlockDataSetAlgorithm>> source;
  source->Make = [&source](vtkInformation* request)
  {
    const int piece = vtkStreamingDemandDrivenPipeline::GetUpdatePiece(request);
    source->GetOutput()->ShallowCopy(MakeBlocks({ At(4.0 * piece), At(4.0 * piece + 2.0) }));
  };
  RelevoScene pieces(RelevoScene::Refining);
  pieces.Add(MakeBlocks({}), MakeRecipe(1));
  pieces.GetMapper(0)->SetInputConnection(source->GetOutputPort());
  pieces.GetMapper(0)->SetNumberOfSubPieces(2);
  RelevoScene whole(RelevoScene::Refining);
  whole.Add(MakeBlocks({ At(0.0), At(2.0), At(4.0), At(6.0) }), MakeRecipe(1));
  whole.ResetCameras();
  whole.Render();
  pieces.CopyCameras(whole);
  for (int frame = 0; frame < 2; ++frame)
  {
    pieces.Render();
    comparison.Compare("Blocks.SubPieces." + std::to_string(frame), {},
      RelevoPicture(pieces.Window), RelevoPicture(whole.Window));
  }
  CHECK_GREATER(RelevoPicture(whole.Window).CountForeground(), 100);
}
}

int TestAdaptiveRefinementMapperBlocks(int argc, char* argv[])
{
  RelevoCheck check;
  RelevoComparison comparison(check, argc, argv);
  TestOutputWindow(check);
  for (const int device : { Mapper::SELECTION_DEVICE_CPU, Mapper::SELECTION_DEVICE_GPU })
  {
    CHECK_CASE(device);
    TestReplaced(check, device);
    TestFailed(check, device);
  }
  TestSubPieces(check, comparison);
  return check.GetResult();
}
