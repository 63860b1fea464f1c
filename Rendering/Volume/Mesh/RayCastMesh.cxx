// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/RayCastMesh.h"

#include "Cells/MergedCellPoints.h"
#include "Cells/PointGradients.h"
#include "Cells/VolumeCells.h"
#include "Mathematics/FiniteBox.h"
#include "Mesh/BorderTree.h"
#include "Mesh/CurvedRecords.h"
#include "Mesh/FaceNeighbors.h"
#include "Mesh/HangingFaces.h"
#include "Mesh/HangingRecords.h"
#include "vtkCellType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace relevo
{
namespace
{
constexpr int MaximumFacesPerLeaf = 8;
// Relative to the mesh's radius; larger than the rounding errors of floats.
constexpr float TreeMargin = 1e-5f;
// Relative to the side of a face.
constexpr double LargestBulge = 1e-5;
constexpr size_t MaximumBorderFaces = size_t(1) << 24;
constexpr size_t MaximumDiscontinuousCells = size_t(1) << 29; // see RayCastMesh::Neighbors
constexpr std::uint32_t Unused = RayCastMesh::UnusedPoint;

using Face = std::array<int, 4>;

bool IsQuadratic(const VolumeCells::Cell& cell)
{
  return cell.Shape && !cell.Shape->QuadraticFaces.empty();
}

// The steps to build a mesh, with their intermediate data.
class RayCastMeshBuilder
{
public:
  /// The given tetrahedra are stored as curved cells; the list is empty if there are none.
  RayCastMeshBuilder(const VolumeCells& cells, int numberOfComponents, const MeshExtent& whole,
    const std::vector<bool>& records, RayCastMesh& mesh)
    : Cells(cells)
    , NumberOfComponents(numberOfComponents)
    , Whole(whole)
    , Records(records)
    , Mesh(mesh)
  {
  }

  void KeepPointIds() { this->Mesh.PointIds = std::move(this->NewIds); }
  void KeepCorners() { this->KeepsCorners = true; }
  void MergePoints();
  bool IsDiscontinuous() const { return this->Mesh.IsDiscontinuous; }
  void SortPoints();
  void StorePoints();
  void StoreScalars();
  void AddGradients();
  void AddCells();
  void FindMatches();
  /// Take the neighbours of an earlier mesh. Return false if it does not have the same cells.
  bool TakeNeighbors(RayCastMesh& known);
  void ForgetNeighbors();
  bool HasHanging() const { return !this->Hanging.IsEmpty(); }
  /// Find faces with several cells behind them. Return the tetrahedra that must be stored as curved
  /// cells, if there are any.
  std::vector<bool> FindHanging();
  void FindNeighbors();
  void AddHanging();
  void BuildBorder();
  /// Return what is wrong with the number of cells, or nothing.
  std::string DescribeSize() const;

private:
  bool HasCellScalars() const { return !this->Kept.empty() && this->Kept[0].Scalars >= 0; }
  std::uint32_t GetPointId(const VolumeCells::Cell& cell, int i) const
  {
    return this->NewIds[this->Cells.GetCornerId(cell, i)];
  }
  std::array<std::uint32_t, 4> GetTetrahedron(size_t index) const;
  dvec3 GetInside(size_t face) const;
  HangingRecords::Part GetPart(size_t face) const;
  void AddTetrahedron(const VolumeCells::Cell& cell);
  void AddCurved(const VolumeCells::Cell& cell);
  bool IsMirrored(const VolumeCells::Cell& cell) const;
  bool IsFlat(const VolumeCells::Cell& cell) const;
  void FindPlaces();
  std::vector<Face> FindFacesOfPlaces() const;
  std::uint32_t GetCell(size_t face) const;
  std::uint32_t GetNeighbor(size_t face, size_t other) const;
  std::uint32_t& GetBehind(size_t face);
  bool AreDuplicates(size_t face, size_t other) const;
  dvec3 GetPoint(std::uint32_t point) const;
  FloatBox GetBox(size_t face) const;
  bool FacesInwards(const Face& face, std::uint32_t tetrahedron) const;
  void AddBorderFace(size_t face);
  bool HasCellsOf(const RayCastMesh& known) const;

  const VolumeCells& Cells;
  const int NumberOfComponents;
  const MeshExtent& Whole;
  const std::vector<bool>& Records;
  bool KeepsCorners = false;
  RayCastMesh& Mesh;
  std::vector<VolumeCells::Cell> Kept;   // tetrahedra first
  std::vector<size_t> KeptTetrahedra;    // indices of the cells
  std::vector<std::uint32_t> NewIds;     // of the cells' points
  std::vector<vtkIdType> OldIds;         // of the mesh's points
  std::vector<vtkIdType> Places;         // of the cells' points: the first point there
  std::vector<Face> Faces;               // of all cells
  std::vector<std::uint32_t> FaceCells;  // of curved cells' faces, after those of tetrahedra
  std::vector<std::uint32_t> FirstFaces; // of curved cells
  std::vector<size_t> Border;            // faces
  FaceMatch Match;
  std::vector<int> PlaceOfPoints; // of the mesh's points: the first point there
  HangingFaces Hanging;
};

// Tetrahedra come first, because the walk identifies them by their index.
void RayCastMeshBuilder::MergePoints()
{
  for (const bool isCurved : { false, true })
  {
    for (size_t i = 0; i < this->Cells.GetCells().size(); ++i)
    {
      const VolumeCells::Cell& cell = this->Cells.GetCells()[i];
      const bool isRecord = cell.Shape || (!this->Records.empty() && this->Records[i]);
      if (isRecord == isCurved)
      {
        this->Kept.push_back(cell);
        if (!isRecord)
        {
          this->KeptTetrahedra.push_back(i);
        }
      }
    }
  }
  MergedCellPoints all = MergeCellPoints(this->Cells);
  this->Places = std::move(all.Places);
  const std::vector<vtkIdType>& merged = all.Points;
  this->NewIds.assign(merged.size(), Unused);
  for (const VolumeCells::Cell& cell : this->Kept)
  {
    for (int i = 0; i < this->Cells.GetNumberOfCorners(cell); ++i)
    {
      const vtkIdType point = this->Cells.GetCornerId(cell, i);
      const vtkIdType first = merged[point];
      if (this->NewIds[first] == Unused)
      {
        this->NewIds[first] = static_cast<std::uint32_t>(this->OldIds.size());
        this->OldIds.push_back(first);
      }
      this->NewIds[point] = this->NewIds[first];
    }
  }
  std::vector<bool> isTaken(merged.size(), false);
  for (const vtkIdType point : this->OldIds)
  {
    const vtkIdType place = this->Places[point];
    this->Mesh.IsDiscontinuous = this->Mesh.IsDiscontinuous || isTaken[place];
    isTaken[place] = true;
  }
}

// Coincident points are not merged if their scalars differ, which then decide.
void RayCastMeshBuilder::SortPoints()
{
  const std::vector<dvec3>& points = this->Cells.GetPoints();
  const std::vector<Scalars>& scalars = this->Cells.GetPointScalars();
  const auto getKey = [&](vtkIdType id)
  { return std::tie(points[id].x, points[id].y, points[id].z, scalars[id]); };
  std::sort(this->OldIds.begin(), this->OldIds.end(),
    [&](vtkIdType a, vtkIdType b) { return getKey(a) < getKey(b); });
  std::vector<std::uint32_t> moved(this->OldIds.size());
  for (size_t i = 0; i < this->OldIds.size(); ++i)
  {
    moved[this->NewIds[this->OldIds[i]]] = static_cast<std::uint32_t>(i);
  }
  for (std::uint32_t& id : this->NewIds)
  {
    id = id == Unused ? Unused : moved[id];
  }
}

void RayCastMeshBuilder::StorePoints()
{
  const FiniteBox& box = this->Whole.Points;
  this->Mesh.Center = dvec3(box.GetMiddle(0), box.GetMiddle(1), box.GetMiddle(2));
  this->Mesh.Radius = this->Whole.GetRadius();
  this->Mesh.LongestEdge = this->Whole.LongestEdge / this->Mesh.Radius;
  this->Mesh.HalfSize =
    dvec3(box.GetSide(0), box.GetSide(1), box.GetSide(2)) / (2.0 * this->Mesh.Radius);
  std::vector<dvec3> points;
  points.reserve(this->OldIds.size());
  for (const vtkIdType id : this->OldIds)
  {
    points.push_back(this->Cells.GetPoints()[id]);
  }
  this->Mesh.SetPoints(points);
}

void RayCastMeshBuilder::StoreScalars()
{
  const bool areOfCells = this->HasCellScalars();
  std::vector<Scalars> used;
  if (areOfCells)
  {
    for (const VolumeCells::Cell& cell : this->Kept)
    {
      used.push_back(this->Cells.GetCellScalars()[cell.Scalars]);
      this->Mesh.CellIds.push_back(cell.Scalars);
    }
  }
  else
  {
    for (const vtkIdType id : this->OldIds)
    {
      used.push_back(this->Cells.GetPointScalars()[id]);
    }
  }
  this->Mesh.SetScalars(used, this->NumberOfComponents, areOfCells, this->Whole);
}

void RayCastMeshBuilder::AddGradients()
{
  if (this->HasCellScalars())
  {
    return;
  }
  this->Mesh.SetGradients(
    ComputePointGradients(this->Cells), this->OldIds, this->NumberOfComponents);
}

void RayCastMeshBuilder::AddTetrahedron(const VolumeCells::Cell& cell)
{
  std::array<std::uint32_t, 4> points;
  for (int i = 0; i < 4; ++i)
  {
    points[i] = this->GetPointId(cell, i);
  }
  std::sort(points.begin(), points.end());
  this->Mesh.PointSums.push_back(points[0] ^ points[1] ^ points[2] ^ points[3]);
  if (this->KeepsCorners)
  {
    this->Mesh.Corners.insert(this->Mesh.Corners.end(), points.begin(), points.end());
  }
  for (int i = 0; i < 4; ++i)
  {
    this->Faces.push_back({ { static_cast<int>(points[i == 0 ? 1 : 0]),
      static_cast<int>(points[i <= 1 ? 2 : 1]), static_cast<int>(points[i <= 2 ? 3 : 2]), -1 } });
  }
}

// Return whether the faces of a cell point inwards, from the enclosed volume.
bool RayCastMeshBuilder::IsMirrored(const VolumeCells::Cell& cell) const
{
  const std::vector<int>& record = GetRecord(cell.Shape, false);
  const auto get = [&](int i)
  { return this->Cells.GetPoints()[this->Cells.GetCornerId(cell, record[i])]; };
  const dvec3 origin = get(0);
  double volume = 0.0;
  for (const auto& face : GetRecordFaces(IsQuadratic(cell)))
  {
    const dvec3 a = get(face[0]) - origin;
    const dvec3 b = get(face[1]) - origin;
    const dvec3 c = get(face[2]) - origin;
    const dvec3 d = get(face[3]) - origin;
    volume += dot(a, cross(b, c)) + dot(a, cross(c, d));
  }
  return volume < 0.0;
}

// Return whether all points of each face are coplanar, up to the rounding of floats.
bool RayCastMeshBuilder::IsFlat(const VolumeCells::Cell& cell) const
{
  if (!cell.Shape)
  {
    return true;
  }
  const auto get = [&](int i) { return this->Cells.GetPoints()[this->Cells.GetCornerId(cell, i)]; };
  const auto isFlat = [&](const auto& face)
  {
    const dvec3 origin = get(face[0]);
    const dvec3 normal = cross(get(face[2]) - origin, get(face[1]) - origin) +
      cross(get(face[3]) - origin, get(face[2]) - origin);
    const double size = std::sqrt(dot(normal, normal));
    return std::all_of(face.begin(), face.end(),
      [&](int i)
      { return std::abs(dot(get(i) - origin, normal)) <= LargestBulge * size * std::sqrt(size); });
  };
  return std::all_of(cell.Shape->Faces.begin(), cell.Shape->Faces.end(), isFlat) &&
    std::all_of(cell.Shape->QuadraticFaces.begin(), cell.Shape->QuadraticFaces.end(), isFlat);
}

void RayCastMeshBuilder::AddCurved(const VolumeCells::Cell& cell)
{
  const std::uint32_t number = static_cast<std::uint32_t>(
    this->Mesh.GetNumberOfTetrahedra() + this->Mesh.GetNumberOfCurvedCells());
  std::array<std::uint32_t, RayCastMesh::WordsOfCurvedCell> words = {};
  const bool isQuadratic = IsQuadratic(cell);
  const std::vector<int>& record = GetRecord(cell.Shape, this->IsMirrored(cell));
  for (size_t i = 0; i < record.size(); ++i)
  {
    words[i] = this->GetPointId(cell, record[i]);
  }
  if (isQuadratic)
  {
    words.back() = RayCastMesh::Quadratic;
    this->Mesh.HasQuadraticCells = true;
  }
  const int corners = this->Cells.GetNumberOfCorners(cell);
  this->Mesh.HasPyramids = this->Mesh.HasPyramids || corners == 4 || corners == 5;
  this->Mesh.HasFoldedFaces = this->Mesh.HasFoldedFaces || !this->IsFlat(cell);
  this->Mesh.CurvedCells.insert(this->Mesh.CurvedCells.end(), words.begin(), words.end());
  this->FirstFaces.push_back(static_cast<std::uint32_t>(this->Faces.size()));
  for (const auto& face : GetRecordFaces(isQuadratic))
  {
    const auto get = [&](int i) { return static_cast<int>(words[face[i]]); };
    this->Faces.push_back({ { get(0), get(1), get(2), face[3] == face[2] ? -1 : get(3) } });
    this->FaceCells.push_back(number);
  }
}

void RayCastMeshBuilder::AddCells()
{
  for (size_t i = 0; i < this->Kept.size(); ++i)
  {
    const bool isTetrahedron = i < this->KeptTetrahedra.size();
    isTetrahedron ? this->AddTetrahedron(this->Kept[i]) : this->AddCurved(this->Kept[i]);
  }
}

// Points at one place are next to each other.
void RayCastMeshBuilder::FindPlaces()
{
  std::vector<int>& places = this->PlaceOfPoints;
  places.resize(this->OldIds.size());
  for (size_t i = 0; i < places.size(); ++i)
  {
    const bool isSame = i > 0 && this->Places[this->OldIds[i]] == this->Places[this->OldIds[i - 1]];
    places[i] = isSame ? places[i - 1] : static_cast<int>(i);
  }
}

// Return the faces with places instead of points. Faces with several points at one place match no
// other face.
std::vector<Face> RayCastMeshBuilder::FindFacesOfPlaces() const
{
  const std::vector<int>& places = this->PlaceOfPoints;
  std::vector<Face> all = this->Faces;
  for (Face& face : all)
  {
    const Face points = face;
    for (int& corner : face)
    {
      corner = corner < 0 ? corner : places[corner];
    }
    for (size_t i = 0; i < 16; ++i)
    {
      if (face[i / 4] >= 0 && face[i / 4] == face[i % 4] && points[i / 4] != points[i % 4])
      {
        face = { { 0, 0, 0, -1 } };
      }
    }
  }
  return all;
}

// Return the index of a face's cell.
std::uint32_t RayCastMeshBuilder::GetCell(size_t face) const
{
  const size_t inTetrahedra = 4 * this->Mesh.GetNumberOfTetrahedra();
  return face < inTetrahedra ? static_cast<std::uint32_t>(face / 4)
                             : this->FaceCells[face - inTetrahedra];
}

// Return the entry in RayCastMesh::Neighbors for a face and the matching face of another cell.
std::uint32_t RayCastMeshBuilder::GetNeighbor(size_t face, size_t other) const
{
  const std::uint32_t cell = this->GetCell(other);
  if (!this->Mesh.IsDiscontinuous)
  {
    return cell;
  }
  Face here = this->Faces[face];
  Face there = this->Faces[other];
  std::sort(here.begin(), here.end());
  std::sort(there.begin(), there.end());
  const bool isTetrahedron = other < 4 * this->Mesh.GetNumberOfTetrahedra();
  const std::uint32_t side = isTetrahedron ? static_cast<std::uint32_t>(other % 4) : 0;
  return 8 * cell + (here == there ? RayCastMesh::SamePoints : side);
}

// Return a reference to the index of the cell behind a face.
std::uint32_t& RayCastMeshBuilder::GetBehind(size_t face)
{
  if (face < 4 * this->Mesh.GetNumberOfTetrahedra())
  {
    return this->Mesh.Neighbors[face];
  }
  const size_t record = this->FaceCells[face - 4 * this->Mesh.GetNumberOfTetrahedra()] -
    this->Mesh.GetNumberOfTetrahedra();
  return this->Mesh.CurvedCells[RayCastMesh::WordsOfCurvedCell * record +
    RayCastMesh::FirstNeighborWord + face - this->FirstFaces[record]];
}

// Return whether the cells of two matching faces have the same points. Then both are on the same
// side of the face.
bool RayCastMeshBuilder::AreDuplicates(size_t face, size_t other) const
{
  const size_t inTetrahedra = 4 * this->Mesh.GetNumberOfTetrahedra();
  const std::uint32_t cells[2] = { this->GetCell(face), this->GetCell(other) };
  if (cells[0] == cells[1] || (face < inTetrahedra) != (other < inTetrahedra))
  {
    return false;
  }
  if (face < inTetrahedra)
  {
    const auto getLast = [this](size_t of)
    {
      const Face& corners = this->Faces[of];
      return this->GetPoint(this->Mesh.PointSums[of / 4] ^ static_cast<std::uint32_t>(corners[0]) ^
        static_cast<std::uint32_t>(corners[1]) ^ static_cast<std::uint32_t>(corners[2]));
    };
    return getLast(face) == getLast(other);
  }
  const auto getWords = [&](std::uint32_t cell)
  {
    return this->Mesh.CurvedCells.data() +
      RayCastMesh::WordsOfCurvedCell * (cell - inTetrahedra / 4);
  };
  const std::uint32_t* here = getWords(cells[0]);
  const std::uint32_t* there = getWords(cells[1]);
  const auto isQuadratic = [](const std::uint32_t* words)
  { return words[RayCastMesh::WordsOfCurvedCell - 1] == RayCastMesh::Quadratic; };
  const int count = isQuadratic(here) ? 10 : 8;
  return isQuadratic(here) == isQuadratic(there) &&
    std::all_of(here, here + count,
      [&](std::uint32_t point)
      {
        return std::any_of(there, there + count,
          [&](std::uint32_t candidate)
          { return point == candidate || this->GetPoint(point) == this->GetPoint(candidate); });
      });
}

void RayCastMeshBuilder::FindMatches()
{
  const int numberOfPoints = static_cast<int>(this->OldIds.size());
  if (this->Mesh.IsDiscontinuous)
  {
    this->FindPlaces();
  }
  this->Match = this->Mesh.IsDiscontinuous ? MatchFaces(this->FindFacesOfPlaces(), numberOfPoints)
                                           : MatchFaces(this->Faces, numberOfPoints);
  this->Mesh.NumberOfSharedFaces = this->Match.NumberOfSharedByMore;
  for (size_t face = 0; face < this->Faces.size(); ++face)
  {
    int& other = this->Match.Others[face];
    if (other > static_cast<int>(face) && this->AreDuplicates(face, static_cast<size_t>(other)))
    {
      ++this->Mesh.NumberOfSharedFaces;
      this->Match.Others[static_cast<size_t>(other)] = -1;
      other = -1;
    }
    if (other < 0 && IsFace(this->Faces[face]))
    {
      this->Border.push_back(face);
    }
  }
}

// Return the points of a tetrahedron in ascending order.
std::array<std::uint32_t, 4> RayCastMeshBuilder::GetTetrahedron(size_t index) const
{
  const Face& last = this->Faces[4 * index]; // without the lowest point
  const Face& first = this->Faces[4 * index + 3];
  return { { static_cast<std::uint32_t>(first[0]), static_cast<std::uint32_t>(last[0]),
    static_cast<std::uint32_t>(last[1]), static_cast<std::uint32_t>(last[2]) } };
}

// Return whether another mesh has the same cells of the same points. Its corners are known.
bool RayCastMeshBuilder::HasCellsOf(const RayCastMesh& known) const
{
  if (known.PointSums != this->Mesh.PointSums ||
    known.CurvedCells.size() != this->Mesh.CurvedCells.size())
  {
    return false;
  }
  for (size_t i = 0; i < this->KeptTetrahedra.size(); ++i)
  {
    const std::array<std::uint32_t, 4> corners = this->GetTetrahedron(i);
    if (!std::equal(corners.begin(), corners.end(), known.Corners.begin() + 4 * i))
    {
      return false;
    }
  }
  for (size_t i = 0; i < known.CurvedCells.size(); i += RayCastMesh::WordsOfCurvedCell)
  {
    const auto here = this->Mesh.CurvedCells.begin() + i;
    const auto there = known.CurvedCells.begin() + i;
    const bool isQuadratic = here[RayCastMesh::WordsOfCurvedCell - 1] == RayCastMesh::Quadratic;
    if (!std::equal(here, here + RayCastMesh::FirstNeighborWord, there) ||
      isQuadratic != (there[RayCastMesh::WordsOfCurvedCell - 1] == RayCastMesh::Quadratic))
    {
      return false;
    }
  }
  return true;
}

bool RayCastMeshBuilder::TakeNeighbors(RayCastMesh& known)
{
  if (this->Mesh.IsDiscontinuous || !this->HasCellsOf(known))
  {
    return false;
  }
  this->Mesh.Neighbors = std::move(known.Neighbors);
  this->Mesh.CurvedCells = std::move(known.CurvedCells);
  this->Mesh.HasKnownNeighbors = true;
  for (size_t face = 0; face < this->Faces.size(); ++face)
  {
    if (this->GetBehind(face) == RayCastMesh::InvalidCell && IsFace(this->Faces[face]))
    {
      this->Border.push_back(face);
    }
  }
  return true;
}

// Keep the points of cells only.
void RayCastMeshBuilder::ForgetNeighbors()
{
  this->Mesh.HasKnownNeighbors = false;
  this->Border.clear();
  this->Hanging = HangingFaces();
}

// Return the centre of a face's cell.
dvec3 RayCastMeshBuilder::GetInside(size_t face) const
{
  const VolumeCells::Cell& cell = this->Kept[this->GetCell(face)];
  const int count = this->Cells.GetNumberOfCorners(cell);
  dvec3 sum(0.0);
  for (int i = 0; i < count; ++i)
  {
    sum += this->Cells.GetPoints()[this->Cells.GetCornerId(cell, i)];
  }
  return sum / static_cast<double>(count);
}

std::vector<bool> RayCastMeshBuilder::FindHanging()
{
  if (this->Mesh.HasQuadraticCells) // their edges are curved
  {
    return {};
  }
  std::vector<Face> faces;
  if (this->Mesh.IsDiscontinuous)
  {
    faces = this->FindFacesOfPlaces();
  }
  this->Hanging.Find({ this->Mesh.IsDiscontinuous ? faces : this->Faces,
                       [this](int point) { return this->Cells.GetPoints()[this->OldIds[point]]; },
                       [this](size_t face) { return this->GetInside(face); } },
    this->Border);
  if (this->Hanging.IsEmpty())
  {
    return {};
  }
  std::vector<std::uint32_t> none;
  const HangingRecords records(this->Hanging, this->PlaceOfPoints, none);
  std::vector<bool> found(this->Cells.GetCells().size(), false);
  bool isFound = false;
  const auto add = [&](size_t tetrahedron)
  {
    found[this->KeptTetrahedra[tetrahedron]] = true;
    isFound = true;
  };
  for (size_t i = 0; i < this->KeptTetrahedra.size(); ++i)
  {
    if (records.HasPoints(this->GetTetrahedron(i)))
    {
      add(i);
    }
  }
  for (const HangingFaces::Cover& cover : this->Hanging.GetCovers())
  {
    if (this->GetCell(cover.Face) < this->KeptTetrahedra.size())
    {
      add(this->GetCell(cover.Face));
    }
  }
  return isFound ? found : std::vector<bool>();
}

void RayCastMeshBuilder::FindNeighbors()
{
  this->Mesh.HasHangingFaces = !this->Hanging.IsEmpty();
  this->Mesh.IsDiscontinuous = this->Mesh.IsDiscontinuous || this->Mesh.HasHangingFaces;
  for (size_t i = 0; i < this->KeptTetrahedra.size() && this->Mesh.IsDiscontinuous &&
       this->Mesh.Corners.size() < 4 * this->KeptTetrahedra.size();
       ++i)
  {
    const auto corners = this->GetTetrahedron(i);
    this->Mesh.Corners.insert(this->Mesh.Corners.end(), corners.begin(), corners.end());
  }
  this->Mesh.Neighbors.resize(4 * this->Mesh.GetNumberOfTetrahedra());
  for (size_t face = 0; face < this->Faces.size(); ++face)
  {
    const auto other = this->Match.Others[face];
    this->GetBehind(face) =
      other < 0 ? RayCastMesh::InvalidCell : this->GetNeighbor(face, static_cast<size_t>(other));
  }
}

// Return a face that an adjacent larger cell has as a part.
HangingRecords::Part RayCastMeshBuilder::GetPart(size_t face) const
{
  const std::uint32_t cell = this->GetCell(face);
  HangingRecords::Part part;
  const Face& corners = this->Faces[face];
  std::copy_if(corners.begin(), corners.end(), std::back_inserter(part.Corners),
    [](int corner) { return corner >= 0; });
  if (cell >= this->KeptTetrahedra.size())
  {
    part.Neighbor = 8 * cell;
    std::reverse(part.Corners.begin(), part.Corners.end());
    return part;
  }
  part.Neighbor = 8 * cell + static_cast<std::uint32_t>(face % 4);
  if (!this->FacesInwards(corners, cell))
  {
    std::swap(part.Corners[1], part.Corners[2]);
  }
  return part;
}

void RayCastMeshBuilder::AddHanging()
{
  if (this->Hanging.IsEmpty())
  {
    return;
  }
  std::vector<std::uint32_t> words = std::move(this->Mesh.CurvedCells);
  const size_t numberOfWords = words.size();
  HangingRecords records(this->Hanging, this->PlaceOfPoints, words);
  for (size_t first = 0; first < numberOfWords; first += RayCastMesh::WordsOfCurvedCell)
  {
    const std::uint32_t list = records.AddEdges(words.data() + first);
    words[first + 8] = list;
  }
  std::vector<bool> isInner(this->Faces.size(), false);
  std::vector<std::pair<size_t, std::uint32_t>> lists;
  for (const HangingFaces::Cover& cover : this->Hanging.GetCovers())
  {
    std::vector<HangingRecords::Part> parts;
    for (size_t part : cover.Parts)
    {
      isInner[part] = true;
      parts.push_back(this->GetPart(part));
    }
    isInner[cover.Face] = true;
    lists.push_back({ cover.Face, 8 * records.AddParts(parts) + RayCastMesh::SeveralCells });
  }
  this->Mesh.CurvedCells = std::move(words);
  this->Mesh.NumberOfListWords = this->Mesh.CurvedCells.size() - numberOfWords;
  for (size_t i = 0; i < lists.size(); ++i)
  {
    const HangingFaces::Cover& cover = this->Hanging.GetCovers()[i];
    this->GetBehind(cover.Face) = lists[i].second;
    for (size_t part : cover.Parts)
    {
      this->GetBehind(part) = 8 * this->GetCell(cover.Face);
    }
  }
  this->Border.erase(std::remove_if(this->Border.begin(), this->Border.end(),
                       [&](size_t face) { return isInner[face]; }),
    this->Border.end());
}

std::string RayCastMeshBuilder::DescribeSize() const
{
  if (this->Border.size() >= MaximumBorderFaces)
  {
    return "has more than 16 million boundary faces; extract a part of it";
  }
  if (this->Mesh.IsDiscontinuous &&
    std::max(this->Kept.size(), this->Mesh.CurvedCells.size() / 4) >= MaximumDiscontinuousCells)
  {
    return "has different values of cells at the same points, and more than 512 million cells; "
           "extract a part of it";
  }
  return "";
}

dvec3 RayCastMeshBuilder::GetPoint(std::uint32_t point) const
{
  const float* coordinates = &this->Mesh.Points[4 * static_cast<size_t>(point)];
  return dvec3(coordinates[0], coordinates[1], coordinates[2]);
}

// Return the box of a face. For a curved cell it is that of the cell, because quadratic faces leave
// the box of their corners.
FloatBox RayCastMeshBuilder::GetBox(size_t face) const
{
  FiniteBox box;
  const auto add = [&](const dvec3& point) { box.Add(&point.x); };
  const size_t inTetrahedra = 4 * this->Mesh.GetNumberOfTetrahedra();
  for (int point : this->Faces[face])
  {
    if (point >= 0)
    {
      add(this->GetPoint(static_cast<std::uint32_t>(point)));
    }
  }
  if (face >= inTetrahedra)
  {
    const size_t record = this->FaceCells[face - inTetrahedra] - inTetrahedra / 4;
    const std::uint32_t* words = &this->Mesh.CurvedCells[RayCastMesh::WordsOfCurvedCell * record];
    if (words[RayCastMesh::WordsOfCurvedCell - 1] == RayCastMesh::Quadratic)
    {
      const auto& corners =
        FindCellShape(VTK_QUADRATIC_TETRA)->QuadraticFaces[face - this->FirstFaces[record]];
      for (int i = 0; i < 3; ++i)
      {
        add(2.0 * this->GetPoint(words[corners[3 + i]]) -
          0.5 * (this->GetPoint(words[corners[i]]) + this->GetPoint(words[corners[(i + 1) % 3]])));
      }
    }
  }
  FloatBox rounded;
  for (int c = 0; c < 3; ++c)
  {
    const double half = 0.5 * box.GetSide(c);
    rounded.Low[c] = static_cast<float>(box.GetMiddle(c) - half);
    rounded.High[c] = static_cast<float>(box.GetMiddle(c) + half);
  }
  return rounded;
}

// Return whether the corners of a face are in order as seen by a ray that enters the tetrahedron.
bool RayCastMeshBuilder::FacesInwards(const Face& face, std::uint32_t tetrahedron) const
{
  std::array<std::uint32_t, 3> corners;
  std::copy(face.begin(), face.begin() + 3, corners.begin());
  const std::uint32_t last =
    this->Mesh.PointSums[tetrahedron] ^ corners[0] ^ corners[1] ^ corners[2];
  const dvec3 origin = this->GetPoint(corners[0]);
  const dvec3 normal =
    cross(this->GetPoint(corners[1]) - origin, this->GetPoint(corners[2]) - origin);
  return !(dot(normal, this->GetPoint(last) - origin) < 0.0);
}

void RayCastMeshBuilder::AddBorderFace(size_t face)
{
  const auto add = [this](const std::array<std::uint32_t, 4>& words)
  {
    for (std::uint32_t word : words)
    {
      this->Mesh.BorderFaces.push_back(word);
    }
  };
  const size_t inTetrahedra = 4 * this->Mesh.GetNumberOfTetrahedra();
  if (face >= inTetrahedra)
  {
    const std::uint32_t cell = this->FaceCells[face - inTetrahedra];
    const size_t record = cell - inTetrahedra / 4;
    add({ { static_cast<std::uint32_t>(face - this->FirstFaces[record]), 0, 0, cell } });
    return;
  }
  std::array<std::uint32_t, 3> corners;
  std::copy(this->Faces[face].begin(), this->Faces[face].begin() + 3, corners.begin());
  const std::uint32_t cell = static_cast<std::uint32_t>(face / 4);
  if (!this->FacesInwards(this->Faces[face], cell))
  {
    std::swap(corners[1], corners[2]);
  }
  add({ { corners[0], corners[1], corners[2], cell } });
}

void RayCastMeshBuilder::BuildBorder()
{
  std::vector<FloatBox> boxes;
  boxes.reserve(this->Border.size());
  for (size_t face : this->Border)
  {
    boxes.push_back(this->GetBox(face));
  }
  FloatBoxTree tree;
  tree.Build(boxes, MaximumFacesPerLeaf);
  this->Mesh.BorderTree = FlattenTree(tree, TreeMargin);
  for (int i : tree.GetItems())
  {
    this->AddBorderFace(this->Border[i]);
  }
}
}

bool RayCastMesh::Build(const VolumeCells& cells, int numberOfComponents, std::string& error,
  bool withCorners, bool withGradients, const MeshExtent* whole, RayCastMesh* known)
{
  const MeshExtent extent = whole ? *whole : MeshExtent::Of(cells, numberOfComponents);
  std::vector<bool> records;
  std::vector<bool> more;
  do
  {
    *this = RayCastMesh();
    RayCastMeshBuilder builder(cells, numberOfComponents, extent, records, *this);
    builder.MergePoints();
    if (withCorners || builder.IsDiscontinuous())
    {
      builder.KeepCorners();
    }
    if (whole || builder.IsDiscontinuous())
    {
      builder.SortPoints();
    }
    builder.StorePoints();
    builder.AddCells();
    const bool isTaken = known && builder.TakeNeighbors(*known);
    known = nullptr;
    if (!isTaken)
    {
      builder.FindMatches();
    }
    more = builder.FindHanging();
    if (isTaken && builder.HasHanging())
    {
      builder.ForgetNeighbors();
      builder.FindMatches();
      more = builder.FindHanging();
    }
    if (!more.empty()) // all of them are among the curved cells the next time
    {
      records.resize(more.size(), false);
      std::transform(records.begin(), records.end(), more.begin(), records.begin(),
        [](bool a, bool b) { return a || b; });
      continue;
    }
    builder.StoreScalars();
    if (withGradients)
    {
      builder.AddGradients();
    }
    if (!this->HasKnownNeighbors)
    {
      builder.FindNeighbors();
    }
    builder.AddHanging();
    error = builder.DescribeSize();
    if (!error.empty())
    {
      return false;
    }
    builder.BuildBorder();
    builder.KeepPointIds();
  } while (!more.empty());
  return true;
}

void RayCastMesh::SetPoints(const std::vector<dvec3>& points)
{
  this->Points.resize(4 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Points[4 * i + c] = static_cast<float>((points[i][c] - this->Center[c]) / this->Radius);
    }
  }
}

// Scale scalars to the range from 0 to 1, where floats are more precise than far from 0.
void RayCastMesh::SetScalars(const std::vector<Scalars>& scalars, int numberOfComponents,
  bool areOfCells, const MeshExtent& whole)
{
  for (int c = 0; c < MaximumComponents; ++c)
  {
    this->ScalarLow[c] = scalars.empty() ? 0.0 : whole.ScalarLow[c];
    this->ScalarHigh[c] = scalars.empty() ? 0.0 : whole.ScalarHigh[c];
    this->ScalarSize[c] = scalars.empty() ? 1.0 : whole.GetScalarSize(c);
  }
  const bool areInPoints = !areOfCells && numberOfComponents == 1;
  std::vector<float>& all = areOfCells ? this->CellScalars : this->PointScalars;
  all.clear();
  for (size_t i = 0; i < scalars.size(); ++i)
  {
    for (int c = 0; c < (numberOfComponents > 1 ? MaximumComponents : 1); ++c)
    {
      const float stored =
        static_cast<float>((scalars[i][c] - this->ScalarLow[c]) / this->ScalarSize[c]);
      if (areInPoints)
      {
        this->Points[4 * i + 3] = stored;
      }
      else
      {
        all.push_back(stored);
      }
    }
  }
}

void RayCastMesh::SetGradients(
  const std::vector<Gradients>& all, const std::vector<vtkIdType>& points, int numberOfComponents)
{
  this->PointGradients.clear();
  for (vtkIdType point : points)
  {
    for (int c = 0; c < numberOfComponents; ++c)
    {
      const dvec3 gradient = this->Radius / this->ScalarSize[c] * all[point][c];
      for (double value : { gradient.x, gradient.y, gradient.z, 0.0 })
      {
        this->PointGradients.push_back(static_cast<float>(value));
      }
    }
  }
}

void RayCastMesh::Release()
{
  RayCastMesh rest;
  rest.Center = this->Center;
  rest.Radius = this->Radius;
  rest.HalfSize = this->HalfSize;
  rest.LongestEdge = this->LongestEdge;
  rest.HasQuadraticCells = this->HasQuadraticCells;
  rest.HasPyramids = this->HasPyramids;
  rest.HasFoldedFaces = this->HasFoldedFaces;
  rest.IsDiscontinuous = this->IsDiscontinuous;
  rest.HasHangingFaces = this->HasHangingFaces;
  rest.NumberOfSharedFaces = this->NumberOfSharedFaces;
  rest.ScalarLow = this->ScalarLow;
  rest.ScalarSize = this->ScalarSize;
  rest.ScalarHigh = this->ScalarHigh;
  *this = std::move(rest);
}
}
