// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the compute shaders of selection give the same patterns, positions and draw commands
// as plain C++.
#include "RelevoCheck.h"

#include "Compute/RefinementComputeSelector.h"
#include "Compute/RefinementComputeView.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

namespace
{
using relevo::RefinementComputeBuffer;
using relevo::RefinementComputeProgram;
using relevo::RefinementComputeSelector;
using relevo::RefinementComputeView;

// Random faces, and a table with random entries.
struct Case
{
  int NumberOfFaces;
  int NumberOfKeys;
  int MaximumLevel;
  std::vector<unsigned char> Orders;
  std::vector<int> Corners; // 4 per face
  std::vector<float> Tags;
  std::vector<unsigned int> Table;
  std::vector<RefinementComputeSelector::Pattern> Patterns;

  Case(int numberOfFaces, int numberOfKeys, int maximumLevel, unsigned int seed)
    : NumberOfFaces(numberOfFaces)
    , NumberOfKeys(numberOfKeys)
    , MaximumLevel(maximumLevel)
  {
    std::mt19937 random(seed);
    auto below = [&random](int n) { return static_cast<int>(random() % n); };
    const int points = numberOfFaces / 2 + 3;
    for (int f = 0; f < numberOfFaces; ++f)
    {
      this->Orders.push_back(static_cast<unsigned char>(below(6)));
      this->Corners.insert(
        this->Corners.end(), { below(points), below(points), below(points), -1 });
    }
    std::uniform_real_distribution<float> tag(-1.0f, maximumLevel + 1.0f);
    for (int i = 0; i < points; ++i)
    {
      // Some means lie on the boundary between two levels.
      this->Tags.push_back(i % 3 == 0 ? std::round(tag(random)) : tag(random));
    }
    const int levels = maximumLevel + 1;
    for (int i = 0; i < 6 * levels * levels * levels; ++i)
    {
      this->Table.push_back(static_cast<unsigned int>(below(numberOfKeys) << 3 | below(6)));
    }
    for (int key = 0; key < numberOfKeys; ++key)
    {
      const unsigned int k = static_cast<unsigned int>(key);
      this->Patterns.push_back({ 1u + k % 7, 3 * k, 5 * k, 11 * k, 2 * k + 3, 13 * k, 17 * k });
    }
  }

  // The level of the mean, rounded half up, in double precision.
  int GetLevel(double a, double b) const
  {
    return static_cast<int>(
      std::floor(std::min(std::max(0.5 * (a + b), 0.0), 1.0 * this->MaximumLevel) + 0.5));
  }

  unsigned int GetEntry(int face, RefinementComputeSelector::TagKinds kind) const
  {
    const int* corners = &this->Corners[4 * static_cast<size_t>(face)];
    int index = this->Orders[face];
    for (int e = 0; e < 3; ++e)
    {
      const int a = corners[e == 1 ? 1 : 0];
      const int b = corners[e == 0 ? 1 : 2];
      const int level = kind == RefinementComputeSelector::UNIFORM ? this->MaximumLevel
        : kind == RefinementComputeSelector::PER_POINT
        ? this->GetLevel(this->Tags[a], this->Tags[b])
        : this->GetLevel(this->Tags[corners[e]], this->Tags[corners[e]]);
      index = index * (this->MaximumLevel + 1) + level;
    }
    return this->Table[index];
  }
};

void Check(RelevoCheck& check, vtkOpenGLRenderWindow* window, const Case& c,
  RefinementComputeSelector::TagKinds kind)
{
  RefinementComputeSelector selector;
  RefinementComputeView selection;
  RefinementComputeBuffer corners;
  RefinementComputeBuffer tags;
  RefinementComputeBuffer instances;
  CHECK(corners.Upload(c.Corners) && tags.Upload(c.Tags));
  CHECK(instances.Resize(sizeof(unsigned int) * c.NumberOfFaces));
  CHECK(selector.UploadOrders(c.Orders));
  if (!CHECK(selector.UploadPatterns(c.Patterns, c.Table, c.MaximumLevel, false)))
  {
    std::cerr << selector.GetError() << "\n";
    return;
  }
  RefinementComputeProgram::Begin(window);
  CHECK(selector.Select(selection, { kind, tags.GetHandle(), corners.GetHandle(), 4, 0.0f }, 0));
  selector.Group(selection, nullptr, instances.GetHandle());
  RefinementComputeProgram::End();

  // The shader selects the pattern of each face.
  const std::vector<unsigned int> entries = selection.ReadEntries();
  std::vector<int> counts(static_cast<size_t>(c.NumberOfKeys), 0);
  int wrong = 0;
  for (int f = 0; f < c.NumberOfFaces; ++f)
  {
    wrong += entries[f] != c.GetEntry(f, kind);
    ++counts[c.GetEntry(f, kind) >> 3];
  }
  CHECK_EQUAL(wrong, 0);
  CHECK(std::equal(counts.begin(), counts.end(), selection.ReadCounts().begin()));

  // Each command draws the faces of its key once, with the key's pattern.
  const auto commands = selection.ReadCommands(RefinementComputeView::TRIANGLES);
  const auto lines = selection.ReadCommands(RefinementComputeView::LINES);
  const auto placed = instances.Read<unsigned int>(static_cast<size_t>(c.NumberOfFaces));
  std::vector<unsigned int> instanceMembers(2 * static_cast<size_t>(c.NumberOfFaces));
  RefinementComputeBuffer::ReadBuffer(selection.GetMembers(RefinementComputeView::TRIANGLES), 0,
    instanceMembers.data(), instanceMembers.size() * sizeof(unsigned int));
  std::vector<int> drawn(static_cast<size_t>(c.NumberOfFaces), 0);
  int strange = 0;
  for (int key = 0; key < c.NumberOfKeys; ++key)
  {
    const auto& pattern = c.Patterns[key];
    const unsigned int* command = &commands[5 * static_cast<size_t>(key)];
    const unsigned int* line = &lines[4 * static_cast<size_t>(key)];
    const unsigned int copies =
      pattern.NumberOfIndices > 0 ? command[0] / pattern.NumberOfIndices : 1;
    strange += copies > pattern.Copies || command[0] != copies * pattern.NumberOfIndices;
    strange += command[2] != pattern.FirstIndex || command[3] != pattern.FirstVertex;
    strange += line[0] != pattern.NumberOfLineVertices || line[2] != pattern.FirstLineVertex;
    strange += line[1] != static_cast<unsigned int>(counts[key]);
    unsigned int faces = 0;
    for (unsigned int i = command[4]; i < command[4] + command[1]; ++i)
    {
      const unsigned int* member = &instanceMembers[2 * static_cast<size_t>(i)];
      strange += pattern.NumberOfIndices > 0 && (member[1] == 0 || member[1] > copies);
      strange += member[0] != line[3] + faces;
      faces += member[1];
      for (unsigned int m = member[0]; m < member[0] + member[1]; ++m)
      {
        const unsigned int face = placed[m] >> 3;
        ++drawn[face];
        strange += entries[face] != (static_cast<unsigned int>(key) << 3 | (placed[m] & 7u));
      }
    }
    strange += faces != static_cast<unsigned int>(counts[key]);
  }
  CHECK_EQUAL(strange, 0);
  CHECK_EQUAL(std::count(drawn.begin(), drawn.end(), 1), c.NumberOfFaces);
  corners.ReleaseGraphicsResources();
  tags.ReleaseGraphicsResources();
  instances.ReleaseGraphicsResources();
  selection.ReleaseGraphicsResources();
  selector.ReleaseGraphicsResources();
}
}

int TestAdaptiveRefinementMapperComputeStages(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkRenderWindow> window;
  window->SetSize(32, 32);
  window->Render();
  if (!RefinementComputeProgram::IsSupported())
  {
    std::cout << "The context has no OpenGL 4.3: skipped." << std::endl;
    return 125;
  }
  vtkOpenGLRenderWindow* context = vtkOpenGLRenderWindow::SafeDownCast(window);

  RefinementComputeProgram program;
  CHECK(!program.Build("void main() { nonsense }\n"));
  CHECK_NOT_EQUAL(program.GetError().find("does not compile"), std::string::npos);
  CHECK(!program.IsBuilt());

  unsigned int seed = 0;
  for (auto kind : { RefinementComputeSelector::UNIFORM, RefinementComputeSelector::PER_POINT,
         RefinementComputeSelector::PER_EDGE })
  {
    for (int faces : { 0, 1, 5, 255, 256, 257, 70001 })
    {
      CHECK_CASE(faces);
      for (int keys : { 1, 7, 256, 1000 })
      {
        CHECK_CASE(keys);
        Check(check, context, Case(faces, keys, 1 + static_cast<int>(seed % 7), seed), kind);
        ++seed;
      }
    }
  }
  return check.GetResult();
}
