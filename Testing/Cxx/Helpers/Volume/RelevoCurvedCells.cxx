// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoCurvedCells.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace
{
// Chebyshev's polynomial over [0, 1].
double GetChebyshev(int degree, double x)
{
  double before = 1.0;
  double value = 2.0 * x - 1.0;
  for (int k = 1; k < degree; ++k)
  {
    const double next = 2.0 * (2.0 * x - 1.0) * value - before;
    before = value;
    value = next;
  }
  return value;
}

bool IsHigherOrder(int type)
{
  return type >= VTK_LAGRANGE_CURVE;
}

int CountNodes(int type, int degree)
{
  const int n = degree + 1;
  switch (type)
  {
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return n * (n + 1) * (n + 2) / 6;
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return n * n * (n + 1) / 2;
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return n * n * n;
    default:
    {
      const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      return cell->GetNumberOfPoints();
    }
  }
}

// A VTK cell of a type and degree: its nodes' parameters and its basis.
class Basis
{
public:
  Basis(int type, int degree)
    : Type(type)
    , Count(CountNodes(type, degree))
  {
    std::vector<vtkIdType> ids(static_cast<size_t>(this->Count));
    std::iota(ids.begin(), ids.end(), 0);
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(this->Count);
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      points->SetPoint(i, 0.0, 0.0, 0.0);
    }
    this->Grid->SetPoints(points);
    this->Grid->InsertNextCell(type, this->Count, ids.data());
    this->Grid->GetCell(0, this->Cell);
  }

  // The nodes' values for which the cell has these values at its nodes' parameters.
  std::vector<RelevoPoint> FindNodes(const std::vector<RelevoPoint>& values) const
  {
    const auto count = static_cast<size_t>(this->Count);
    std::vector<RelevoPoint> nodes = values;
    if (this->Type != VTK_BEZIER_HEXAHEDRON && this->Type != VTK_BEZIER_WEDGE &&
      this->Type != VTK_BEZIER_TETRAHEDRON)
    {
      return nodes;
    }
    std::vector<double> matrix(count * count);
    std::vector<double*> rows;
    std::vector<int> order(count);
    for (size_t i = 0; i < count; ++i)
    {
      this->Cell->InterpolateFunctions(
        this->Cell->GetParametricCoords() + 3 * i, &matrix[i * count]);
      rows.push_back(&matrix[i * count]);
    }
    vtkMath::LUFactorLinearSystem(rows.data(), order.data(), this->Count);
    for (int c = 0; c < 3; ++c)
    {
      std::vector<double> right(count);
      std::transform(values.begin(), values.end(), right.begin(),
        [c](const RelevoPoint& value) { return value[c]; });
      vtkMath::LUSolveLinearSystem(rows.data(), order.data(), right.data(), this->Count);
      for (size_t i = 0; i < count; ++i)
      {
        nodes[i][c] = right[i];
      }
    }
    return nodes;
  }

  RelevoPoint GetParameters(int node) const
  {
    const double* at = this->Cell->GetParametricCoords() + 3 * node;
    return { { at[0], at[1], at[2] } };
  }

  int Type;
  int Count;

private:
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkGenericCell> Cell;
};

// The simplices of a cube, and their corners along the axes of the parameters.
std::vector<std::vector<RelevoPoint>> GetSimplices(int type)
{
  const bool isWedge = type == VTK_QUADRATIC_WEDGE || type == VTK_BIQUADRATIC_QUADRATIC_WEDGE ||
    type == VTK_QUADRATIC_LINEAR_WEDGE || type == VTK_LAGRANGE_WEDGE || type == VTK_BEZIER_WEDGE;
  const bool isTetrahedron = type == VTK_QUADRATIC_TETRA || type == VTK_LAGRANGE_TETRAHEDRON ||
    type == VTK_BEZIER_TETRAHEDRON;
  if (isWedge)
  {
    return { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 0, 1 } } },
      { { { 0, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  }
  if (!isTetrahedron)
  {
    return { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  }
  std::vector<std::vector<RelevoPoint>> all;
  std::array<int, 3> axes = { { 0, 1, 2 } };
  do
  {
    std::vector<RelevoPoint> corners(4, RelevoPoint{});
    for (int i = 0; i < 3; ++i)
    {
      corners[i + 1] = corners[i];
      corners[i + 1][axes[i]] = 1.0;
    }
    if ((axes[1] + 3 - axes[0]) % 3 == 2)
    {
      std::swap(corners[1], corners[2]);
    }
    all.push_back(corners);
  } while (std::next_permutation(axes.begin(), axes.end()));
  return all;
}
}

// Without IsSteep, a polynomial whose terms decrease like those of a smooth function.
double RelevoCurvedCells::GetWave(int degree, double x) const
{
  if (this->IsSteep)
  {
    return GetChebyshev(degree, x);
  }
  double sum = 0.0;
  for (int k = 1; k <= degree; ++k)
  {
    sum += GetChebyshev(k, x) / (k * k * k);
  }
  return sum;
}

RelevoPoint RelevoCurvedCells::GetPosition(const RelevoPoint& at) const
{
  const double lift = 0.1 * this->GetWave(this->Degree, at[0]) -
    0.3 * this->GetWave(std::min(this->Degree, 2), at[1]);
  return { { at[0], at[1], at[2] + lift } };
}

double RelevoCurvedCells::GetField(const RelevoPoint& at) const
{
  return 0.5 + 0.2 * this->GetWave(this->Degree, at[0]) -
    0.1 * this->GetWave(std::min(this->Degree, 3), at[1]) +
    0.2 * (2.0 * at[2] - 1.0) * (this->Degree > 1 ? 2.0 * at[1] - 1.0 : 1.0);
}

vtkSmartPointer<vtkUnstructuredGrid> RelevoCurvedCells::Make(int type, int n) const
{
  const Basis basis(type, this->Degree);
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> field;
  field->SetName("field");
  std::map<std::array<long, 3>, vtkIdType> known;
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    const RelevoPoint low = { { static_cast<double>(cube % n), static_cast<double>(cube / n % n),
      static_cast<double>(cube / n / n) } };
    for (const std::vector<RelevoPoint>& simplex : GetSimplices(type))
    {
      std::vector<RelevoPoint> positions;
      std::vector<RelevoPoint> fields;
      std::vector<RelevoPoint> places;
      for (int node = 0; node < basis.Count; ++node)
      {
        const RelevoPoint p = basis.GetParameters(node);
        RelevoPoint at;
        for (int c = 0; c < 3; ++c)
        {
          at[c] = low[c] + simplex[0][c];
          for (int k = 0; k < 3; ++k)
          {
            at[c] += p[k] * (simplex[k + 1][c] - simplex[0][c]);
          }
          at[c] /= n;
        }
        places.push_back(at);
        positions.push_back(this->GetPosition(at));
        fields.push_back({ { this->GetField(at), 0.0, 0.0 } });
      }
      positions = basis.FindNodes(positions);
      fields = basis.FindNodes(fields);
      std::vector<vtkIdType> ids;
      for (size_t node = 0; node < places.size(); ++node)
      {
        const std::array<long, 3> key = { { std::lround(1e6 * places[node][0]),
          std::lround(1e6 * places[node][1]), std::lround(1e6 * places[node][2]) } };
        const auto found = known.insert({ key, points->GetNumberOfPoints() });
        if (found.second)
        {
          points->InsertNextPoint(positions[node].data());
          field->InsertNextValue(fields[node][0]);
        }
        ids.push_back(found.first->second);
      }
      mesh->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetScalars(field);
  if (IsHigherOrder(type))
  {
    vtkNew<vtkDoubleArray> degrees;
    degrees->SetName("HigherOrderDegrees");
    degrees->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      degrees->InsertNextTuple3(this->Degree, this->Degree, this->Degree);
    }
    mesh->GetCellData()->SetHigherOrderDegrees(degrees);
  }
  return mesh;
}

bool RelevoCurvedCells::FindField(const RelevoPoint& position, double& field) const
{
  RelevoPoint at = position;
  at[2] -= this->GetPosition({ { position[0], position[1], 0.0 } })[2];
  field = this->GetField(at);
  return std::all_of(at.begin(), at.end(), [](double x) { return x >= 0.0 && x <= 1.0; });
}

// Midpoint rule with constant optics in each step.
std::vector<RelevoColor> RelevoCurvedCells::MakePicture(
  vtkCamera* camera, int width, int height, double first, double last, double unitDistance) const
{
  constexpr int steps = 1500;
  std::vector<RelevoColor> picture;
  for (int i = 0; i < width * height; ++i)
  {
    const RelevoRay ray(camera, i % width, i / width, width, height);
    RelevoColor color = {};
    double begin;
    double end;
    if (ray.CutBox(-0.5, 1.5, begin, end))
    {
      const double step = (end - begin) / steps;
      for (int k = 0; k < steps; ++k)
      {
        double field;
        if (this->FindField(ray.At(begin + (k + 0.5) * step), field))
        {
          const double clamped = std::clamp(field, 0.0, 1.0);
          const double alpha =
            1.0 - std::exp(-(first + clamped * (last - first)) / unitDistance * step);
          const double share = (1.0 - color[3]) * alpha;
          color[0] += share * (1.0 - clamped);
          color[2] += share * clamped;
          color[3] += share;
        }
      }
    }
    picture.push_back(color);
  }
  return picture;
}

double CompareInside(
  const std::vector<RelevoColor>& a, const std::vector<RelevoColor>& b, int width, double share)
{
  const int height = static_cast<int>(a.size()) / width;
  const auto isEmpty = [&](int x, int y)
  {
    const auto i = static_cast<size_t>(y * width + x);
    const auto isBlack = [](const RelevoColor& color) { return color[0] + color[2] < 1e-3; };
    return isBlack(a[i]) || isBlack(b[i]);
  };
  std::vector<double> apart;
  for (int y = 1; y + 1 < height; ++y)
  {
    for (int x = 1; x + 1 < width; ++x)
    {
      bool isOutline = false;
      for (int k = 0; k < 9; ++k)
      {
        isOutline = isOutline || isEmpty(x + k % 3 - 1, y + k / 3 - 1);
      }
      const auto i = static_cast<size_t>(y * width + x);
      double most = 0.0;
      for (int c = 0; c < 3 && !isOutline; ++c)
      {
        most = std::max(most, 255.0 * std::abs(a[i][c] - b[i][c]));
      }
      if (!isOutline)
      {
        apart.push_back(most);
      }
    }
  }
  std::sort(apart.begin(), apart.end());
  const size_t left = static_cast<size_t>(share * static_cast<double>(apart.size()));
  return apart.empty() ? 255.0 : apart[apart.size() - 1 - left];
}
