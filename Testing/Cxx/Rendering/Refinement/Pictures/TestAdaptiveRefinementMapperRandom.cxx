// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random scenes equal vtkPolyDataMapper's pictures: of the input at level 0, and of the
// filter's output at level 2. RELEVO_SEEDS="first count" draws other scenes; a single scene is
// described too: RELEVO_SEEDS="17 1".
//
// At level 0 pictures are equal. At level 2 single pixels may differ: if a triangle's border or a
// colour's border passes through a pixel's centre, the last bit of a point decides. Wider
// differences are defects.
#include "RelevoRandomScene.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>

namespace
{
class Windows
{
public:
  Windows()
  {
    for (vtkRenderWindow* window : this->All)
    {
      window->OffScreenRenderingOn(); // applies a new size at once
      window->SetMultiSamples(0);
      window->SetAlphaBitPlanes(1);
    }
  }
  std::vector<vtkRenderWindow*> GetRefining() { return { this->All[0], this->All[1] }; }
  std::vector<vtkRenderWindow*> GetTwins() { return { this->All[2], this->All[3] }; }

private:
  vtkNew<vtkRenderWindow> All[4];
};

struct Difference
{
  size_t Single = 0; // pixels that equal a neighbour on at least two sides
  size_t Wide = 0;   // others
  int Largest = 0;
};

Difference Compare(const RelevoPicture& a, const RelevoPicture& b, int tolerance)
{
  const int width = a.Size[0];
  const int height = a.Size[1];
  std::vector<char> differs(a.GetNumberOfPixels(), 0);
  Difference result;
  for (size_t i = 0; i < 3 * differs.size(); ++i)
  {
    const int difference = std::abs(a.Colors[i] - b.Colors[i]);
    result.Largest = std::max(result.Largest, difference);
    differs[i / 3] |= difference > tolerance ? 1 : 0;
  }
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const auto at = [&](int i, int j)
      {
        return i >= 0 && j >= 0 && i < width && j < height &&
          differs[static_cast<size_t>(j) * width + i];
      };
      if (at(x, y))
      {
        const int beside = at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1);
        ++(beside <= 2 ? result.Single : result.Wide);
      }
    }
  }
  return result;
}

// Draws a few frames of one scene.
bool TestSeed(
  RelevoCheck& check, unsigned int seed, Windows& windows, const std::string& folder, bool describe)
{
  std::ostringstream log;
  std::ostringstream ignored;
  RelevoRandomScene twin(seed, RelevoScene::Twin, windows.GetTwins(), ignored);
  RelevoRandomScene refining(seed, RelevoScene::Refining, windows.GetRefining(), log);
  bool same = true;
  for (int frame = 0; frame < 2 && same; ++frame)
  {
    if (frame > 0)
    {
      twin.Change();
      refining.Change();
    }
    twin.Render();
    refining.Render();
    for (size_t window = 0; window < twin.GetWindows().size(); ++window)
    {
      const RelevoPicture expected(twin.GetWindows()[window]);
      const RelevoPicture actual(refining.GetWindows()[window]);
      const Difference difference = Compare(actual, expected, 3);
      log << "frame " << frame << ": " << difference.Single << " single pixels differ, "
          << difference.Wide << " others, largest " << difference.Largest << "\n";
      const size_t ties = refining.GetLevel() == 0 ? 0 : actual.GetNumberOfPixels() / 200;
      const bool alike = difference.Wide == 0 && difference.Single <= ties;
      same = same && alike;
      if (describe || !alike)
      {
        const std::string file = folder + "/Random." + std::to_string(seed) + "." +
          std::to_string(frame) + std::string(window, 'b');
        actual.Save(file + ".png");
        expected.Save(file + ".expected.png");
      }
    }
  }
  if (describe)
  {
    std::cout << log.str();
  }
  return same || check.Fail(__FILE__, __LINE__, "seed " + std::to_string(seed) + "\n" + log.str());
}
}

int TestAdaptiveRefinementMapperRandom(int argc, char* argv[])
{
  RelevoCheck check;
  const RelevoComparison comparison(check, argc, argv);
  unsigned int first = 0;
  unsigned int count = 50;
  if (const char* seeds = std::getenv("RELEVO_SEEDS"))
  {
    std::istringstream(seeds) >> first >> count;
  }
  std::unique_ptr<Windows> windows;
  unsigned int different = 0;
  for (unsigned int seed = first; seed < first + count; ++seed)
  {
    if (!windows || seed % 25 == 0)
    {
      windows = std::make_unique<Windows>(); // windows cache their shaders
    }
    different += TestSeed(check, seed, *windows, comparison.GetFolder(), count == 1) ? 0 : 1;
  }
  std::cout << different << " of " << count << " scenes differ" << std::endl;
  return check.GetResult();
}
