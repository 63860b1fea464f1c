// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the transform feedback stream of the method DMR has the points of
// vtkAdaptiveRefinementFilter on edges, bit for bit, and covers each face once.
#include "RelevoCheck.h"
#include "RelevoTestMeshes.h"

#include "Buffers/RefinementStream.h"
#include "Evaluation/EdgeTags.h"
#include "Evaluation/PatternSelection.h"
#include "Mesh/RefinementMesh.h"
#include "Patterns/RefinementPattern.h"
#include "Recipe/RecipeLevels.h"
#include "View/RefinementView.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <utility>

namespace
{
using namespace RelevoMeshes;
using Weights = std::array<float, 3>;
using Segment = std::pair<Weights, Weights>;

bool IsOnBorder(const Weights& a, const Weights& b)
{
  for (size_t i = 0; i < 3; ++i)
  {
    if (a[i] == 0.0f && b[i] == 0.0f)
    {
      return true;
    }
  }
  return false;
}

// Twice the signed area relative to the face's.
double GetArea(const Weights& a, const Weights& b, const Weights& c)
{
  return (static_cast<double>(b[1]) - a[1]) * (static_cast<double>(c[2]) - a[2]) -
    (static_cast<double>(c[1]) - a[1]) * (static_cast<double>(b[2]) - a[2]);
}

// The triangles of one face in the stream.
struct Face
{
  std::set<Weights> Border;
  std::multiset<Segment> Inside; // each edge in the direction of its triangle
  double Area = 0.0;
  bool Turned = false; // some triangle has the opposite winding or no area
  bool Ahead = false;  // some triangle has the face's winding

  void Add(const Weights corners[3])
  {
    const double area = GetArea(corners[0], corners[1], corners[2]);
    this->Area += area;
    this->Turned = this->Turned || area <= 0.0;
    this->Ahead = this->Ahead || area >= 0.0;
    for (size_t k = 0; k < 3; ++k)
    {
      const Weights& from = corners[k];
      const Weights& to = corners[(k + 1) % 3];
      if (IsOnBorder(from, to))
      {
        this->Border.insert(from);
        this->Border.insert(to);
      }
      else
      {
        this->Inside.insert({ from, to });
      }
    }
  }

  // Whether each inner edge has a triangle on both sides.
  bool IsConforming() const
  {
    return std::all_of(this->Inside.begin(), this->Inside.end(),
      [this](const Segment& s) {
        return this->Inside.count(s) == 1 && this->Inside.count({ s.second, s.first }) == 1;
      });
  }
};

std::set<Weights> GetBorder(const relevo::FacePattern& pattern)
{
  std::set<Weights> border;
  for (int v = 0; v < pattern.Pattern->GetNumberOfBorderVertices(); ++v)
  {
    Weights w;
    pattern.GetWeights(v, w.data());
    border.insert(w);
  }
  return border;
}

void TestMesh(
  RelevoCheck& check, vtkOpenGLRenderWindow* window, vtkPolyData* input, int level, bool hides)
{
  vtkNew<vtkAdaptiveRefinement> recipe;
  recipe->SetMaximumLevel(level);
  recipe->SetGeomorphing(0);
  relevo::RefinementMesh mesh;
  CHECK(mesh.Build(input, recipe->GetSurface(), recipe->GetDisplacement()));
  relevo::EdgeTags tags;
  std::string error;
  CHECK(tags.Compute(recipe, input, mesh, relevo::RefinementView(), error));
  relevo::PatternSelection selection;
  selection.Select(mesh, tags, *relevo::GetPatternFamily(recipe, input), recipe->GetMaximumLevel());
  std::vector<unsigned char> hidden(mesh.Faces.size(), 0);
  for (size_t f = 0; hides && f < hidden.size(); f += 3)
  {
    hidden[f] = 1;
  }
  selection.Group(hidden.data());

  relevo::RefinementSplitProgram program;
  relevo::RefinementStream stream;
  if (!CHECK(stream.Refine(window, mesh, selection, program, error)))
  {
    std::cerr << error << "\n";
    return;
  }
  std::map<unsigned int, Face> faces;
  const std::vector<relevo::RefinementStreamVertex> vertices = stream.Read();
  CHECK_EQUAL(static_cast<vtkIdType>(vertices.size()), 3 * stream.GetNumberOfTriangles());
  CHECK_EQUAL(static_cast<size_t>(stream.GetMemorySize()), 48 * vertices.size() / 3);
  size_t unfinished = 0;
  for (size_t v = 0; v + 2 < vertices.size(); v += 3)
  {
    Weights corners[3];
    for (size_t k = 0; k < 3; ++k)
    {
      std::copy_n(vertices[v + k].Weights, 3, corners[k].begin());
      unfinished += vertices[v + k].Face & 7u;
      unfinished += vertices[v + k].Face >> 3 != vertices[v].Face >> 3;
    }
    faces[vertices[v].Face >> 3].Add(corners);
  }
  CHECK_EQUAL(unfinished, 0);

  size_t drawn = 0;
  size_t borders = 0;
  size_t covers = 0;
  size_t conforming = 0;
  for (size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    const auto found = faces.find(static_cast<unsigned int>(f));
    if (hidden[f] || found == faces.end())
    {
      continue;
    }
    ++drawn;
    const Face& face = found->second;
    borders += face.Border == GetBorder(selection.GetFacePattern(static_cast<int>(f)));
    const bool turned = mesh.Faces[f].IsTurned();
    covers += face.Area == (turned ? -1.0 : 1.0) && !(turned ? face.Ahead : face.Turned);
    conforming += face.IsConforming();
  }
  std::cout << drawn << " faces, " << vertices.size() / 3 << " triangles" << std::endl;
  const size_t shown = static_cast<size_t>(std::count(hidden.begin(), hidden.end(), 0));
  CHECK_EQUAL(faces.size(), shown);
  CHECK_EQUAL(drawn, shown);
  CHECK_EQUAL(borders, drawn);
  CHECK_EQUAL(covers, drawn);
  CHECK_EQUAL(conforming, drawn);
  stream.ReleaseGraphicsResources();
  program.ReleaseGraphicsResources();
}
}

int TestAdaptiveRefinementMapperMethodsStream(int, char*[])
{
  RelevoCheck check;
  vtkNew<vtkRenderWindow> renderWindow;
  renderWindow->SetSize(32, 32);
  renderWindow->Render();
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(renderWindow);
  for (int level = 0; level <= 7; ++level)
  {
    Mesh sphere = Sphere(9, 7);
    AddTags(sphere, static_cast<unsigned int>(level), level);
    TestMesh(check, window, sphere, level, false);
  }
  // The mesh has all triples of levels up to 3, and some up to 6.
  std::vector<std::array<double, 3>> points;
  std::vector<Triangle> triangles;
  for (vtkIdType i = 0; i < 1500; ++i)
  {
    const double x = 2.0 * static_cast<double>(i);
    points.insert(points.end(), { { { x, 0, 0 } }, { { x + 1, 0, 0 } }, { { x, 1, 0 } } });
    triangles.push_back({ { 3 * i, 3 * i + 1, 3 * i + 2 } });
  }
  Mesh apart = FromTriangles(points, triangles);
  AddTags(apart, 7, 6);
  TestMesh(check, window, apart, 6, false);
  AddTags(apart, 8, 3);
  TestMesh(check, window, apart, 3, true);
  // Without tags, all levels are equal.
  TestMesh(check, window, Mixed(), 5, false);
  return check.GetResult();
}
