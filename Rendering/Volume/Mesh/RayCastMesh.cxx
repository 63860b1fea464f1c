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

bool IsQuadraticRecord(const std::uint32_t* words)
{
  return words[RayCastMesh::WordsOfCurvedCell - 1] == RayCastMesh::Quadratic;
}

// The steps to build a mesh, with their intermediate data. Faces are not stored. They are numbered:
// four of each tetrahedron, then six of each curved cell, of which quadratic cells have four.
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
  void OrderCells();
  void MergePoints();
  bool IsDiscontinuous() const { return this->Mesh.IsDiscontinuous; }
  void SortPoints();
  void SetPlacement();
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
  static constexpr size_t FacesOfRecord = 6;
  static constexpr std::uint32_t NoMatch = RayCastMesh::InvalidCell;

  bool HasCellScalars() const { return this->NumberOfKept > 0 && this->GetKept(0).Scalars >= 0; }
  VolumeCells::Cell GetKept(size_t cell) const
  {
    return this->Cells.GetCells()[this->Order.empty() ? cell : this->Order[cell]];
  }
  std::uint32_t GetPointId(const VolumeCells::Cell& cell, int i) const
  {
    return this->NewIds[this->Cells.GetCornerId(cell, i)];
  }
  size_t GetNumberOfFaces() const
  {
    return 4 * this->NumberOfTetrahedra +
      FacesOfRecord * (this->NumberOfKept - this->NumberOfTetrahedra);
  }
  /// Return the words of the curved cell of a face.
  const std::uint32_t* GetRecordOf(size_t face) const
  {
    return this->Mesh.CurvedCells.data() +
      RayCastMesh::WordsOfCurvedCell * (this->GetCell(face) - this->NumberOfTetrahedra);
  }
  bool IsInTetrahedra(size_t face) const { return face < 4 * this->NumberOfTetrahedra; }
  /// Return the number of a face in its cell.
  size_t GetSide(size_t face) const
  {
    return this->IsInTetrahedra(face) ? face % 4
                                      : (face - 4 * this->NumberOfTetrahedra) % FacesOfRecord;
  }
  /// Return whether the cell has the face.
  bool Exists(size_t face) const
  {
    return this->IsInTetrahedra(face) || this->GetSide(face) < 4 ||
      !IsQuadraticRecord(this->GetRecordOf(face));
  }
  /// Return the corners of a face, which are -1 if the cell does not have it.
  Face GetFace(size_t face) const;
  /// Return the face with places instead of points. Faces with several points at one place match no
  /// other face.
  Face GetFaceOfPlaces(size_t face) const;

  std::array<std::uint32_t, 4> GetTetrahedron(size_t index) const;
  dvec3 GetInside(size_t face) const;
  HangingRecords::Part GetPart(size_t face) const;
  void NumberPoints(const std::vector<vtkIdType>& firsts);
  bool HasSeveralPointsAtOnePlace() const;
  void AddTetrahedron(const VolumeCells::Cell& cell);
  void AddCurved(const VolumeCells::Cell& cell);
  bool IsMirrored(const VolumeCells::Cell& cell) const;
  bool IsFlat(const VolumeCells::Cell& cell) const;
  void FindPlaces();
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
  RayCastMesh& Mesh;
  size_t NumberOfKept = 0;
  size_t NumberOfTetrahedra = 0;     // of these
  std::vector<std::uint32_t> Order;  // indices of the cells; empty if their order stays
  std::vector<std::uint32_t> NewIds; // of the cells' points
  std::vector<std::uint32_t> OldIds; // of the mesh's points
  std::vector<vtkIdType> Places;     // of the cells' points: the first point there
  std::vector<size_t> Border;        // faces
  std::vector<int> PlaceOfPoints;    // of the mesh's points: the first point there
  HangingFaces Hanging;
};

// Tetrahedra come first, because the walk identifies them by their index.
void RayCastMeshBuilder::OrderCells()
{
  const VolumeCellList& cells = this->Cells.GetCells();
  this->NumberOfKept = cells.size();
  for (const bool isCurved : { false, true })
  {
    for (size_t i = 0; i < cells.size(); ++i)
    {
      const bool isRecord = cells[i].Shape || (!this->Records.empty() && this->Records[i]);
      if (isRecord == isCurved)
      {
        this->Order.push_back(static_cast<std::uint32_t>(i));
      }
    }
    if (isCurved)
    {
      break;
    }
    this->NumberOfTetrahedra = this->Order.size();
    if (this->Order.size() == cells.size() || this->Order.empty())
    {
      std::vector<std::uint32_t>().swap(this->Order); // cells of one kind
      break;
    }
  }
}

// Number the points of cells. Points with the same first point are merged; the list is empty if
// there are none.
void RayCastMeshBuilder::NumberPoints(const std::vector<vtkIdType>& firsts)
{
  this->NewIds.assign(this->Cells.GetPoints().size(), Unused);
  this->OldIds.clear();
  this->OldIds.reserve(this->Cells.GetPoints().size());
  for (size_t i = 0; i < this->NumberOfKept; ++i)
  {
    const VolumeCells::Cell cell = this->GetKept(i);
    for (int corner = 0; corner < this->Cells.GetNumberOfCorners(cell); ++corner)
    {
      const vtkIdType point = this->Cells.GetCornerId(cell, corner);
      const vtkIdType first = firsts.empty() ? point : firsts[static_cast<size_t>(point)];
      if (this->NewIds[first] == Unused)
      {
        this->NewIds[first] = static_cast<std::uint32_t>(this->OldIds.size());
        this->OldIds.push_back(static_cast<std::uint32_t>(first));
      }
      this->NewIds[point] = this->NewIds[first];
    }
  }
}

bool RayCastMeshBuilder::HasSeveralPointsAtOnePlace() const
{
  std::vector<bool> isTaken(this->Places.size(), false);
  for (size_t i = 0; i < this->OldIds.size() && !this->Places.empty(); ++i)
  {
    const size_t place = static_cast<size_t>(this->Places[this->OldIds[i]]);
    if (isTaken[place])
    {
      return true;
    }
    isTaken[place] = true;
  }
  return false;
}

// Discontinuous scalars of tetrahedra are stored at their corners, so that points can be merged.
void RayCastMeshBuilder::MergePoints()
{
  MergedCellPoints merged = MergeCellPoints(this->Cells);
  this->NumberPoints(merged.Points);
  this->Places = std::move(merged.Places);
  this->Mesh.IsDiscontinuous = this->HasSeveralPointsAtOnePlace();
  if (this->Mesh.IsDiscontinuous && this->NumberOfTetrahedra == this->NumberOfKept)
  {
    this->Mesh.IsDiscontinuous = false;
    this->Mesh.HasCornerScalars = true;
    this->NumberPoints(this->Places);
  }
}

// Coincident points are not merged if their scalars differ, which then decide.
void RayCastMeshBuilder::SortPoints()
{
  const std::vector<dvec3>& points = this->Cells.GetPoints();
  const ScalarTable& scalars = this->Cells.GetPointScalars();
  const auto getPosition = [&](std::uint32_t id)
  { return std::tie(points[id].x, points[id].y, points[id].z); };
  std::sort(this->OldIds.begin(), this->OldIds.end(),
    [&](std::uint32_t a, std::uint32_t b)
    {
      const auto here = getPosition(a);
      const auto there = getPosition(b);
      return here < there || (!(there < here) && scalars[a] < scalars[b]);
    });
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

void RayCastMeshBuilder::SetPlacement()
{
  const FiniteBox& box = this->Whole.Points;
  this->Mesh.Center = dvec3(box.GetMiddle(0), box.GetMiddle(1), box.GetMiddle(2));
  this->Mesh.Radius = this->Whole.GetRadius();
  this->Mesh.LongestEdge = this->Whole.LongestEdge / this->Mesh.Radius;
  this->Mesh.HalfSize =
    dvec3(box.GetSide(0), box.GetSide(1), box.GetSide(2)) / (2.0 * this->Mesh.Radius);
}

void RayCastMeshBuilder::StorePoints()
{
  this->Mesh.SetPoints(
    this->OldIds.size(), [this](size_t i) { return this->Cells.GetPoints()[this->OldIds[i]]; });
}

void RayCastMeshBuilder::StoreScalars()
{
  if (this->Mesh.HasCornerScalars)
  {
    this->Mesh.SetScalars(
      this->Mesh.CornerIds.size(),
      [this](size_t i) { return this->Cells.GetPointScalars()[this->Mesh.CornerIds[i]]; },
      this->NumberOfComponents, RayCastMesh::ScalarOwner::Corners, this->Whole);
    return;
  }
  if (!this->HasCellScalars())
  {
    this->Mesh.SetScalars(
      this->OldIds.size(),
      [this](size_t i) { return this->Cells.GetPointScalars()[this->OldIds[i]]; },
      this->NumberOfComponents, RayCastMesh::ScalarOwner::Points, this->Whole);
    return;
  }
  this->Mesh.CellIds.reserve(this->NumberOfKept);
  for (size_t i = 0; i < this->NumberOfKept; ++i)
  {
    this->Mesh.CellIds.push_back(this->GetKept(i).Scalars);
  }
  this->Mesh.SetScalars(
    this->NumberOfKept,
    [this](size_t i) { return this->Cells.GetCellScalars()[this->Mesh.CellIds[i]]; },
    this->NumberOfComponents, RayCastMesh::ScalarOwner::Cells, this->Whole);
}

void RayCastMeshBuilder::AddGradients()
{
  if (this->HasCellScalars())
  {
    return;
  }
  const std::vector<dvec3> all =
    ComputePointGradients(this->Cells, MergeCellPoints(this->Cells), this->NumberOfComponents);
  const std::vector<std::uint32_t>& sources =
    this->Mesh.HasCornerScalars ? this->Mesh.CornerIds : this->OldIds;
  this->Mesh.SetGradients(
    sources.size(),
    [&](size_t i) { return &all[static_cast<size_t>(this->NumberOfComponents) * sources[i]]; },
    this->NumberOfComponents);
}

void RayCastMeshBuilder::AddTetrahedron(const VolumeCells::Cell& cell)
{
  std::array<std::pair<std::uint32_t, std::uint32_t>, 4> points; // here, and of the cells
  for (int i = 0; i < 4; ++i)
  {
    points[i] = { this->GetPointId(cell, i),
      static_cast<std::uint32_t>(this->Cells.GetCornerId(cell, i)) };
  }
  std::sort(points.begin(), points.end());
  std::uint32_t sum = 0;
  for (const auto& point : points)
  {
    sum ^= point.first;
    this->Mesh.Corners.push_back(point.first);
    if (this->Mesh.HasCornerScalars)
    {
      this->Mesh.CornerIds.push_back(point.second);
    }
  }
  this->Mesh.PointSums.push_back(sum);
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
}

void RayCastMeshBuilder::AddCells()
{
  this->Mesh.PointSums.reserve(this->NumberOfTetrahedra);
  this->Mesh.Corners.reserve(4 * this->NumberOfTetrahedra);
  this->Mesh.CurvedCells.reserve(
    RayCastMesh::WordsOfCurvedCell * (this->NumberOfKept - this->NumberOfTetrahedra));
  for (size_t i = 0; i < this->NumberOfKept; ++i)
  {
    const VolumeCells::Cell cell = this->GetKept(i);
    i < this->NumberOfTetrahedra ? this->AddTetrahedron(cell) : this->AddCurved(cell);
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

Face RayCastMeshBuilder::GetFace(size_t face) const
{
  const size_t side = this->GetSide(face);
  if (this->IsInTetrahedra(face)) // the side is the missing corner
  {
    const std::uint32_t* points = &this->Mesh.Corners[face / 4 * 4];
    return { { static_cast<int>(points[side == 0 ? 1 : 0]),
      static_cast<int>(points[side <= 1 ? 2 : 1]), static_cast<int>(points[side <= 2 ? 3 : 2]),
      -1 } };
  }
  if (!this->Exists(face))
  {
    return { { -1, -1, -1, -1 } };
  }
  const std::uint32_t* words = this->GetRecordOf(face);
  const Face& corners = GetRecordFaces(IsQuadraticRecord(words))[side];
  const auto get = [&](int i) { return static_cast<int>(words[corners[i]]); };
  return { { get(0), get(1), get(2), corners[3] == corners[2] ? -1 : get(3) } };
}

Face RayCastMeshBuilder::GetFaceOfPlaces(size_t face) const
{
  const Face points = this->GetFace(face);
  Face found = points;
  for (int& corner : found)
  {
    corner = corner < 0 ? corner : this->PlaceOfPoints[static_cast<size_t>(corner)];
  }
  for (size_t i = 0; i < 16; ++i)
  {
    if (found[i / 4] >= 0 && found[i / 4] == found[i % 4] && points[i / 4] != points[i % 4])
    {
      return { { 0, 0, 0, -1 } };
    }
  }
  return found;
}

// Return the index of a face's cell.
std::uint32_t RayCastMeshBuilder::GetCell(size_t face) const
{
  return static_cast<std::uint32_t>(this->IsInTetrahedra(face)
      ? face / 4
      : this->NumberOfTetrahedra + (face - 4 * this->NumberOfTetrahedra) / FacesOfRecord);
}

// Return the entry in RayCastMesh::Neighbors for a face and the matching face of another cell.
std::uint32_t RayCastMeshBuilder::GetNeighbor(size_t face, size_t other) const
{
  const std::uint32_t cell = this->GetCell(other);
  if (!this->Mesh.IsDiscontinuous)
  {
    return cell;
  }
  Face here = this->GetFace(face);
  Face there = this->GetFace(other);
  std::sort(here.begin(), here.end());
  std::sort(there.begin(), there.end());
  const std::uint32_t side =
    this->IsInTetrahedra(other) ? static_cast<std::uint32_t>(this->GetSide(other)) : 0;
  return 8 * cell + (here == there ? RayCastMesh::SamePoints : side);
}

// Return a reference to the index of the cell behind a face.
std::uint32_t& RayCastMeshBuilder::GetBehind(size_t face)
{
  if (this->IsInTetrahedra(face))
  {
    return this->Mesh.Neighbors[face];
  }
  const size_t record = this->GetCell(face) - this->NumberOfTetrahedra;
  return this->Mesh.CurvedCells[RayCastMesh::WordsOfCurvedCell * record +
    RayCastMesh::FirstNeighborWord + this->GetSide(face)];
}

// Return whether the cells of two matching faces have the same points. Then both are on the same
// side of the face.
bool RayCastMeshBuilder::AreDuplicates(size_t face, size_t other) const
{
  if (this->GetCell(face) == this->GetCell(other) ||
    this->IsInTetrahedra(face) != this->IsInTetrahedra(other))
  {
    return false;
  }
  if (this->IsInTetrahedra(face))
  {
    const auto getLast = [this](size_t of) // the missing corner
    { return this->GetPoint(this->Mesh.Corners[of]); };
    return getLast(face) == getLast(other);
  }
  const std::uint32_t* here = this->GetRecordOf(face);
  const std::uint32_t* there = this->GetRecordOf(other);
  const int count = IsQuadraticRecord(here) ? 10 : 8;
  return IsQuadraticRecord(here) == IsQuadraticRecord(there) &&
    std::all_of(here, here + count,
      [&](std::uint32_t point)
      {
        return std::any_of(there, there + count,
          [&](std::uint32_t candidate)
          { return point == candidate || this->GetPoint(point) == this->GetPoint(candidate); });
      });
}

// Until FindNeighbors(), the matching faces are stored in place of the cells behind faces.
void RayCastMeshBuilder::FindMatches()
{
  if (this->Mesh.IsDiscontinuous)
  {
    this->FindPlaces();
  }
  this->Mesh.Neighbors.assign(4 * this->NumberOfTetrahedra, NoMatch);
  const size_t numberOfFaces = this->GetNumberOfFaces();
  for (size_t face = this->Mesh.Neighbors.size(); face < numberOfFaces; ++face)
  {
    if (this->Exists(face))
    {
      this->GetBehind(face) = NoMatch;
    }
  }
  const FaceSource source = { numberOfFaces,
    [this](size_t begin, size_t end, Face* faces)
    {
      for (size_t face = begin; face < end; ++face, ++faces)
      {
        *faces = this->Mesh.IsDiscontinuous ? this->GetFaceOfPlaces(face) : this->GetFace(face);
      }
    } };
  this->Mesh.NumberOfSharedFaces = MatchFaces(source, static_cast<int>(this->OldIds.size()),
    [this](size_t face, size_t other)
    { this->GetBehind(face) = static_cast<std::uint32_t>(other); });
  for (size_t face = 0; face < numberOfFaces; ++face)
  {
    if (!this->Exists(face))
    {
      continue;
    }
    std::uint32_t& other = this->GetBehind(face);
    if (other != NoMatch && other > face && this->AreDuplicates(face, other))
    {
      ++this->Mesh.NumberOfSharedFaces;
      this->GetBehind(other) = NoMatch;
      other = NoMatch;
    }
    if (other == NoMatch && IsFace(this->GetFace(face)))
    {
      this->Border.push_back(face);
    }
  }
}

// Return the points of a tetrahedron in ascending order.
std::array<std::uint32_t, 4> RayCastMeshBuilder::GetTetrahedron(size_t index) const
{
  const std::uint32_t* points = &this->Mesh.Corners[4 * index];
  return { { points[0], points[1], points[2], points[3] } };
}

// Return whether another mesh has the same cells of the same points. Its corners are known.
bool RayCastMeshBuilder::HasCellsOf(const RayCastMesh& known) const
{
  if (known.Corners != this->Mesh.Corners ||
    known.CurvedCells.size() != this->Mesh.CurvedCells.size())
  {
    return false;
  }
  for (size_t i = 0; i < known.CurvedCells.size(); i += RayCastMesh::WordsOfCurvedCell)
  {
    const std::uint32_t* here = this->Mesh.CurvedCells.data() + i;
    const std::uint32_t* there = known.CurvedCells.data() + i;
    if (!std::equal(here, here + RayCastMesh::FirstNeighborWord, there) ||
      IsQuadraticRecord(here) != IsQuadraticRecord(there))
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
  for (size_t face = 0; face < this->GetNumberOfFaces(); ++face)
  {
    if (this->Exists(face) && this->GetBehind(face) == RayCastMesh::InvalidCell &&
      IsFace(this->GetFace(face)))
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
  const VolumeCells::Cell cell = this->GetKept(this->GetCell(face));
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
  this->Hanging.Find(
    { [this](size_t face)
      { return this->Mesh.IsDiscontinuous ? this->GetFaceOfPlaces(face) : this->GetFace(face); },
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
    found[this->Order.empty() ? tetrahedron : this->Order[tetrahedron]] = true;
    isFound = true;
  };
  for (size_t i = 0; i < this->NumberOfTetrahedra; ++i)
  {
    if (records.HasPoints(this->GetTetrahedron(i)))
    {
      add(i);
    }
  }
  for (const HangingFaces::Cover& cover : this->Hanging.GetCovers())
  {
    if (this->IsInTetrahedra(cover.Face))
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
  const size_t numberOfFaces = this->GetNumberOfFaces();
  for (size_t face = 0; face < numberOfFaces; ++face)
  {
    if (this->Exists(face) && this->GetBehind(face) != NoMatch)
    {
      this->GetBehind(face) = this->GetNeighbor(face, this->GetBehind(face));
    }
  }
}

// Return a face that an adjacent larger cell has as a part.
HangingRecords::Part RayCastMeshBuilder::GetPart(size_t face) const
{
  const std::uint32_t cell = this->GetCell(face);
  HangingRecords::Part part;
  const Face corners = this->GetFace(face);
  std::copy_if(corners.begin(), corners.end(), std::back_inserter(part.Corners),
    [](int corner) { return corner >= 0; });
  if (!this->IsInTetrahedra(face))
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
  std::vector<std::uint32_t>& words = this->Mesh.CurvedCells;
  const size_t numberOfWords = words.size();
  HangingRecords records(this->Hanging, this->PlaceOfPoints, words);
  for (size_t first = 0; first < numberOfWords; first += RayCastMesh::WordsOfCurvedCell)
  {
    std::array<std::uint32_t, 8> corners;
    std::copy_n(words.begin() + first, corners.size(), corners.begin());
    const std::uint32_t list = records.AddEdges(corners);
    words[first + 8] = list;
  }
  std::vector<bool> isInner(this->GetNumberOfFaces(), false);
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
  this->Mesh.NumberOfListWords = words.size() - numberOfWords;
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
    std::max(this->NumberOfKept, this->Mesh.CurvedCells.size() / 4) >= MaximumDiscontinuousCells)
  {
    return "has different values of cells at the same points, and more than 512 million cells; "
           "extract a part of it";
  }
  return "";
}

// Return a point as it is stored.
dvec3 RayCastMeshBuilder::GetPoint(std::uint32_t point) const
{
  return this->Mesh.GetStored(this->Cells.GetPoints()[this->OldIds[point]]);
}

// Return the box of a face. For a curved cell it is that of the cell, because quadratic faces leave
// the box of their corners.
FloatBox RayCastMeshBuilder::GetBox(size_t face) const
{
  FiniteBox box;
  const auto add = [&](const dvec3& point) { box.Add(&point.x); };
  for (int point : this->GetFace(face))
  {
    if (point >= 0)
    {
      add(this->GetPoint(static_cast<std::uint32_t>(point)));
    }
  }
  if (!this->IsInTetrahedra(face))
  {
    const std::uint32_t* words = this->GetRecordOf(face);
    if (IsQuadraticRecord(words))
    {
      const auto& corners = FindCellShape(VTK_QUADRATIC_TETRA)->QuadraticFaces[this->GetSide(face)];
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
  const std::uint32_t cell = this->GetCell(face);
  if (!this->IsInTetrahedra(face))
  {
    add({ { static_cast<std::uint32_t>(this->GetSide(face)), 0, 0, cell } });
    return;
  }
  const Face here = this->GetFace(face);
  std::array<std::uint32_t, 3> corners;
  std::copy(here.begin(), here.begin() + 3, corners.begin());
  if (!this->FacesInwards(here, cell))
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
    builder.OrderCells();
    builder.MergePoints();
    if (whole || builder.IsDiscontinuous())
    {
      builder.SortPoints();
    }
    builder.SetPlacement();
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
    if (!withCorners && !this->IsDiscontinuous)
    {
      std::vector<std::uint32_t>().swap(this->Corners);
    }
    builder.StorePoints();
    builder.StoreScalars();
    if (withGradients)
    {
      builder.AddGradients();
    }
    builder.KeepPointIds();
  } while (!more.empty());
  return true;
}

void RayCastMesh::SetPoints(size_t count, const std::function<dvec3(size_t)>& get)
{
  this->Points.resize(4 * count);
  for (size_t i = 0; i < count; ++i)
  {
    const dvec3 point = this->GetStored(get(i));
    for (int c = 0; c < 3; ++c)
    {
      this->Points[4 * i + c] = static_cast<float>(point[c]);
    }
  }
}

dvec3 RayCastMesh::GetStored(const dvec3& point) const
{
  dvec3 stored;
  for (int c = 0; c < 3; ++c)
  {
    // Volatile, because GCC 12 does not round where it computes two coordinates at a time.
    const volatile float rounded = static_cast<float>((point[c] - this->Center[c]) / this->Radius);
    stored[c] = rounded;
  }
  return stored;
}

// Scale scalars to the range from 0 to 1, where floats are more precise than far from 0.
void RayCastMesh::SetScalars(size_t count, const std::function<Scalars(size_t)>& get,
  int numberOfComponents, ScalarOwner owner, const MeshExtent& whole)
{
  for (int c = 0; c < MaximumComponents; ++c)
  {
    this->ScalarLow[c] = count == 0 ? 0.0 : whole.ScalarLow[c];
    this->ScalarHigh[c] = count == 0 ? 0.0 : whole.ScalarHigh[c];
    this->ScalarSize[c] = count == 0 ? 1.0 : whole.GetScalarSize(c);
  }
  const bool areInPoints = owner == ScalarOwner::Points && numberOfComponents == 1;
  const int width = numberOfComponents > 1 ? MaximumComponents : 1;
  std::vector<float>& all = owner == ScalarOwner::Cells ? this->CellScalars
    : owner == ScalarOwner::Corners                     ? this->CornerScalars
                                                        : this->PointScalars;
  all.clear();
  all.reserve(areInPoints ? 0 : static_cast<size_t>(width) * count);
  for (size_t i = 0; i < count; ++i)
  {
    const Scalars scalars = get(i);
    for (int c = 0; c < width; ++c)
    {
      const float stored =
        static_cast<float>((scalars[c] - this->ScalarLow[c]) / this->ScalarSize[c]);
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
  size_t count, const std::function<const dvec3*(size_t)>& get, int numberOfComponents)
{
  this->PointGradients.clear();
  this->PointGradients.reserve(4 * static_cast<size_t>(numberOfComponents) * count);
  for (size_t i = 0; i < count; ++i)
  {
    const dvec3* all = get(i);
    for (int c = 0; c < numberOfComponents; ++c)
    {
      const dvec3 gradient = this->Radius / this->ScalarSize[c] * all[c];
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
  rest.HasCornerScalars = this->HasCornerScalars;
  rest.NumberOfSharedFaces = this->NumberOfSharedFaces;
  rest.ScalarLow = this->ScalarLow;
  rest.ScalarSize = this->ScalarSize;
  rest.ScalarHigh = this->ScalarHigh;
  *this = std::move(rest);
}
}
