// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Sections/CellCutter.h"

#include "Cells/CellKind.h"
#include "Cells/CellReader.h"
#include "Compatibility/VTKCompatibility.h"
#include "Sections/FieldScales.h"
#include "Sections/PartCutter.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr int MaximumFieldIntervals = 32;

// A function of a curved cell can be outside of the range of its nodes by about this share.
constexpr double Overshoot = 1.0;

bool HasCurvedShape(const CellKind& kind)
{
  return kind.Nodes != NodeKind::Corners;
}

// Whether faces of a part, in the order of GetFace(), are on faces of the cell. The parts of a
// tetrahedron meet at the ends of all three directions, and those of a wedge at two.
std::array<bool, 6> FindOuterFaces(CellTopology shape)
{
  if (shape == CellTopology::Tetrahedron)
  {
    return { { true, false, true, false, true, false } };
  }
  const bool isWhole = shape != CellTopology::Wedge;
  return { { true, isWhole, true, isWhole, true, true } };
}

// The corners of the faces as nodes of the cell.
PolyhedronFaces ReadFaces(vtkDataSet* data, vtkIdType cell, const CellKind& kind, vtkIdList* nodes)
{
  PolyhedronFaces faces;
  if (kind.Shape != CellTopology::Polyhedron)
  {
    for (int i = 0; i < GetNumberOfFaces(kind.Shape); ++i)
    {
      const CornerNodes face = GetFaceNodes(kind, i);
      faces.emplace_back(face.Corners.begin(), face.Corners.begin() + face.Size);
    }
    return faces;
  }
  vtkNew<vtkIdList> scratch;
  std::vector<std::vector<vtkIdType>> ids;
  ReadPolyhedronFaces(vtkUnstructuredGrid::SafeDownCast(data), cell, scratch, ids);
  for (const std::vector<vtkIdType>& face : ids)
  {
    faces.emplace_back();
    for (const vtkIdType point : face)
    {
      faces.back().push_back(static_cast<int>(nodes->IsId(point)));
    }
  }
  return faces;
}
}

CellCutter::CellCutter(vtkDataSet* data, vtkImplicitFunction* function,
  const std::vector<double>& values, const SectionTolerances& tolerances)
  : Data(data)
  , Function(function)
  , Values(values)
  , Tolerances(tolerances)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    this->Reader = std::make_unique<CellReader>(grid);
  }
}

CellCutter::~CellCutter() = default;

bool CellCutter::CanCut(vtkIdType cell)
{
  this->Data->GetCellPoints(cell, this->Nodes);
  const vtkIdType number = this->Nodes->GetNumberOfIds();
  if (number == 0)
  {
    return false;
  }
  double low = this->Values[this->Nodes->GetId(0)];
  double high = low;
  for (vtkIdType i = 1; i < number; ++i)
  {
    const double value = this->Values[this->Nodes->GetId(i)];
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low < 0.0 && high >= 0.0)
  {
    return true;
  }
  const double beyond = Overshoot * (high - low);
  return low - beyond < 0.0 && high + beyond >= 0.0 &&
    HasCurvedShape(GetCellKind(this->Data->GetCellType(cell), number));
}

CellKind CellCutter::ReadCell(vtkIdType cell)
{
  this->Data->GetCellPoints(cell, this->Nodes);
  return GetCellKind(this->Data->GetCellType(cell), this->Nodes->GetNumberOfIds());
}

CurvedCellType CellCutter::ReadType(vtkIdType cell, const CellKind& kind)
{
  this->Reader->ReadNodes(cell);
  const ivec3 degrees = kind.Nodes == NodeKind::Quadratic ? ivec3(0) : this->Reader->GetDegrees();
  return { this->Reader->GetType(), degrees, this->Reader->GetNumberOfNodes(), false };
}

void CellCutter::Prepare(vtkIdType cell, CurvedCellConversion& conversion)
{
  const CellKind kind = this->ReadCell(cell);
  if (HasCurvedShape(kind))
  {
    conversion.Prepare(this->ReadType(cell, kind));
  }
}

CellSection CellCutter::Cut(vtkIdType cell, const CurvedCellConversion& conversion)
{
  CellSection section;
  const CellKind kind = this->ReadCell(cell);
  section.Nodes.assign(this->Nodes->begin(), this->Nodes->end());
  HasCurvedShape(kind) ? this->CutCurved(this->ReadType(cell, kind), kind, conversion, section)
                       : this->CutLinear(cell, kind, section);
  return section;
}

void CellCutter::CutLinear(vtkIdType cell, const CellKind& kind, CellSection& section)
{
  const auto value = [&](int node) { return this->Values[section.Nodes[node]]; };
  std::vector<double> values(section.Nodes.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = value(static_cast<int>(i));
  }
  PolyhedronFaces& faces = this->Faces[this->Data->GetCellType(cell)];
  if (faces.empty() || kind.Shape == CellTopology::Polyhedron)
  {
    faces = ReadFaces(this->Data, cell, kind, this->Nodes);
  }
  const PolyhedronSection cut = CutPolyhedron(faces, values);
  std::vector<int> points;
  for (std::array<int, 2> ends : cut.Edges)
  {
    // Cells at an edge compute the same bits.
    if (section.Nodes[ends[0]] > section.Nodes[ends[1]])
    {
      std::swap(ends[0], ends[1]);
    }
    const double share = value(ends[0]) / (value(ends[0]) - value(ends[1]));
    std::array<dvec3, 2> places;
    for (int i = 0; i < 2; ++i)
    {
      this->Data->GetPoint(section.Nodes[ends[i]], &places[i].x);
    }
    points.push_back(static_cast<int>(section.Points.size()));
    section.Points.push_back(share == 1.0 ? places[1] : mix(places[0], places[1], share));
    section.Weights.resize(section.Weights.size() + section.Nodes.size());
    double* weights = &*section.Weights.end() - section.Nodes.size();
    weights[ends[0]] += 1.0 - share;
    weights[ends[1]] += share;
    const vtkIdType first = section.Nodes[share == 1.0 ? ends[1] : ends[0]];
    section.Edges.push_back({ { first, section.Nodes[share == 0.0 ? ends[0] : ends[1]] } });
  }
  section.Add(cut, points, std::vector<unsigned char>(faces.size(), 1));
}

// As for shapes, see PartCutter: a bound of second derivatives limits the error of interpolation.
std::vector<int> CellCutter::CountFieldIntervals(const CurvedCellType& type,
  const CurvedCellConversion& conversion, std::vector<CurvedNode> nodes,
  const std::vector<vtkIdType>& points, std::size_t numberOfParts) const
{
  const FieldScales& fields = this->Tolerances.Fields;
  std::vector<double> largest(numberOfParts);
  for (int group = 0; group < fields.GetNumberOfGroups(); ++group)
  {
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      nodes[i].Values = fields.Get(group, points[i]);
    }
    const std::vector<BezierHexahedron> parts =
      conversion.Convert(type, nodes, fields.GetSize(group));
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      std::array<double, MaximumComponents> sum{};
      for (int direction = 0; direction < 3; ++direction)
      {
        const auto bounds = parts[i].BoundSecondDerivatives(direction);
        for (int c = 0; c < fields.GetSize(group); ++c)
        {
          sum[c] += bounds[1 + c] / 8.0;
        }
      }
      largest[i] = std::max(largest[i], *std::max_element(sum.begin(), sum.end()));
    }
  }
  std::vector<int> intervals(numberOfParts, 1);
  for (std::size_t i = 0; i < largest.size(); ++i)
  {
    while (intervals[i] < MaximumFieldIntervals &&
      largest[i] > this->Tolerances.Field * intervals[i] * intervals[i])
    {
      intervals[i] *= 2;
    }
  }
  return intervals;
}

void CellCutter::CutCurved(const CurvedCellType& type, const CellKind& kind,
  const CurvedCellConversion& conversion, CellSection& section)
{
  vtkDataArray* weights =
    kind.Nodes == NodeKind::Bezier ? this->Data->GetPointData()->GetRationalWeights() : nullptr;
  std::vector<CurvedNode> nodes;
  for (const vtkIdType point : section.Nodes)
  {
    dvec3 position;
    this->Data->GetPoint(point, &position.x);
    nodes.push_back({ position, weights ? weights->GetComponent(point, 0) : 1.0, {} });
  }
  const std::array<bool, 6> isOuter = FindOuterFaces(kind.Shape);
  const std::vector<BezierHexahedron> parts = conversion.Convert(type, nodes, 0);
  const std::vector<int> intervals =
    this->CountFieldIntervals(type, conversion, nodes, section.Nodes, parts.size());
  PartCutter cutter(this->Function, this->Tolerances.Shape);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    cutter.SetMinimumIntervals(intervals[i]);
    cutter.Cut(
      parts[i], isOuter,
      [&](const dvec3& parameters, double* values)
      { conversion.FindWeights(type, i, nodes, parameters, values); },
      section);
  }
}
}
