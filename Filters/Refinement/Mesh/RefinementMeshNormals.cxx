// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals, directions and frames of a mesh to be refined.
#include "Mesh/GivenNormals.h"
#include "Mesh/NormalGroups.h"
#include "Mesh/RefinementMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

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

// Unit normals that differ by less are equal up to rounding.
constexpr float NormalRounding = 1e-5f;
}

void RefinementMesh::BuildNormals(vtkPolyData* input)
{
  this->Normals.assign(3 * static_cast<size_t>(this->NumberOfPoints), 0.0f);
  vtkDataArray* given = GetGivenNormals(input);
  bool missing = !given;
  for (vtkIdType i = 0; given && i < this->NumberOfPoints; ++i)
  {
    double normal[3];
    if (IsLengthOfNormal(GetUnitNormal(given, i, normal)))
    {
      std::copy_n(normal, 3, &this->Normals[3 * static_cast<size_t>(i)]);
    }
    else
    {
      missing = true;
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

// One direction per place: where faces see different normals, their mean. Normals that differ by
// rounding alone, as on the two sides of many texture seams, are made one.
void RefinementMesh::BuildDirections()
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  std::vector<size_t> first(n, n); // corner of each place
  std::vector<char> isCorner(n, 0);
  for (const RefinementFace& face : this->Faces)
  {
    for (int corner : face.Corners)
    {
      const size_t point = static_cast<size_t>(corner);
      size_t& lowest = first[static_cast<size_t>(this->Places[point])];
      lowest = std::min(lowest, point);
      isCorner[point] = 1;
    }
  }
  std::vector<char> isSplit(n, 0); // per place
  for (size_t i = 0; i < n; ++i)
  {
    const size_t place = static_cast<size_t>(this->Places[i]);
    const Vector difference =
      subtract(load(&this->Normals[3 * i]), load(&this->Normals[3 * std::min(first[place], i)]));
    constexpr double squaredRounding = double(NormalRounding) * NormalRounding;
    isSplit[place] |= isCorner[i] && dot(difference, difference) > squaredRounding ? 1 : 0;
  }
  std::vector<float> directions(3 * n, 0.0f);
  for (size_t i = 0; i < n; ++i)
  {
    const size_t place = static_cast<size_t>(this->Places[i]);
    if (isCorner[i] && !isSplit[place])
    {
      std::copy_n(&this->Normals[3 * first[place]], 3, &this->Normals[3 * i]);
    }
    for (int c = 0; c < 3; ++c)
    {
      directions[3 * place + c] += isCorner[i] ? this->Normals[3 * i + c] : 0.0f;
    }
  }
  if (std::find(isSplit.begin(), isSplit.end(), 1) == isSplit.end())
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
    else if (!isSplit[place] || vtkMath::Normalize(direction) == 0.0f)
    {
      std::copy_n(&this->Normals[3 * std::min(first[place], i)], 3, direction);
    }
  }
  this->Directions.swap(directions);
}

// Gradients of texture coordinates do not depend on how points are shared: coincident points are
// one but where texture coordinates have a seam or normals a crease.
std::vector<size_t> RefinementMesh::FindFramePoints() const
{
  std::vector<size_t> framePoints(static_cast<size_t>(this->NumberOfPoints));
  std::iota(framePoints.begin(), framePoints.end(), 0);
  if (this->Places.empty())
  {
    return framePoints;
  }
  std::vector<char> isShared(framePoints.size(), 0); // per place
  for (size_t i = 0; i < framePoints.size(); ++i)
  {
    const size_t place = static_cast<size_t>(this->Places[i]);
    isShared[place] |= place != i ? 1 : 0;
  }
  using Key = std::tuple<vtkIdType, float, float>;
  std::vector<std::pair<Key, size_t>> points;
  for (size_t i = 0; i < framePoints.size(); ++i)
  {
    const vtkIdType place = this->Places[i];
    if (isShared[static_cast<size_t>(place)])
    {
      const float* uv =
        this->TextureCoordinates.empty() ? nullptr : &this->TextureCoordinates[2 * i];
      points.push_back({ Key(place, uv ? uv[0] : 0.0f, uv ? uv[1] : 0.0f), i });
    }
  }
  std::sort(points.begin(), points.end());
  std::vector<vec3> normals;
  std::vector<vtkIdType> groups;
  for (auto first = points.begin(), last = first; first != points.end(); first = last)
  {
    normals.clear();
    for (; last != points.end() && last->first == first->first; ++last)
    {
      const float* normal = &this->Normals[3 * last->second];
      normals.push_back(vec3(normal[0], normal[1], normal[2]));
    }
    GroupNormals(normals, NormalRounding, groups);
    for (size_t i = 0; i < groups.size(); ++i)
    {
      framePoints[(first + static_cast<std::ptrdiff_t>(i))->second] =
        (first + static_cast<std::ptrdiff_t>(groups[i]))->second;
    }
  }
  return framePoints;
}

void RefinementMesh::BuildFrames(bool alongNormal)
{
  const size_t n = static_cast<size_t>(this->NumberOfPoints);
  const std::vector<float>& directions =
    this->Directions.empty() ? this->Normals : this->Directions;
  const std::vector<size_t> framePoints = this->FindFramePoints();
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
      double* sum = &sums[8 * framePoints[static_cast<size_t>(corner)]];
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
    const double* sum = &sums[8 * framePoints[i]];
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
}
