// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementMesh.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDisplacement.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointPlaces.h"
#include "vtkPolyData.h"
#include "vtkRefinementSurface.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace relevo
{
namespace
{
using Vector = std::array<double, 3>;

Vector load(const float* v)
{
  return { v[0], v[1], v[2] };
}

Vector subtract(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector cross(const Vector& a, const Vector& b)
{
  Vector c;
  vtkMath::Cross(a.data(), b.data(), c.data());
  return c;
}

double dot(const Vector& a, const Vector& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

double angle(const Vector& a, const Vector& b)
{
  const Vector c = cross(a, b);
  return std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

bool isFinite(const float* v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

// The numbers 0 to n - 1 in the order of their keys (arrays of ints); equal keys keep theirs.
// Counts by the keys' first elements, which are below `limit`: few share each.
template <typename GetKey>
std::vector<int> sortByKey(size_t n, int limit, const GetKey& getKey)
{
  std::vector<int> starts(static_cast<size_t>(limit) + 1, 0);
  for (size_t i = 0; i < n; ++i)
  {
    ++starts[getKey(static_cast<int>(i))[0] + 1];
  }
  for (int k = 0; k < limit; ++k)
  {
    starts[k + 1] += starts[k];
  }
  std::vector<int> sorted(n);
  std::vector<int> next(starts.begin(), starts.end() - 1);
  for (size_t i = 0; i < n; ++i)
  {
    sorted[next[getKey(static_cast<int>(i))[0]]++] = static_cast<int>(i);
  }
  vtkSMPTools::For(0, limit,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        std::sort(sorted.begin() + starts[k], sorted.begin() + starts[k + 1],
          [&getKey](int l, int r)
          { return std::make_pair(getKey(l), l) < std::make_pair(getKey(r), r); });
      }
    });
  return sorted;
}
}

const std::array<int, 3>& GetCornerOrder(int code)
{
  static const std::array<std::array<int, 3>, 6> orders = { { { { 0, 1, 2 } }, { { 1, 0, 2 } },
    { { 1, 2, 0 } }, { { 0, 2, 1 } }, { { 2, 0, 1 } }, { { 2, 1, 0 } } } };
  return orders[code];
}

int GetCornerOrderCode(int first, int second, int third)
{
  const std::array<int, 3> order = { { first, second, third } };
  int code = 0;
  while (GetCornerOrder(code) != order)
  {
    ++code;
  }
  return code;
}

bool RefinementMesh::Build(vtkPolyData* input, vtkAdaptiveRefinement* recipe, bool keepNormals)
{
  *this = RefinementMesh();
  if (input->GetNumberOfCells() == 0)
  {
    return true;
  }
  if (!this->CheckCells(input))
  {
    return false;
  }
  this->NumberOfPoints = static_cast<int>(input->GetNumberOfPoints());
  this->Places = ComputePlaces(input->GetPoints());
  this->BuildPoints(input);
  this->BuildFaces(input);

  vtkRefinementSurface* surface = recipe->GetSurface();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  if (displacement || (surface && surface->NeedsNormals()) ||
    (keepNormals && input->GetPointData()->GetNormals()))
  {
    this->BuildNormals(input);
    if (!this->Places.empty())
    {
      this->BuildDirections();
    }
  }
  if (!this->Places.empty() && !this->Faces.empty())
  {
    this->BuildPlaceEdges();
  }
  if (displacement)
  {
    if (displacement->GetHeightMap() && !this->Faces.empty() &&
      !this->BuildTextureCoordinates(input))
    {
      return false;
    }
    this->BuildFrames(displacement->IsAlongNormal());
    if (!this->Places.empty())
    {
      this->BuildSeams();
    }
  }
  if (surface)
  {
    this->BuildVectors(surface);
  }
  return true;
}

void RefinementMesh::BuildPoints(vtkPolyData* input)
{
  vtkDataArray* data = input->GetPoints()->GetData();
  if (data->GetDataType() != VTK_FLOAT)
  {
    // Floats near the middle of the mesh keep the digits that large coordinates would cost.
    double bounds[6];
    vtkMath::UninitializeBounds(bounds);
    double point[3];
    for (vtkIdType i = 0; i < this->NumberOfPoints; ++i)
    {
      data->GetTuple(i, point);
      for (int c = 0; c < 3; ++c)
      {
        if (std::isfinite(point[c]))
        {
          const bool first = bounds[2 * c] > bounds[2 * c + 1];
          bounds[2 * c] = first ? point[c] : std::min(bounds[2 * c], point[c]);
          bounds[2 * c + 1] = first ? point[c] : std::max(bounds[2 * c + 1], point[c]);
        }
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      const double middle = 0.5 * bounds[2 * c] + 0.5 * bounds[2 * c + 1];
      this->Origin[c] = bounds[2 * c] <= bounds[2 * c + 1] ? middle : 0.0;
    }
  }
  this->Points.resize(3 * static_cast<size_t>(this->NumberOfPoints));
  vtkSMPTools::For(0, this->NumberOfPoints,
    [this, data](vtkIdType begin, vtkIdType end)
    {
      double point[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        data->GetTuple(i, point);
        for (int c = 0; c < 3; ++c)
        {
          // Adding zero makes -0 a plain 0, the same bits for the same place.
          this->Points[3 * i + c] = static_cast<float>(point[c] - this->Origin[c]) + 0.0f;
        }
      }
    });
}

bool RefinementMesh::CheckCells(vtkPolyData* input)
{
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  // Triangles are numbered in 29 bits: see PatternSelection::Instances.
  constexpr vtkIdType mostTriangles = (vtkIdType(1) << 29) - 1;
  vtkIdType numberOfTriangles = 0;
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    numberOfTriangles += cells->GetNumberOfConnectivityIds();
  }
  if (numberOfPoints > std::numeric_limits<int>::max() ||
    input->GetNumberOfCells() > std::numeric_limits<int>::max() ||
    numberOfTriangles > 3 * mostTriangles)
  {
    this->Error = "the mesh has more points, cells or triangles than can be numbered";
    return false;
  }
  vtkIdType cell = 0;
  for (vtkCellArray* cells :
    { input->GetVerts(), input->GetLines(), input->GetPolys(), input->GetStrips() })
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      iterator->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (ids[i] < 0 || ids[i] >= numberOfPoints)
        {
          this->Error = "cell " + std::to_string(cell) + " refers to point " +
            std::to_string(ids[i]) + " of " + std::to_string(numberOfPoints);
          return false;
        }
      }
      ++cell;
    }
  }
  return true;
}

void RefinementMesh::BuildFaces(vtkPolyData* input)
{
  auto addTriangle = [&](vtkIdType a, vtkIdType b, vtkIdType c, int cell, const bool hidden[3])
  {
    const vtkIdType ids[3] = { a, b, c };
    int places[3];
    for (int i = 0; i < 3; ++i)
    {
      places[i] = this->GetPlace(static_cast<int>(ids[i]));
    }
    if (places[0] == places[1] || places[1] == places[2] || places[0] == places[2] ||
      !isFinite(&this->Points[3 * a]) || !isFinite(&this->Points[3 * b]) ||
      !isFinite(&this->Points[3 * c]))
    {
      ++this->NumberOfDroppedTriangles;
      return;
    }
    int order[3] = { 0, 1, 2 };
    std::sort(order, order + 3, [&places](int l, int r) { return places[l] < places[r]; });
    RefinementFace face;
    face.Cell = cell;
    face.Order = static_cast<unsigned char>(GetCornerOrderCode(order[0], order[1], order[2]));
    face.HiddenEdges = 0;
    for (int i = 0; i < 3; ++i)
    {
      face.Corners[i] = static_cast<int>(ids[order[i]]);
      // The cell's own edge i joins its corners i and i + 1: it lacks corner i + 2.
      const int lacking = 3 - order[EdgeCorners[i][0]] - order[EdgeCorners[i][1]];
      face.HiddenEdges |= hidden[(lacking + 1) % 3] ? 1 << i : 0;
    }
    this->Faces.push_back(face);
  };

  int cell =
    static_cast<int>(input->GetVerts()->GetNumberOfCells() + input->GetLines()->GetNumberOfCells());
  this->Faces.reserve(static_cast<size_t>(input->GetPolys()->GetNumberOfConnectivityIds() -
    2 *
      std::min(input->GetPolys()->GetNumberOfCells(),
        input->GetPolys()->GetNumberOfConnectivityIds() / 2)));
  vtkIdType size;
  const vtkIdType* ids;
  auto polys = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell(), ++cell)
  {
    polys->GetCurrentCell(size, ids);
    this->NumberOfDroppedTriangles += size < 3 ? 1 : 0;
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      const bool hidden[3] = { i > 1, false, i + 2 < size };
      addTriangle(ids[0], ids[i], ids[i + 1], cell, hidden);
    }
  }
  auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    strips->GetCurrentCell(size, ids);
    this->NumberOfDroppedTriangles += size < 3 ? 1 : 0;
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const bool hidden[3] = { false, false, false };
      addTriangle(ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2], cell, hidden);
    }
  }
}

void RefinementMesh::BuildNormals(vtkPolyData* input)
{
  this->Normals.assign(3 * static_cast<size_t>(this->NumberOfPoints), 0.0f);
  vtkDataArray* given = input->GetPointData()->GetNormals();
  bool missing = true;
  if (given && given->GetNumberOfTuples() >= this->NumberOfPoints)
  {
    missing = false;
    for (vtkIdType i = 0; i < this->NumberOfPoints; ++i)
    {
      double normal[3];
      given->GetTuple(i, normal);
      const double length = vtkMath::Normalize(normal);
      if (std::isfinite(length) && length > 0.0)
      {
        std::copy_n(normal, 3, &this->Normals[3 * static_cast<size_t>(i)]);
      }
      else
      {
        missing = true;
      }
    }
  }
  if (missing)
  {
    this->ComputeMissingNormals();
  }
}

// Normals that are zero so far: those of the faces around, weighted by the angle at the place,
// whatever the triangulation (Thuermer and Wuethrich 1998).
void RefinementMesh::ComputeMissingNormals()
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  std::vector<double> sums(3 * n, 0.0);
  std::vector<double> firsts(3 * n, 0.0); // for places where the faces cancel each other
  for (const RefinementFace& face : this->Faces)
  {
    const auto& order = GetCornerOrder(face.Order);
    int corners[3];
    Vector p[3];
    for (int i = 0; i < 3; ++i)
    {
      corners[order[i]] = face.Corners[i];
      p[order[i]] = load(&this->Points[3 * static_cast<size_t>(face.Corners[i])]);
    }
    Vector normal = cross(subtract(p[1], p[0]), subtract(p[2], p[0]));
    vtkMath::Normalize(normal.data());
    for (int i = 0; i < 3; ++i)
    {
      const double weight = angle(subtract(p[(i + 1) % 3], p[i]), subtract(p[(i + 2) % 3], p[i]));
      const size_t place = 3 * static_cast<size_t>(this->GetPlace(corners[i]));
      const bool isFirst =
        std::all_of(&firsts[place], &firsts[place] + 3, [](double c) { return c == 0.0; });
      for (int c = 0; c < 3; ++c)
      {
        sums[place + c] += weight * normal[c];
        firsts[place + c] = isFirst ? normal[c] : firsts[place + c];
      }
    }
  }
  for (size_t i = 0; i < n; ++i)
  {
    float* normal = &this->Normals[3 * i];
    if (std::all_of(normal, normal + 3, [](float c) { return c == 0.0f; }))
    {
      const size_t place = 3 * static_cast<size_t>(this->GetPlace(static_cast<int>(i)));
      Vector sum = { sums[place], sums[place + 1], sums[place + 2] };
      constexpr double cancelled = 1e-9; // radians
      if (vtkMath::Normalize(sum.data()) < cancelled)
      {
        sum = { firsts[place], firsts[place + 1], firsts[place + 2] };
      }
      std::copy_n(sum.data(), 3, normal);
    }
  }
}

// One direction per place: where faces see different normals, their mean.
void RefinementMesh::BuildDirections()
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  std::vector<char> isCorner(n, 0);
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      isCorner[static_cast<size_t>(corner)] = 1;
    }
  }
  std::vector<float> directions(3 * n, 0.0f);
  std::vector<size_t> first(n, n); // corner of each place
  bool split = false;
  for (size_t i = 0; i < n; ++i)
  {
    if (!isCorner[i])
    {
      continue;
    }
    const size_t place = static_cast<size_t>(this->Places[i]);
    first[place] = std::min(first[place], i);
    for (int c = 0; c < 3; ++c)
    {
      split |= this->Normals[3 * i + c] != this->Normals[3 * first[place] + c];
      directions[3 * place + c] += this->Normals[3 * i + c];
    }
  }
  if (!split)
  {
    return;
  }
  for (size_t i = 0; i < n; ++i)
  {
    const size_t place = static_cast<size_t>(this->Places[i]);
    float* direction = &directions[3 * i];
    if (place != i)
    {
      std::copy_n(&directions[3 * place], 3, direction);
    }
    else if (vtkMath::Normalize(direction) == 0.0f)
    {
      std::copy_n(&this->Normals[3 * (first[i] < n ? first[i] : i)], 3, direction);
    }
  }
  this->Directions.swap(directions);
}

bool RefinementMesh::BuildTextureCoordinates(vtkPolyData* input)
{
  vtkDataArray* given = input->GetPointData()->GetTCoords();
  if (!given)
  {
    this->Error = "displacement by a height map needs texture coordinates (point data TCoords, 2 "
                  "components in [0, 1]), and the mesh has none";
    return false;
  }
  if (given->GetNumberOfComponents() < 2 || given->GetNumberOfTuples() < this->NumberOfPoints)
  {
    std::ostringstream text;
    text << "texture coordinates \"" << (given->GetName() ? given->GetName() : "") << "\" have "
         << given->GetNumberOfComponents() << " components and " << given->GetNumberOfTuples()
         << " tuples; displacement needs 2 components for each of " << this->NumberOfPoints
         << " points";
    this->Error = text.str();
    return false;
  }
  this->TextureCoordinates.resize(2 * static_cast<size_t>(this->NumberOfPoints));
  for (const RefinementFace& face : this->Faces)
  {
    for (int point : face.Corners)
    {
      for (int c = 0; c < 2; ++c)
      {
        const double value = given->GetComponent(point, c);
        if (!std::isfinite(value))
        {
          this->Error = "texture coordinates of point " + std::to_string(point) + " are not finite";
          return false;
        }
        this->TextureCoordinates[2 * static_cast<size_t>(point) + c] = static_cast<float>(value);
      }
    }
  }
  return true;
}

void RefinementMesh::BuildFrames(bool alongNormal)
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  const std::vector<float>& directions =
    this->Directions.empty() ? this->Normals : this->Directions;
  std::vector<double> sums(8 * n, 0.0); // gradients, mean curvature, area
  for (const RefinementFace& face : this->Faces)
  {
    Vector p[3];
    for (int i = 0; i < 3; ++i)
    {
      p[i] = load(&this->Points[3 * static_cast<size_t>(face.Corners[i])]);
    }
    const Vector normal = cross(subtract(p[1], p[0]), subtract(p[2], p[0]));
    const double squared = dot(normal, normal);
    if (!(squared > 0.0))
    {
      continue;
    }
    double values[7] = { 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      const size_t point = static_cast<size_t>(face.Corners[i]);
      // The gradient of a corner's barycentric weight.
      const Vector gradient = cross(normal, subtract(p[(i + 2) % 3], p[(i + 1) % 3]));
      for (int c = 0; c < 3; ++c)
      {
        const double g = gradient[c] / squared;
        if (!this->TextureCoordinates.empty())
        {
          values[c] += g * this->TextureCoordinates[2 * point];
          values[3 + c] += g * this->TextureCoordinates[2 * point + 1];
        }
        if (alongNormal)
        {
          // Half the divergence of the unit normals is the mean curvature.
          values[6] += 0.5 * g * directions[3 * point + c];
        }
      }
    }
    const double area = std::sqrt(squared);
    for (int corner : face.Corners)
    {
      double* sum = &sums[8 * static_cast<size_t>(corner)];
      for (int k = 0; k < 7; ++k)
      {
        sum[k] += area * values[k];
      }
      sum[7] += area;
    }
  }
  this->Frames.assign(8 * n, 0.0f);
  for (size_t i = 0; i < n; ++i)
  {
    const double* sum = &sums[8 * i];
    if (sum[7] > 0.0)
    {
      float* frame = &this->Frames[8 * i];
      for (int c = 0; c < 3; ++c)
      {
        frame[c] = static_cast<float>(sum[c] / sum[7]);
        frame[4 + c] = static_cast<float>(sum[3 + c] / sum[7]);
      }
      frame[3] = static_cast<float>(sum[6] / sum[7]);
    }
  }
}

void RefinementMesh::BuildPlaceEdges()
{
  using Key = std::array<int, 4>; // places, points
  const auto getKey = [this](int faceEdge)
  {
    const int* corners = this->Faces[faceEdge / 3].Corners;
    const int a = corners[EdgeCorners[faceEdge % 3][0]];
    const int b = corners[EdgeCorners[faceEdge % 3][1]];
    return Key{ { this->GetPlace(a), this->GetPlace(b), a, b } };
  };
  const std::vector<int> sorted = sortByKey(3 * this->Faces.size(), this->NumberOfPoints, getKey);
  this->FacePlaceEdges.resize(sorted.size());
  this->PlaceEdgeOffsets.clear();
  this->PlaceEdgePairs.clear();
  Key previous{ { -1, -1, -1, -1 } };
  for (int faceEdge : sorted)
  {
    const Key key = getKey(faceEdge);
    if (key[0] != previous[0] || key[1] != previous[1])
    {
      this->PlaceEdgeOffsets.push_back(static_cast<int>(this->PlaceEdgePairs.size()));
    }
    if (key != previous)
    {
      this->PlaceEdgePairs.push_back({ { key[2], key[3] } });
    }
    this->FacePlaceEdges[faceEdge] = static_cast<int>(this->PlaceEdgeOffsets.size()) - 1;
    previous = key;
  }
  this->PlaceEdgeOffsets.push_back(static_cast<int>(this->PlaceEdgePairs.size()));
}

void RefinementMesh::BuildSeams()
{
  // The lowest point of each place that a face uses.
  std::vector<int> first(static_cast<size_t>(this->NumberOfPoints), this->NumberOfPoints);
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      int& lowest = first[static_cast<size_t>(this->GetPlace(corner))];
      lowest = std::min(lowest, corner);
    }
  }
  this->Seams.resize(9 * this->Faces.size());
  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int edge = this->FacePlaceEdges[3 * f + i];
      const auto& pair = this->PlaceEdgePairs[this->PlaceEdgeOffsets[edge]];
      this->Seams[9 * f + i] =
        first[static_cast<size_t>(this->GetPlace(this->Faces[f].Corners[i]))];
      this->Seams[9 * f + 3 + i] = pair[0];
      this->Seams[9 * f + 6 + i] = pair[1];
    }
  }
}

void RefinementMesh::BuildVectors(vtkRefinementSurface* surface)
{
  const int positions = surface->GetNumberOfEdgePositions();
  this->VectorsPerEdge = positions + surface->GetNumberOfEdgeNormals();
  this->VectorsPerFace = 3 * this->VectorsPerEdge + surface->GetNumberOfFacePositions();
  this->Vectors.assign(3 * static_cast<size_t>(this->VectorsPerFace) * this->Faces.size(), 0.0f);
  if (this->Vectors.empty())
  {
    return;
  }
  auto computeEdge = [this, surface](int a, int b, float* vectors)
  {
    surface->ComputeEdgeVectors(&this->Points[3 * static_cast<size_t>(a)],
      &this->Normals[3 * static_cast<size_t>(a)], &this->Points[3 * static_cast<size_t>(b)],
      &this->Normals[3 * static_cast<size_t>(b)], vectors);
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Faces.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> other(3 * static_cast<size_t>(this->VectorsPerEdge));
      for (vtkIdType f = begin; f < end; ++f)
      {
        const RefinementFace& face = this->Faces[f];
        float* vectors = &this->Vectors[3 * static_cast<size_t>(this->VectorsPerFace) * f];
        const float* edgePositions[3];
        for (int i = 0; i < 3; ++i)
        {
          float* edge = vectors + 3 * i * this->VectorsPerEdge;
          edgePositions[i] = edge;
          computeEdge(face.Corners[EdgeCorners[i][0]], face.Corners[EdgeCorners[i][1]], edge);
          if (this->FacePlaceEdges.empty())
          {
            continue;
          }
          const int id = this->FacePlaceEdges[3 * f + i];
          const int pairs = this->PlaceEdgeOffsets[id + 1] - this->PlaceEdgeOffsets[id];
          if (pairs > 1)
          {
            // The mean over all sides, summed in the same order by each of them.
            std::fill_n(edge, 3 * positions, 0.0f);
            for (int k = 0; k < pairs; ++k)
            {
              const auto& pair = this->PlaceEdgePairs[this->PlaceEdgeOffsets[id] + k];
              computeEdge(pair[0], pair[1], other.data());
              for (int c = 0; c < 3 * positions; ++c)
              {
                edge[c] += other[c] / static_cast<float>(pairs);
              }
            }
          }
        }
        float points[9];
        for (int i = 0; i < 3; ++i)
        {
          std::copy_n(&this->Points[3 * static_cast<size_t>(face.Corners[i])], 3, points + 3 * i);
        }
        surface->ComputeFacePositions(points, edgePositions, vectors + 9 * this->VectorsPerEdge);
      }
    });
}

void RefinementMesh::BuildEdges()
{
  using Key = std::array<int, 2>;
  const auto getKey = [this](int faceEdge)
  {
    const int* corners = this->Faces[faceEdge / 3].Corners;
    const int a = corners[EdgeCorners[faceEdge % 3][0]];
    const int b = corners[EdgeCorners[faceEdge % 3][1]];
    return Key{ { std::min(a, b), std::max(a, b) } };
  };
  const std::vector<int> sorted = sortByKey(3 * this->Faces.size(), this->NumberOfPoints, getKey);
  this->FaceEdges.resize(sorted.size());
  this->EdgeOwners.clear();
  Key previous{ { -1, -1 } };
  for (int faceEdge : sorted)
  {
    const Key key = getKey(faceEdge);
    if (key != previous)
    {
      this->EdgeOwners.push_back(faceEdge);
      previous = key;
    }
    this->FaceEdges[faceEdge] = static_cast<int>(this->EdgeOwners.size()) - 1;
  }
}

void RefinementMesh::GetBounds(vtkAdaptiveRefinement* recipe, double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  vtkRefinementSurface* surface = recipe->GetSurface();
  vtkDisplacement* displacement = recipe->GetDisplacement();
  double reach[2] = { 0.0, 0.0 };
  double fixed[3] = { 0.0, 0.0, 0.0 };
  if (displacement)
  {
    displacement->GetReach(reach);
    displacement->GetDirection(fixed);
  }
  const bool alongNormal = displacement && displacement->IsAlongNormal();
  const std::vector<float>& directions =
    this->Directions.empty() ? this->Normals : this->Directions;
  const int positions = surface ? surface->GetNumberOfEdgePositions() : 0;
  const int facePositions = surface ? surface->GetNumberOfFacePositions() : 0;

  double low[3];
  double high[3];
  auto extend = [&low, &high](const float* v)
  {
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min<double>(low[c], v[c]);
      high[c] = std::max<double>(high[c], v[c]);
    }
  };
  auto reset = [&low, &high]()
  {
    std::fill_n(low, 3, std::numeric_limits<double>::max());
    std::fill_n(high, 3, std::numeric_limits<double>::lowest());
  };

  for (size_t f = 0; f < this->Faces.size(); ++f)
  {
    const RefinementFace& face = this->Faces[f];
    const float* vectors = this->Vectors.empty()
      ? nullptr
      : &this->Vectors[3 * static_cast<size_t>(this->VectorsPerFace) * f];
    double moves[3][2] = { { fixed[0], fixed[0] }, { fixed[1], fixed[1] }, { fixed[2], fixed[2] } };
    if (alongNormal)
    {
      // Normals are convex combinations of these, made unit: no longer than 1 over the least
      // length a combination can have.
      reset();
      std::vector<const float*> normals;
      for (int corner : face.Corners)
      {
        normals.push_back(&directions[3 * static_cast<size_t>(corner)]);
      }
      for (int edge = 0; edge < 3; ++edge)
      {
        for (int k = positions; k < this->VectorsPerEdge; ++k)
        {
          normals.push_back(vectors + 3 * (edge * this->VectorsPerEdge + k));
        }
      }
      double mean[3] = { 0.0, 0.0, 0.0 };
      for (const float* normal : normals)
      {
        extend(normal);
        vtkMath::Add(mean, load(normal).data(), mean);
      }
      vtkMath::Normalize(mean);
      double least = 1.0;
      for (const float* normal : normals)
      {
        least = std::min(least, vtkMath::Dot(mean, load(normal).data()));
      }
      for (int c = 0; c < 3; ++c)
      {
        const bool bounded = least > 0.0;
        moves[c][0] = bounded ? std::max(-1.0, low[c] / (low[c] < 0.0 ? least : 1.0)) : -1.0;
        moves[c][1] = bounded ? std::min(1.0, high[c] / (high[c] > 0.0 ? least : 1.0)) : 1.0;
      }
    }
    reset();
    for (int corner : face.Corners)
    {
      extend(&this->Points[3 * static_cast<size_t>(corner)]);
    }
    for (int edge = 0; edge < 3; ++edge)
    {
      for (int k = 0; k < positions; ++k)
      {
        extend(vectors + 3 * (edge * this->VectorsPerEdge + k));
      }
    }
    for (int k = 0; k < facePositions; ++k)
    {
      extend(vectors + 3 * (3 * this->VectorsPerEdge + k));
    }
    for (int c = 0; c < 3; ++c)
    {
      const double products[4] = { reach[0] * moves[c][0], reach[0] * moves[c][1],
        reach[1] * moves[c][0], reach[1] * moves[c][1] };
      low[c] += this->Origin[c] + *std::min_element(products, products + 4);
      high[c] += this->Origin[c] + *std::max_element(products, products + 4);
      const bool first = bounds[2 * c] > bounds[2 * c + 1];
      bounds[2 * c] = first ? low[c] : std::min(bounds[2 * c], low[c]);
      bounds[2 * c + 1] = first ? high[c] : std::max(bounds[2 * c + 1], high[c]);
    }
  }
}
}
