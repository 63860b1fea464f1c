// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The vertices that the GPU computes equal those of FaceHeights, bit for bit.
#include "RelevoTerrainScene.h"
#include "RelevoVertexCapture.h"

#include "Bisection/FaceHeights.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
constexpr int Segments = relevo::TerrainFace::Segments;

// The vertices of all faces relative to the painter's origin. The placement has columns along x and
// rows against y, both with unit length.
RelevoVertexCapture::Points ComputeVertices(RelevoTerrainScene& scene)
{
  const auto& placement = scene.Mapper->Settings.Placement;
  const std::vector<double>& shift =
    scene.Mapper->Painter->GetVBOs()->GetVBO("vertexMC")->GetShift();
  const double origin[2] = { shift[0] - placement.Origin[0], placement.Origin[1] - shift[1] };
  const auto originHeight = static_cast<float>(shift[2] / placement.HeightScale);
  RelevoVertexCapture::Points points;
  for (const relevo::TerrainFace& face : scene.Mapper->GetFaces())
  {
    const relevo::FaceHeights heights(face);
    for (int b = 0; b <= Segments; ++b)
    {
      for (int a = 0; a <= Segments - b; ++a)
      {
        double place[2];
        for (int axis = 0; axis < 2; ++axis)
        {
          place[axis] = std::ldexp(static_cast<double>(
                                     face.Apex[axis] + a * face.Step1[axis] + b * face.Step2[axis]),
                          face.Level) -
            origin[axis];
        }
        const float height = heights.GetHeight(a, b);
        points.insert({ { static_cast<float>(place[0]), static_cast<float>(-place[1]),
          std::isnan(height)
            ? 0.0f
            : (height - originHeight) * static_cast<float>(placement.HeightScale) } });
      }
    }
  }
  return points;
}

// The kinds of faces in a view.
struct Kinds
{
  std::set<int> Levels;
  bool HasMorphs = false;
  int NumberOfFaces = 0;
};

Kinds FindKinds(const std::vector<relevo::TerrainFace>& faces)
{
  Kinds kinds;
  for (const relevo::TerrainFace& face : faces)
  {
    kinds.Levels.insert(face.Level);
    kinds.HasMorphs = kinds.HasMorphs || (face.Morph > 0.0f && face.Morph < 1.0f);
    ++kinds.NumberOfFaces;
  }
  return kinds;
}

class View
{
public:
  explicit View(const RelevoTerrainRaster::Function& height)
    : Terrain(700, 500, height)
    , Capture(Terrain.Actor, 400000)
    , Scene(RelevoScene::Twin)
  {
    this->Scene.Renderer->AddActor(this->Terrain.Actor);
    this->Scene.Renderer->SetActiveCamera(this->Terrain.GetCamera());
  }

  void Compare(RelevoCheck& check, const std::array<double, 3>& from,
    const std::array<double, 3>& to, bool isClose = false)
  {
    this->Terrain.Look(from, to);
    if (isClose)
    {
      this->Terrain.GetCamera()->SetClippingRange(1e-4, 1000.0);
    }
    RelevoVertexCapture::Points captured = this->Capture.Capture(check, this->Scene);
    CHECK_EQUAL(this->Terrain.Mapper->Error, "");
    const RelevoVertexCapture::Points computed = ComputeVertices(this->Terrain);
    CHECK_EQUAL(captured.size(), computed.size());
    CHECK(captured == computed);
    const Kinds kinds = FindKinds(this->Terrain.Mapper->GetFaces());
    this->HasMorphs = this->HasMorphs || kinds.HasMorphs;
    this->Levels.insert(kinds.Levels.begin(), kinds.Levels.end());
  }

  RelevoTerrainScene Terrain;
  bool HasMorphs = false;
  std::set<int> Levels;

private:
  RelevoVertexCapture Capture;
  RelevoScene Scene;
};

void TestViews(RelevoCheck& check, const RelevoTerrainRaster::Function& height)
{
  View view(height);
  view.Terrain.Mapper->Tolerance = 5.0;
  for (double scale : { 1.0, 2.5 })
  {
    CHECK_CASE(scale);
    view.Terrain.Mapper->Settings.Placement.HeightScale = scale;
    view.Compare(check, { { -80.0, 600.0, 150.0 } }, { { 250.0, 250.0, 0.0 } });
    view.Compare(check, { { 350.0, 250.0, 1500.0 } }, { { 350.0, 249.0, 0.0 } });
    for (double far : { 1.0, 8.0, 40.0 })
    {
      CHECK_CASE(far);
      const double ground = static_cast<double>(RelevoHills(310, 222));
      view.Compare(
        check, { { 310.2, 222.4, ground + far } }, { { 310.2 + far, 222.4 - far, ground } });
    }
    const double ground = static_cast<double>(RelevoHills(310, 222));
    view.Compare(
      check, { { 310.0, 222.0, ground + 0.005 } }, { { 310.005, 221.995, ground } }, true);
  }
  CHECK(view.HasMorphs);
  CHECK_LESS(*view.Levels.begin(), -6);
  CHECK_GREATER(*view.Levels.rbegin(), 1);
}
}

int TestTerrainPainterHeights(int, char*[])
{
  RelevoCheck check;
  TestViews(check, RelevoHills);
  // Holes of all sizes, and samples without data.
  TestViews(check,
    [](int column, int row)
    {
      const bool isHole = column * row % 97 == 5 || std::hypot(column - 200, row - 300) < 40.0;
      return isHole ? std::nanf("") : RelevoHills(column, row);
    });
  return check.GetResult();
}
