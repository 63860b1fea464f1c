// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that streaks follow the visibility and opacity of blocks and surfaces, and the sub-piece
// that is drawn.
#include "RelevoLICScene.h"
#include "RelevoPieceSource.h"

#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"

namespace
{
using namespace RelevoMeshes;

constexpr int Width = 80;
constexpr int Height = 60;

// Covers pixels from a column on, at a given depth.
Mesh MakeStrip(int firstColumn, int columns, double z)
{
  const Mesh mesh = MakePixelMesh(columns, Height, 4,
    [](double, double, double* vector)
    {
      vector[0] = 1.0;
      vector[1] = 0.5;
    });
  const double place[3] = { static_cast<double>(firstColumn), 0.0, z };
  return Moved(mesh, 1.0, place, VTK_DOUBLE);
}

// Whether the colour varies in the middle of a half, left (0) or right (1).
bool HasStreaks(const RelevoPicture& picture, int half)
{
  int low = 255;
  int high = 0;
  for (int row = 20; row < 40; ++row)
  {
    for (int column = 10 + half * Width / 2; column < 30 + half * Width / 2; ++column)
    {
      const int red = picture.Colors[3 * (static_cast<std::size_t>(row) * Width + column)];
      low = std::min(low, red);
      high = std::max(high, red);
    }
  }
  return high - low > 20;
}

RelevoPicture Draw(RelevoLICScene& scene)
{
  scene.Window->Render();
  return RelevoPicture(scene.Window);
}

// A block that reaches to the right border, and one in front of the left half.
struct Scene : public RelevoLICScene
{
  static constexpr unsigned int Back = 1;
  static constexpr unsigned int Front = 2;

  explicit Scene(int firstColumn = 0)
    : RelevoLICScene(Width, Height)
  {
    this->Data->SetBlock(0, MakeStrip(firstColumn, Width - firstColumn, 0.0));
    this->Data->SetBlock(1, MakeStrip(0, Width / 2 - 8, 10.0));
    this->Mapper = this->Add(this->Data);
    this->LookAtPixels();
  }

  vtkNew<vtkMultiBlockDataSet> Data;
  vtkAdaptiveLICMapper* Mapper;
};

using Change = std::function<void(Scene&)>;

// The picture of a mapper that has drawn nothing else.
RelevoPicture DrawAlone(const Change& change)
{
  Scene scene;
  change(scene);
  return Draw(scene);
}

// A block that is hidden and shown again takes its streaks along. Others keep theirs.
void TestVisibility(RelevoCheck& check)
{
  Scene scene;
  CHECK(HasStreaks(Draw(scene), 0));
  vtkIdType convolutions = 1;
  const auto look = [&](const Change& change, vtkIdType more)
  {
    change(scene);
    const RelevoPicture picture = Draw(scene);
    CHECK_EQUAL(picture.Colors, DrawAlone(change).Colors);
    convolutions += more;
    CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), convolutions);
    return picture;
  };
  const Change hideFront = [](Scene& s) { s.Mapper->SetBlockVisibility(Scene::Front, false); };
  const Change hideBack = [](Scene& s)
  {
    s.Mapper->SetBlockVisibility(Scene::Front, true);
    s.Mapper->SetBlockVisibility(Scene::Back, false);
  };
  const RelevoPicture back = look(hideFront, 1);
  CHECK(HasStreaks(back, 0) && HasStreaks(back, 1));
  const RelevoPicture front = look(hideBack, 1);
  CHECK(HasStreaks(front, 0) && !HasStreaks(front, 1));
  const RelevoPicture both = look([](Scene& s) { s.Mapper->RemoveBlockVisibilities(); }, 1);
  CHECK(HasStreaks(both, 0) && HasStreaks(both, 1));
  // Colours of blocks have no effect.
  scene.Mapper->SetBlockColor(Scene::Front, 1.0, 0.5, 0.5);
  scene.Render();
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), convolutions);
}

// The opaque and the translucent pass share one LIC image.
void TestOpacity(RelevoCheck& check)
{
  Scene beside(Width / 2);
  beside.Mapper->SetBlockOpacity(Scene::Front, 0.5);
  for (int frame = 0; frame < 2; ++frame)
  {
    const RelevoPicture picture = Draw(beside);
    CHECK(HasStreaks(picture, 0) && HasStreaks(picture, 1));
    CHECK_EQUAL(beside.Mapper->GetNumberOfConvolutions(), 1);
  }

  // A fully transparent block does not hide vectors behind it.
  Scene scene;
  scene.Mapper->SetBlockOpacity(Scene::Front, 0.0);
  CHECK(HasStreaks(Draw(scene), 0));
  scene.Mapper->SetBlockOpacity(Scene::Front, 1.0);
  CHECK_EQUAL(Draw(scene).Colors, DrawAlone([](Scene&) {}).Colors);
  CHECK_EQUAL(scene.Mapper->GetNumberOfConvolutions(), 2);
}

// The same for a single mesh as input.
void TestMesh(RelevoCheck& check)
{
  RelevoLICScene scene(Width, Height);
  vtkAdaptiveLICMapper* mapper = scene.Add(MakeStrip(0, Width, 0.0));
  scene.LookAtPixels();
  mapper->SetBlockVisibility(0, false);
  CHECK(!HasStreaks(Draw(scene), 0));
  mapper->SetBlockVisibility(0, true);
  CHECK(HasStreaks(Draw(scene), 0));
  scene.Actor->GetProperty()->SetOpacity(0.0);
  scene.Renderer->GetActiveCamera()->Roll(1.0);
  CHECK(!HasStreaks(Draw(scene), 0));
  scene.Actor->GetProperty()->SetOpacity(1.0);
  CHECK(HasStreaks(Draw(scene), 0));
}

// A lookup table whose left half is first transparent.
void TestTable(RelevoCheck& check)
{
  const Mesh mesh = MakeStrip(0, Width, 0.0);
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[0]));
  }
  mesh->GetPointData()->SetScalars(scalars);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 1.0, 1.0, 0.0);
  table->SetTableValue(1, 1.0, 1.0, 1.0, 1.0);
  RelevoLICScene scene(Width, Height);
  vtkAdaptiveLICMapper* mapper = scene.Add(mesh);
  mapper->SetLookupTable(table);
  mapper->SetScalarRange(0.0, Width);
  mapper->ScalarVisibilityOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  scene.LookAtPixels();
  const RelevoPicture picture = Draw(scene);
  CHECK(!HasStreaks(picture, 0) && HasStreaks(picture, 1));
  table->SetTableValue(0, 1.0, 1.0, 1.0, 1.0);
  CHECK(HasStreaks(Draw(scene), 0));
}

// A texture whose left half is first transparent.
void TestTexture(RelevoCheck& check)
{
  const Mesh mesh = MakeStrip(0, Width, 0.0);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    coordinates->InsertNextTuple2(mesh->GetPoint(i)[0] / Width, 0.5);
  }
  mesh->GetPointData()->SetTCoords(coordinates);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  image->GetPointData()->GetScalars()->Fill(255);
  image->SetScalarComponentFromDouble(0, 0, 0, 3, 0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  RelevoLICScene scene(Width, Height);
  vtkAdaptiveLICMapper* mapper = scene.Add(mesh);
  scene.Actor->SetTexture(texture);
  scene.LookAtPixels();
  const RelevoPicture picture = Draw(scene);
  CHECK(!HasStreaks(picture, 0) && HasStreaks(picture, 1));
  image->SetScalarComponentFromDouble(0, 0, 0, 3, 255);
  image->Modified();
  CHECK(HasStreaks(Draw(scene), 0));
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 2);
  Draw(scene);
  CHECK_EQUAL(mapper->GetNumberOfConvolutions(), 2);
}

void TestSubPieces(RelevoCheck& check)
{
  RelevoLICScene scene(Width, Height);
  vtkAdaptiveLICMapper* mapper = scene.Add(vtkSmartPointer<vtkMultiBlockDataSet>::New());
  // Each of two pieces covers one half of the window.
  vtkNew<RelevoPieceSource<vtkMultiBlockDataSetAlgorithm>> source;
  source->Make = [&source](vtkInformation* request)
  {
    const int piece = vtkStreamingDemandDrivenPipeline::GetUpdatePiece(request);
    source->GetOutput()->SetBlock(0, MakeStrip(piece * Width / 2, Width / 2 - 8, 0.0));
  };
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->SetNumberOfSubPieces(2);
  scene.LookAtPixels();
  for (int frame = 0; frame < 2; ++frame)
  {
    const RelevoPicture picture = Draw(scene);
    CHECK(HasStreaks(picture, 0) && HasStreaks(picture, 1));
  }
}
}

int TestAdaptiveLICMapperBlockLooks(int, char*[])
{
  RelevoCheck check;
  TestVisibility(check);
  TestOpacity(check);
  TestMesh(check);
  TestTable(check);
  TestTexture(check);
  TestSubPieces(check);
  return check.GetResult();
}
