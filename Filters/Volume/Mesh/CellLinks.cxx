// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellLinks.h"

#include "Mesh/FaceNeighbors.h"
#include "Mesh/FaceSeams.h"
#include "Mesh/HangingFaces.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
using Face = std::array<int, 4>;

// Relative to the distance between centres, and to coordinates. Points nearer to a plane are on it.
constexpr double FacePlaneMargin = 1e-12;
constexpr double RoundingMargin = 1e-15;

int GetNumberOfCorners(const Face& face)
{
  return face[3] < 0 ? 3 : 4;
}

bool Repeats(const Face& face)
{
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0] || face[3] == face[0] ||
    face[3] == face[1] || face[3] == face[2];
}

bool HasCornersOf(const Face& face, const Face& other)
{
  return std::all_of(other.begin(), other.end(),
    [&](int corner)
    { return corner < 0 || std::find(face.begin(), face.end(), corner) != face.end(); });
}

bool HaveSameCorners(const Face& a, const Face& b)
{
  return HasCornersOf(a, b) && HasCornersOf(b, a);
}

// Whether the face has at least three distinct corners.
bool IsSurface(const Face& face)
{
  std::array<int, 4> corners = face;
  std::sort(corners.begin(), corners.end());
  const auto end = std::unique(corners.begin(), corners.end());
  return end - corners.begin() - (corners[0] < 0 ? 1 : 0) > 2;
}

bool IsFinitePoint(const dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

// Orients a plane towards the next cell, or outwards. Returns 1 or -1 for its previous orientation,
// or 0 if undetermined.
int Orient(dvec4& plane, const dvec3& from, const dvec3& to)
{
  const double height = dot(dvec3(plane), to - from);
  if (!(std::abs(height) > FacePlaneMargin * length(to - from) + RoundingMargin * length(from)))
  {
    return 0;
  }
  plane = height < 0.0 ? -plane : plane;
  return height < 0.0 ? -1 : 1;
}

class Linker
{
public:
  Linker(const std::vector<dvec3>& points, CellFaces&& cells);
  CellLinks Run();

private:
  void RemoveFlatFaces();
  void FindCenters();
  dvec3 GetPoint(int id) const { return this->Points[id] - this->Result.Origin; }
  const Face& GetShape(size_t face) const;
  dvec3 GetCenter(size_t face) const;
  dvec4 GetPlane(size_t face) const;
  void AddLink(int face, int a, int b);
  void AddSeams(const std::vector<int>& border, std::vector<char>& isLinked);
  void AddHanging(const std::vector<int>& border, std::vector<char>& isLinked);
  void SetPlanes();

  const std::vector<dvec3>& Points;
  std::vector<Face> Faces; // of cells, followed by seams
  const std::vector<size_t> Firsts;
  const std::unordered_map<size_t, Face> Polygons;
  std::vector<int> CellsOfFaces;
  std::vector<dvec3> Centers;   // of cells
  std::vector<int> LinkFaces;   // faces that determine the planes of links
  std::vector<int> BorderFaces; // faces that determine the planes of the border
  CellLinks Result;
};

Linker::Linker(const std::vector<dvec3>& points, CellFaces&& cells)
  : Points(points)
  , Faces(std::move(cells.Faces))
  , Firsts(std::move(cells.Firsts))
  , Polygons(std::move(cells.Polygons))
{
  // Not a mean, which a single distant point would spoil.
  const auto origin = std::find_if(points.begin(), points.end(), IsFinitePoint);
  this->Result.Origin = origin != points.end() ? *origin : dvec3(0.0);
  this->CellsOfFaces.resize(this->Faces.size());
  for (size_t cell = 0; cell + 1 < this->Firsts.size(); ++cell)
  {
    std::fill(this->CellsOfFaces.begin() + this->Firsts[cell],
      this->CellsOfFaces.begin() + this->Firsts[cell + 1], static_cast<int>(cell));
  }
}

const Face& Linker::GetShape(size_t face) const
{
  const auto polygon = this->Polygons.find(face);
  return polygon != this->Polygons.end() ? polygon->second : this->Faces[face];
}

dvec3 Linker::GetCenter(size_t face) const
{
  const Face& shape = this->GetShape(face);
  const int size = GetNumberOfCorners(shape);
  dvec3 sum(0.0);
  for (int i = 0; i < size; ++i)
  {
    sum += this->GetPoint(shape[i]);
  }
  return sum / static_cast<double>(size);
}

// For a quadrilateral that is not planar, uses the plane that is parallel to both diagonals.
dvec4 Linker::GetPlane(size_t face) const
{
  const Face& shape = this->GetShape(face);
  const dvec3 first = this->GetPoint(shape[0]);
  const dvec3 second = this->GetPoint(shape[1]);
  const dvec3 third = this->GetPoint(shape[2]);
  const dvec3 normal = shape[3] < 0 ? cross(second - first, third - first)
                                    : cross(third - first, this->GetPoint(shape[3]) - second);
  const double size = length(normal);
  const dvec4 plane(normal / size, -dot(normal / size, this->GetCenter(face)));
  return std::isfinite(plane.x + plane.y + plane.z + plane.w) ? plane : dvec4(0.0);
}

// Removes pairs of faces with the same corners in one cell, which is degenerate.
void Linker::RemoveFlatFaces()
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Firsts.size()) - 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const auto first = this->Faces.begin() + this->Firsts[cell];
        const auto last = this->Faces.begin() + this->Firsts[cell + 1];
        if (std::none_of(first, last, Repeats))
        {
          continue;
        }
        for (auto a = first; a != last; ++a)
        {
          const auto b =
            std::find_if(a + 1, last, [&](const Face& face) { return HaveSameCorners(*a, face); });
          if (b != last && IsSurface(*a))
          {
            *a = *b = { { (*a)[0], (*a)[0], (*a)[0], -1 } };
          }
        }
      }
    });
}

void Linker::FindCenters()
{
  this->Centers.resize(this->Firsts.size() - 1);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Centers.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        dvec3 sum(0.0);
        for (size_t face = this->Firsts[cell]; face < this->Firsts[cell + 1]; ++face)
        {
          sum += this->GetCenter(face);
        }
        this->Centers[cell] =
          sum / static_cast<double>(this->Firsts[cell + 1] - this->Firsts[cell]);
      }
    });
}

void Linker::AddLink(int face, int a, int b)
{
  if (a != b)
  {
    this->LinkFaces.push_back(face);
    this->Result.Links.push_back({ dvec4(0.0), { { a, b } } });
  }
}

void Linker::AddSeams(const std::vector<int>& border, std::vector<char>& isLinked)
{
  for (const FaceSeam& seam : FindSeams(this->Points, this->Faces, border))
  {
    const int plane = static_cast<int>(this->Faces.size());
    this->Faces.push_back(seam.Corners);
    for (int a : seam.Faces[0])
    {
      for (int b : seam.Faces[1])
      {
        if (a >= 0 && b >= 0)
        {
          isLinked[a] = isLinked[b] = 1;
          this->AddLink(plane, this->CellsOfFaces[a], this->CellsOfFaces[b]);
        }
      }
    }
  }
}

// Links cells to smaller ones. The planes are those of the smaller faces.
void Linker::AddHanging(const std::vector<int>& border, std::vector<char>& isLinked)
{
  std::vector<size_t> rest;
  for (int face : border)
  {
    if (!isLinked[face] && this->Polygons.find(face) == this->Polygons.end())
    {
      rest.push_back(static_cast<size_t>(face));
    }
  }
  HangingFaces hanging;
  hanging.Find({ [this](size_t face) { return this->Faces[face]; },
                 [this](int point) { return this->GetPoint(point); },
                 [this](size_t face) { return this->Centers[this->CellsOfFaces[face]]; } },
    rest);
  for (const HangingFaces::Cover& cover : hanging.GetCovers())
  {
    isLinked[cover.Face] = 1;
    for (size_t part : cover.Parts)
    {
      isLinked[part] = 1;
      this->AddLink(
        static_cast<int>(part), this->CellsOfFaces[cover.Face], this->CellsOfFaces[part]);
    }
  }
}

void Linker::SetPlanes()
{
  std::vector<CellLinks::Link>& links = this->Result.Links;
  std::vector<CellLinks::BorderFace>& border = this->Result.Border;
  const vtkIdType numberOfLinks = static_cast<vtkIdType>(links.size());
  std::vector<signed char> turns(links.size() + border.size());
  std::atomic<vtkIdType> votes(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(turns.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (i < numberOfLinks)
        {
          CellLinks::Link& link = links[i];
          link.Plane = this->GetPlane(this->LinkFaces[i]);
          turns[i] = static_cast<signed char>(
            Orient(link.Plane, this->Centers[link.Cells[0]], this->Centers[link.Cells[1]]));
        }
        else
        {
          CellLinks::BorderFace& face = border[i - numberOfLinks];
          const int number = this->BorderFaces[i - numberOfLinks];
          face.Plane = this->GetPlane(number);
          face.Center = this->GetCenter(number);
          turns[i] =
            static_cast<signed char>(Orient(face.Plane, this->Centers[face.Cell], face.Center));
        }
        sum += turns[i];
      }
      votes += sum;
    });
  // Undetermined planes follow the order of corners. The majority of determined planes decides
  // whether corners of this mesh are counterclockwise from outside.
  for (size_t i = 0; i < turns.size() && votes < 0; ++i)
  {
    dvec4& plane = i < links.size() ? links[i].Plane : border[i - links.size()].Plane;
    plane = turns[i] == 0 ? -plane : plane;
  }
}

CellLinks Linker::Run()
{
  this->RemoveFlatFaces();
  this->FindCenters();
  const FaceMatch match = MatchFaces(this->Faces, static_cast<int>(this->Points.size()));
  std::vector<int> border;
  this->LinkFaces.reserve(this->Faces.size() / 2);
  this->Result.Links.reserve(this->Faces.size() / 2);
  for (size_t i = 0; i < match.Others.size(); ++i)
  {
    const int face = static_cast<int>(i);
    const int other = match.Others[i];
    if (other > face)
    {
      this->AddLink(face, this->CellsOfFaces[face], this->CellsOfFaces[other]);
    }
    else if (other < 0 && IsSurface(this->Faces[i]))
    {
      border.push_back(face);
    }
  }
  std::vector<char> isLinked(this->Faces.size(), 0);
  this->AddSeams(border, isLinked);
  isLinked.resize(this->Faces.size(), 0);
  this->AddHanging(border, isLinked);
  for (int face : border)
  {
    if (!isLinked[face])
    {
      this->BorderFaces.push_back(face);
      this->Result.Border.push_back({ dvec4(0.0), dvec3(0.0), this->CellsOfFaces[face] });
    }
  }
  this->SetPlanes();
  return std::move(this->Result);
}
}

CellLinks LinkCells(const std::vector<dvec3>& points, CellFaces cells)
{
  return Linker(points, std::move(cells)).Run();
}
}
