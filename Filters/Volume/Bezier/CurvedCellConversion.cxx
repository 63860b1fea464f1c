// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Bezier/CurvedCellConversion.h"

#include "Cells/CellKind.h"
#include "Mathematics/LagrangeToBezier.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderTetra.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

namespace relevo
{
namespace
{
// Of weights that are at most about 1.
constexpr double Rounding = 1e-13;
constexpr double LargestMismatch = 1e-9;

// The parameters, in a VTK cell, of the corners of a hexahedron.
using CornerParameters = std::array<dvec3, 8>;

dvec3 Interpolate(const CornerParameters& corners, const dvec3& p)
{
  const auto along = [&](int first) { return mix(corners[first], corners[first + 1], p.x); };
  return mix(mix(along(0), along(2), p.y), mix(along(4), along(6), p.y), p.z);
}

// Returns the hexahedron between two corners of a hexahedron's lattice.
CornerParameters GetPart(const CornerParameters& whole, const dvec3& low, const dvec3& high)
{
  CornerParameters part;
  for (int i = 0; i < 8; ++i)
  {
    part[i] = Interpolate(whole, mix(low, high, dvec3(i & 1, i >> 1 & 1, i >> 2 & 1)));
  }
  return part;
}

std::vector<CornerParameters> Halve(const CornerParameters& whole, const ivec3& counts)
{
  std::vector<CornerParameters> parts;
  const dvec3 size = 1.0 / dvec3(counts);
  for (int i = 0; i < counts.x * counts.y * counts.z; ++i)
  {
    const dvec3 low = size * dvec3(i % counts.x, i / counts.x % counts.y, i / counts.x / counts.y);
    parts.push_back(GetPart(whole, low, low + size));
  }
  return parts;
}

// The part of a simplex at a corner, where that corner's barycentric coordinate is the largest. All
// parts have the orientation of the simplex.
CornerParameters GetSimplexCorner(const std::vector<dvec3>& simplex, size_t corner)
{
  std::vector<dvec3> others;
  for (size_t k = 1; k < simplex.size(); ++k)
  {
    others.push_back(simplex[(corner + k) % simplex.size()]);
  }
  if (simplex.size() == 4 && corner % 2 == 1)
  {
    std::swap(others[0], others[1]);
  }
  CornerParameters parameters;
  for (int i = 0; i < 8; ++i)
  {
    dvec3 sum = simplex[corner];
    double count = 1.0;
    for (size_t k = 0; k < others.size(); ++k)
    {
      if (i >> k & 1)
      {
        sum += others[k];
        count += 1.0;
      }
    }
    parameters[i] = sum / count;
  }
  return parameters;
}

std::vector<CornerParameters> GetTetrahedra()
{
  const std::vector<dvec3> simplex = { dvec3(0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0),
    dvec3(0.0, 0.0, 1.0) };
  std::vector<CornerParameters> parts;
  for (size_t corner = 0; corner < simplex.size(); ++corner)
  {
    parts.push_back(GetSimplexCorner(simplex, corner));
  }
  return parts;
}

std::vector<CornerParameters> GetWedges(bool isHalved)
{
  const std::vector<dvec3> simplex = { dvec3(0.0), dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0) };
  std::vector<CornerParameters> parts;
  for (size_t corner = 0; corner < simplex.size(); ++corner)
  {
    CornerParameters whole = GetSimplexCorner(simplex, corner);
    for (int i = 4; i < 8; ++i)
    {
      whole[i].z = 1.0;
    }
    for (const CornerParameters& part : Halve(whole, ivec3(1, 1, isHalved ? 2 : 1)))
    {
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<CornerParameters> GetParts(const CurvedCellType& type, CellTopology shape)
{
  if (shape == CellTopology::Tetrahedron)
  {
    return GetTetrahedra();
  }
  if (shape == CellTopology::Wedge)
  {
    return GetWedges(type.IsHalved);
  }
  CornerParameters whole;
  for (int i = 0; i < 8; ++i)
  {
    whole[i] = dvec3(i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  if (type.Type == VTK_TRIQUADRATIC_PYRAMID) // its parameters shrink towards the apex
  {
    for (int i = 0; i < 8; ++i)
    {
      whole[i] = i < 4 ? dvec3(whole[i].x, whole[i].y, 0.5) : dvec3(0.5, 0.5, 1.0);
    }
  }
  return Halve(whole, ivec3(type.IsHalved ? 2 : 1));
}

// Evaluates the basis functions of a Bézier tetrahedron. VTK's own function takes milliseconds per
// point at degree 8.
class BezierTetrahedronBasis
{
public:
  explicit BezierTetrahedronBasis(int degree)
    : Degree(degree)
  {
    for (vtkIdType node = 0; node < (degree + 1) * (degree + 2) * (degree + 3) / 6; ++node)
    {
      std::array<vtkIdType, 4> exponents;
      vtkHigherOrderTetra::BarycentricIndex(node, exponents.data(), degree);
      this->Exponents.push_back(exponents);
    }
  }

  void Evaluate(const dvec3& p, double* values) const
  {
    // Powers, divided by factorials, of barycentric coordinates.
    const dvec4 coordinates(p, 1.0 - p.x - p.y - p.z);
    std::vector<dvec4> powers{ dvec4(1.0) };
    double factorial = 1.0;
    for (int i = 1; i <= this->Degree; ++i)
    {
      powers.push_back(powers.back() * coordinates / static_cast<double>(i));
      factorial *= i;
    }
    for (const auto& exponents : this->Exponents)
    {
      double value = factorial;
      for (int i = 0; i < 4; ++i)
      {
        value *= powers[static_cast<size_t>(exponents[i])][i];
      }
      *values++ = value;
    }
  }

private:
  int Degree;
  std::vector<std::array<vtkIdType, 4>> Exponents;
};

// Evaluates the basis functions of a VTK cell.
class CellBasis
{
public:
  explicit CellBasis(const CurvedCellType& type)
    : NumberOfNodes(static_cast<size_t>(type.NumberOfNodes))
  {
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(type.NumberOfNodes);
    for (vtkIdType i = 0; i < type.NumberOfNodes; ++i)
    {
      points->SetPoint(i, 0.0, 0.0, 0.0);
    }
    this->Grid->SetPoints(points);
    std::vector<vtkIdType> ids(this->NumberOfNodes);
    std::iota(ids.begin(), ids.end(), 0);
    this->Grid->InsertNextCell(type.Type, type.NumberOfNodes, ids.data());
    if (type.Degrees != ivec3(0))
    {
      vtkNew<vtkDoubleArray> degrees;
      degrees->SetName("HigherOrderDegrees");
      degrees->SetNumberOfComponents(3);
      degrees->InsertNextTuple3(type.Degrees.x, type.Degrees.y, type.Degrees.z);
      this->Grid->GetCellData()->SetHigherOrderDegrees(degrees);
    }
    this->Grid->GetCell(0, this->Cell);
    if (type.Type == VTK_BEZIER_TETRAHEDRON)
    {
      this->Tetrahedron = std::make_unique<BezierTetrahedronBasis>(type.Degrees.x);
    }
  }

  void Evaluate(const dvec3& parameters, double* values)
  {
    if (this->Tetrahedron)
    {
      this->Tetrahedron->Evaluate(parameters, values);
    }
    else
    {
      this->EvaluateCell(parameters, values);
    }
  }

  // Calls VTK's function.
  void EvaluateCell(const dvec3& parameters, double* values)
  {
    this->Cell->InterpolateFunctions(&parameters.x, values);
  }

  size_t NumberOfNodes;

private:
  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkGenericCell> Cell;
  std::unique_ptr<BezierTetrahedronBasis> Tetrahedron;
};

// Returns the coefficients of all basis functions in a part of a cell, with those of each
// coefficient together.
std::vector<double> FindCoefficients(
  CellBasis& basis, const CornerParameters& part, const ivec3& degrees)
{
  const size_t count = basis.NumberOfNodes;
  const ivec3 size = degrees + 1;
  std::vector<double> all(static_cast<size_t>(size.x * size.y * size.z) * count);
  for (int i = 0; i < size.x * size.y * size.z; ++i)
  {
    const dvec3 at = dvec3(i % size.x, i / size.x % size.y, i / size.x / size.y) / dvec3(degrees);
    basis.Evaluate(Interpolate(part, at), &all[static_cast<size_t>(i) * count]);
  }
  const ivec3 steps(1, size.x, size.x * size.y);
  for (int direction = 0; direction < 3; ++direction)
  {
    for (int i = 0; i < size.x * size.y * size.z; ++i)
    {
      if (i / steps[direction] % size[direction] == 0)
      {
        ConvertLagrangeToBezier(degrees[direction], static_cast<int>(count),
          &all[static_cast<size_t>(i) * count],
          static_cast<std::ptrdiff_t>(count) * steps[direction]);
      }
    }
  }
  return all;
}

// The degrees at which the search begins; some bases have higher ones.
ivec3 GetFirstDegrees(const CurvedCellType& type, const CellKind& kind)
{
  return kind.Nodes == NodeKind::Quadratic ? ivec3(2) : type.Degrees;
}
}

bool CurvedCellType::operator<(const CurvedCellType& other) const
{
  const auto getKey = [](const CurvedCellType& type)
  {
    return std::make_tuple(
      type.Type, type.Degrees.x, type.Degrees.y, type.Degrees.z, type.NumberOfNodes, type.IsHalved);
  };
  return getKey(*this) < getKey(other);
}

// The matrices of the parts of a cell, in rows of the entries that are not 0.
class CurvedCellConversion::Matrix
{
public:
  // Returns false if the basis is not polynomial of this degree.
  bool Build(const CurvedCellType& type, const CellKind& kind, const ivec3& degrees)
  {
    this->Degrees = degrees;
    this->Parts.clear();
    CellBasis basis(type);
    for (const CornerParameters& part : GetParts(type, kind.Shape))
    {
      this->AddPart(FindCoefficients(basis, part, degrees), basis.NumberOfNodes);
      if (!this->Matches(basis, part))
      {
        return false;
      }
    }
    return true;
  }

  std::vector<BezierHexahedron> Apply(
    const std::vector<CurvedNode>& nodes, int numberOfScalars) const
  {
    const dvec3 origin = nodes.front().Position;
    std::vector<double> values;
    const auto stride = static_cast<size_t>(BezierHexahedron::FirstScalar + numberOfScalars);
    for (const CurvedNode& node : nodes)
    {
      const dvec3 place = node.Weight * (node.Position - origin);
      for (const double value : { place.x, place.y, place.z, node.Weight })
      {
        values.push_back(value);
      }
      for (int c = 0; c < numberOfScalars; ++c)
      {
        values.push_back(node.Weight * node.Values[c]);
      }
    }
    std::vector<BezierHexahedron> all;
    for (const Part& part : this->Parts)
    {
      all.emplace_back(this->Degrees, numberOfScalars);
      for (size_t row = 0; row + 1 < part.Firsts.size(); ++row)
      {
        double* sum = all.back().GetCoefficient(static_cast<int>(row));
        for (size_t i = part.Firsts[row]; i < part.Firsts[row + 1]; ++i)
        {
          const double* value = &values[part.Entries[i].Node * stride];
          for (size_t c = 0; c < stride; ++c)
          {
            sum[c] += part.Entries[i].Factor * value[c];
          }
        }
      }
      all.back().Move(origin);
    }
    return all;
  }

  void FindWeights(size_t part, const std::vector<CurvedNode>& nodes, const dvec3& parameters,
    double* weights) const
  {
    std::fill_n(weights, nodes.size(), 0.0);
    const std::vector<double> basis = BezierHexahedron::GetBasis(this->Degrees, parameters);
    const Part& matrix = this->Parts[part];
    for (size_t row = 0; row < basis.size(); ++row)
    {
      for (size_t i = matrix.Firsts[row]; i < matrix.Firsts[row + 1]; ++i)
      {
        const Entry& entry = matrix.Entries[i];
        weights[entry.Node] += basis[row] * entry.Factor * nodes[entry.Node].Weight;
      }
    }
    const double sum = std::accumulate(weights, weights + nodes.size(), 0.0);
    std::transform(
      weights, weights + nodes.size(), weights, [&](double weight) { return weight / sum; });
  }

private:
  struct Entry
  {
    size_t Node;
    double Factor;
  };
  struct Part
  {
    std::vector<size_t> Firsts; // entries of each row, and the end
    std::vector<Entry> Entries;
  };

  void AddPart(const std::vector<double>& coefficients, size_t numberOfNodes)
  {
    Part part;
    part.Firsts.push_back(0);
    for (size_t row = 0; row < coefficients.size() / numberOfNodes; ++row)
    {
      for (size_t node = 0; node < numberOfNodes; ++node)
      {
        const double factor = coefficients[row * numberOfNodes + node];
        if (std::abs(factor) > Rounding)
        {
          const double whole = std::round(factor);
          part.Entries.push_back({ node, std::abs(factor - whole) < Rounding ? whole : factor });
        }
      }
      part.Firsts.push_back(part.Entries.size());
    }
    this->Parts.push_back(std::move(part));
  }

  // Compares the last part with the functions of the cell. Each function is a scalar of its own.
  bool Matches(CellBasis& basis, const CornerParameters& part) const
  {
    std::vector<double> values(basis.NumberOfNodes);
    std::vector<CurvedNode> nodes(basis.NumberOfNodes, { dvec3(0.0), 1.0, {} });
    Matrix last;
    last.Degrees = this->Degrees;
    last.Parts = { this->Parts.back() };
    for (size_t node = 0; node < nodes.size(); ++node)
    {
      // Values that differ from node to node, so that errors do not cancel out.
      const double angle = 2.4 * static_cast<double>(node);
      nodes[node].Position = dvec3(std::cos(angle), std::sin(angle), std::sin(3.1 * angle));
    }
    const BezierHexahedron hexahedron = last.Apply(nodes, 0).front();
    for (int i = 0; i < BezierHexahedron::NumberOfSamples; ++i)
    {
      const dvec3 at = 0.9 * BezierHexahedron::GetSample(i) + 0.03 * dvec3(i % 2, i % 5, i % 3);
      basis.EvaluateCell(Interpolate(part, at), values.data());
      dvec3 sum(0.0);
      for (size_t node = 0; node < nodes.size(); ++node)
      {
        sum += values[node] * nodes[node].Position;
      }
      if (!(length(sum - hexahedron.GetPosition(at)) < LargestMismatch))
      {
        return false;
      }
    }
    return true;
  }

  ivec3 Degrees;
  std::vector<Part> Parts;
};

CurvedCellConversion::CurvedCellConversion() = default;
CurvedCellConversion::~CurvedCellConversion() = default;

bool CurvedCellConversion::Prepare(const CurvedCellType& type)
{
  const auto found = this->Matrices.find(type);
  if (found != this->Matrices.end())
  {
    return found->second != nullptr;
  }
  const CellKind kind = GetCellKind(type.Type, type.NumberOfNodes);
  auto matrix = std::make_unique<Matrix>();
  ivec3 degrees = GetFirstDegrees(type, kind);
  while (!matrix->Build(type, kind, degrees))
  {
    degrees = degrees + 1;
    if (std::max({ degrees.x, degrees.y, degrees.z }) > LargestDegree)
    {
      matrix.reset();
      break;
    }
  }
  const bool isConverted = matrix != nullptr;
  this->Matrices[type] = std::move(matrix);
  return isConverted;
}

const CurvedCellConversion::Matrix* CurvedCellConversion::Find(const CurvedCellType& type) const
{
  return this->Matrices.at(type).get();
}

std::vector<BezierHexahedron> CurvedCellConversion::Convert(
  const CurvedCellType& type, const std::vector<CurvedNode>& nodes, int numberOfScalars) const
{
  const Matrix* matrix = this->Find(type);
  return matrix ? matrix->Apply(nodes, numberOfScalars) : std::vector<BezierHexahedron>();
}

void CurvedCellConversion::FindWeights(const CurvedCellType& type, size_t part,
  const std::vector<CurvedNode>& nodes, const dvec3& parameters, double* weights) const
{
  this->Find(type)->FindWeights(part, nodes, parameters, weights);
}
}
