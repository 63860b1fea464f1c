// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces of different sizes meet without gaps and overlaps.
#include "RelevoTerrainScene.h"

#include "vtkProperty.h"

#include <cmath>
#include <random>

namespace
{
constexpr int NumberOfViews = 300;

// White without lights.
class WhiteTerrain
{
public:
  WhiteTerrain()
    : Random(1)
  {
    this->Scene.Window->SetSize(200, 150);
    this->Scene.GetProperty()->LightingOff();
  }

  double Draw(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }

  // Sets a random tolerance, which gives many sizes of faces.
  void ChooseTolerance() { this->Scene.Mapper->Tolerance = std::exp2(this->Draw(-1.0, 5.0)); }

  RelevoTerrainScene Scene;

private:
  std::mt19937 Random;
};

// Views from above that show nothing but the terrain.
void LookDown(WhiteTerrain& terrain)
{
  const double x = terrain.Draw(180.0, 330.0);
  const double y = terrain.Draw(180.0, 330.0);
  const double far = std::exp2(terrain.Draw(1.0, 6.5));
  const double ground =
    static_cast<double>(RelevoHills(static_cast<int>(x), static_cast<int>(y))) + 2.0;
  terrain.ChooseTolerance();
  terrain.Scene.Look(
    { { x, y, ground + far } }, { { x + terrain.Draw(-0.5, 0.5) * far, y + 0.1 * far, ground } });
}

void TestGaps(RelevoCheck& check)
{
  WhiteTerrain terrain;
  size_t faces = 0;
  size_t gaps = 0;
  for (int i = 0; i < NumberOfViews; ++i)
  {
    LookDown(terrain);
    for (unsigned char color : terrain.Scene.Draw().Colors)
    {
      gaps += color == 255 ? 0 : 1;
    }
    faces += terrain.Scene.Mapper->GetFaces().size();
  }
  CHECK_EQUAL(gaps, 0);
  CHECK_GREATER(faces, 100 * NumberOfViews);
}

// With a translucent surface, an overlap would be brighter.
void TestOverlaps(RelevoCheck& check)
{
  WhiteTerrain terrain;
  terrain.Scene.GetProperty()->SetOpacity(0.5);
  // Views straight from above see each column once.
  terrain.Scene.GetCamera()->ParallelProjectionOn();
  size_t wrong = 0;
  for (int i = 0; i < NumberOfViews / 3; ++i)
  {
    const double x = terrain.Draw(150.0, 360.0);
    const double y = terrain.Draw(150.0, 360.0);
    terrain.ChooseTolerance();
    terrain.Scene.Look({ { x, y, 300.0 } }, { { x, y, 0.0 } });
    terrain.Scene.GetCamera()->SetViewUp(0.3, 1.0, 0.0);
    terrain.Scene.GetCamera()->SetParallelScale(std::exp2(terrain.Draw(1.0, 6.0)));
    terrain.Scene.Renderer->ResetCameraClippingRange();
    for (unsigned char color : terrain.Scene.Draw().Colors)
    {
      wrong += color >= 127 && color <= 128 ? 0 : 1;
    }
  }
  CHECK_EQUAL(wrong, 0);
}

// Towards the horizon, each column of pixels shows the terrain below and the sky above.
void TestHorizons(RelevoCheck& check)
{
  WhiteTerrain terrain;
  size_t gaps = 0;
  size_t sky = 0;
  for (int i = 0; i < NumberOfViews; ++i)
  {
    const double x = terrain.Draw(50.0, 460.0);
    const double y = terrain.Draw(50.0, 460.0);
    const double angle = terrain.Draw(0.0, 6.28);
    const double ground =
      static_cast<double>(RelevoHills(static_cast<int>(x), static_cast<int>(y)));
    terrain.ChooseTolerance();
    const double far = std::exp2(terrain.Draw(0.0, 5.0));
    terrain.Scene.Look({ { x, y, ground + 3.0 + far } },
      { { x + 10.0 * std::cos(angle), y + 10.0 * std::sin(angle), ground + far } });
    const RelevoPicture picture = terrain.Scene.Draw();
    for (int column = 0; column < picture.Size[0]; ++column)
    {
      bool isSky = false;
      for (int row = 0; row < picture.Size[1]; ++row)
      {
        const bool isGround =
          picture.Colors[3 * (static_cast<size_t>(row) * picture.Size[0] + column)] == 255;
        gaps += isGround && isSky ? 1 : 0;
        isSky = isSky || !isGround;
        sky += isGround ? 0 : 1;
      }
    }
  }
  CHECK_EQUAL(gaps, 0);
  CHECK_GREATER(sky, 100 * NumberOfViews);
}
}

int TestTerrainPainterWatertight(int, char*[])
{
  RelevoCheck check;
  TestGaps(check);
  TestOverlaps(check);
  TestHorizons(check);
  return check.GetResult();
}
