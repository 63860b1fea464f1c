// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that faces with the same corners are found as neighbours, compared with a map of corner
// sets.
#include "Mesh/FaceNeighbors.h"
#include "RelevoCheck.h"
#include "RelevoDice.h"
#include "RelevoVolumes.h"

#include "vtkDataSetReader.h"
#include "vtkIdList.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>

namespace
{
using Faces = std::vector<std::array<int, 4>>;

void CheckFaces(RelevoCheck& check, const Faces& faces, int numberOfPoints)
{
  std::map<std::set<int>, std::vector<int>> places;
  for (size_t i = 0; i < faces.size(); ++i)
  {
    std::set<int> corners(faces[i].begin(), faces[i].end());
    corners.erase(-1);
    if (corners.size() > 2)
    {
      places[corners].push_back(static_cast<int>(i));
    }
  }
  std::vector<int> others(faces.size(), -1);
  size_t numberOfSharedByMore = 0;
  for (const auto& place : places)
  {
    if (place.second.size() == 2)
    {
      others[place.second[0]] = place.second[1];
      others[place.second[1]] = place.second[0];
    }
    numberOfSharedByMore += place.second.size() > 2 ? 1 : 0;
  }
  const relevo::FaceMatch match = relevo::MatchFaces(faces, numberOfPoints);
  CHECK_EQUAL(match.Others, others);
  CHECK_EQUAL(match.NumberOfSharedByMore, numberOfSharedByMore);
}

Faces GetFaces(vtkUnstructuredGrid* tetrahedra)
{
  const int corners[4][3] = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } };
  Faces faces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < tetrahedra->GetNumberOfCells(); ++i)
  {
    tetrahedra->GetCellPoints(i, ids);
    for (const auto& face : corners)
    {
      faces.push_back({ { static_cast<int>(ids->GetId(face[0])),
        static_cast<int>(ids->GetId(face[1])), static_cast<int>(ids->GetId(face[2])), -1 } });
    }
  }
  return faces;
}

// Few points, so that corners repeat and cells share faces with several others.
void TestRandom(RelevoCheck& check)
{
  RelevoDice dice(1);
  for (int round = 0; round < 200; ++round)
  {
    const int numberOfPoints = 1 + dice.Throw(12);
    Faces faces(dice.Throw(300));
    for (auto& face : faces)
    {
      for (int& corner : face)
      {
        corner = dice.Throw(numberOfPoints);
      }
      face[3] = dice.Once(2) ? -1 : face[3];
    }
    CheckFaces(check, faces, numberOfPoints);
  }
}

void TestGiven(RelevoCheck& check)
{
  const relevo::FaceMatch match = relevo::MatchFaces(
    { { { 4, 2, 7, -1 } }, { { 0, 1, 2, 3 } }, { { 7, 4, 2, -1 } }, { { 3, 1, 0, 2 } },
      { { 0, 1, 2, -1 } }, { { 2, 1, 2, 0 } }, { { 5, 5, 6, -1 } }, { { 5, 6, 6, -1 } },
      { { 1, 2, 3, -1 } }, { { 3, 2, 1, -1 } }, { { 1, 3, 2, -1 } } },
    8);
  CHECK_EQUAL(match.Others, std::vector<int>({ 2, 3, 0, 1, 5, 4, -1, -1, -1, -1, -1 }));
  CHECK_EQUAL(match.NumberOfSharedByMore, 1);
  CHECK(relevo::MatchFaces({}, 0).Others.empty());
}

// Cubes with random numbers of points, so many that their faces are matched in several parts.
void TestParts(RelevoCheck& check)
{
  constexpr int n = 40;
  constexpr int m = n + 1;
  std::vector<int> ids(m * m * m);
  std::iota(ids.begin(), ids.end(), 0);
  std::mt19937 random(3);
  std::shuffle(ids.begin(), ids.end(), random);
  const int corners[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 },
    { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  Faces faces;
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    const int first = cube % n + m * (cube / n % n + m * (cube / n / n));
    for (const auto& face : corners)
    {
      faces.emplace_back();
      std::transform(face, face + 4, faces.back().begin(),
        [&](int i) { return ids[first + (i & 1) + m * (i >> 1 & 1) + m * m * (i >> 2)]; });
    }
  }
  const relevo::FaceMatch match = relevo::MatchFaces(faces, m * m * m);
  CHECK_EQUAL(match.NumberOfSharedByMore, 0);
  CHECK_EQUAL(std::count(match.Others.begin(), match.Others.end(), -1), 6 * n * n);
  size_t numberOfGood = 0;
  for (size_t i = 0; i < faces.size(); ++i)
  {
    const int other = match.Others[i];
    std::sort(faces[i].begin(), faces[i].end());
    if (other >= 0 && other < static_cast<int>(i))
    {
      numberOfGood += match.Others[other] == static_cast<int>(i) && faces[i] == faces[other];
    }
  }
  CHECK_EQUAL(numberOfGood, 3 * n * n * (n - 1));
}

void TestMeshes(RelevoCheck& check)
{
  const int n = 7;
  const auto cube = MakeTetrahedra(n, GetLinearField);
  const Faces faces = GetFaces(cube);
  CheckFaces(check, faces, static_cast<int>(cube->GetNumberOfPoints()));
  const relevo::FaceMatch match =
    relevo::MatchFaces(faces, static_cast<int>(cube->GetNumberOfPoints()));
  CHECK_EQUAL(std::count(match.Others.begin(), match.Others.end(), -1), 12 * n * n);

  const char* folder = std::getenv("RELEVO_TEST_DATA");
  if (folder && *folder)
  {
    vtkNew<vtkDataSetReader> reader;
    reader->SetFileName((std::string(folder) + "/volume/post.vtk").c_str());
    reader->Update();
    auto* post = vtkUnstructuredGrid::SafeDownCast(reader->GetOutput());
    CHECK(post && post->GetNumberOfCells() == 8750);
    if (post)
    {
      CheckFaces(check, GetFaces(post), static_cast<int>(post->GetNumberOfPoints()));
    }
  }
}
}

int TestFaceNeighbors(int, char*[])
{
  RelevoCheck check;
  TestRandom(check);
  TestGiven(check);
  TestParts(check);
  TestMeshes(check);
  return check.GetResult();
}
