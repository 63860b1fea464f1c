// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellReader.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr std::array<int, 8> PixelOrder{ 0, 1, 3, 2, 4, 5, 7, 6 };

// Degrees that the grid does not tell of.
int FindUniformDegree(CellShape shape, vtkIdType nodes)
{
  int degree = 1;
  while (GetNumberOfNodes(shape, ivec3(degree)) < nodes)
  {
    ++degree;
  }
  return GetNumberOfNodes(shape, ivec3(degree)) == nodes ? degree : 0;
}
}

vtkIdType GetNumberOfNodes(CellShape shape, const ivec3& degrees)
{
  const vtkIdType x = degrees.x + 1;
  const vtkIdType y = degrees.y + 1;
  const vtkIdType z = degrees.z + 1;
  switch (shape)
  {
    case CellShape::Triangle:
      return x * (x + 1) / 2;
    case CellShape::Quadrilateral:
      return x * y;
    case CellShape::Tetrahedron:
      return x * (x + 1) * (x + 2) / 6;
    case CellShape::Wedge:
      return x * (x + 1) / 2 * z;
    default:
      return x * y * z;
  }
}

CellReader::CellReader(vtkUnstructuredGrid* grid)
  : Grid(grid)
{
}

CellReader::~CellReader() = default;

void CellReader::Read(vtkIdType cell)
{
  this->Cell = cell;
  this->Grid->GetCells()->GetCellAtId(cell, this->Nodes); // safe in threads
  this->Kind = GetCellKind(this->Grid->GetCellType(cell), this->Nodes->GetNumberOfIds());
  this->ReadFaces();
}

vtkIdType CellReader::GetNumberOfNodes() const
{
  return this->Nodes->GetNumberOfIds();
}

vtkIdType CellReader::GetNode(vtkIdType node) const
{
  return this->Nodes->GetId(node);
}

ivec3 CellReader::GetDegrees() const
{
  const CellShape shape = this->Kind.Shape;
  const bool isOfOneDegree = shape == CellShape::Triangle || shape == CellShape::Tetrahedron;
  vtkDataArray* degrees = this->Grid->GetCellData()->GetHigherOrderDegrees();
  if (!degrees || isOfOneDegree)
  {
    return ivec3(FindUniformDegree(shape, this->Nodes->GetNumberOfIds()));
  }
  ivec3 result(0);
  const int components = std::min(degrees->GetNumberOfComponents(), 3);
  for (int c = 0; c < components && this->Cell < degrees->GetNumberOfTuples(); ++c)
  {
    const double degree = degrees->GetComponent(this->Cell, c);
    result[c] = degree >= 0.0 && degree <= 1e6 ? static_cast<int>(degree) : 0;
  }
  return result;
}

void CellReader::ReadFaces()
{
  const vtkIdType nodes = this->Nodes->GetNumberOfIds();
  if (this->Kind.Shape == CellShape::Polyhedron)
  {
    this->ReadPolyhedron();
    return;
  }
  if (this->Kind.Shape == CellShape::Polygon)
  {
    this->Faces.resize(1);
    this->Faces[0].assign(this->Nodes->begin(), this->Nodes->end());
    return;
  }
  if (this->Kind.Shape == CellShape::TriangleStrip)
  {
    this->Faces.resize(std::max<vtkIdType>(nodes - 2, 0));
    for (vtkIdType i = 0; i + 2 < nodes; ++i)
    {
      this->Faces[i] = { this->GetNode(i), this->GetNode(i + 1 + i % 2),
        this->GetNode(i + 2 - i % 2) };
    }
    return;
  }
  this->Faces.resize(relevo::GetNumberOfFaces(this->Kind.Shape));
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    const FaceCorners corners = this->GetFaceCorners(static_cast<int>(i));
    this->Faces[i].clear();
    for (int k = 0; k < corners.Size && corners.Corners[k] < nodes; ++k)
    {
      this->Faces[i].push_back(this->GetNode(corners.Corners[k]));
    }
  }
}

void CellReader::ReadPolyhedron()
{
  // How many faces; of each face, how many points, and these.
  this->Grid->GetFaceStream(this->Cell, this->Stream);
  this->Faces.clear();
  const vtkIdType size = this->Stream->GetNumberOfIds();
  for (vtkIdType i = 1; i < size;)
  {
    const vtkIdType corners = this->Stream->GetId(i++);
    if (corners < 0 || corners > size - i)
    {
      this->Faces.clear();
      return;
    }
    const vtkIdType* points = this->Stream->GetPointer(i);
    this->Faces.emplace_back(points, points + corners);
    i += corners;
  }
}

FaceCorners CellReader::GetFaceCorners(int face) const
{
  FaceCorners corners = GetFace(this->Kind.Shape, face);
  for (int k = 0; k < corners.Size && this->Kind.IsInPixelOrder; ++k)
  {
    corners.Corners[k] = PixelOrder[corners.Corners[k]];
  }
  return corners;
}

bool CellReader::IsInsideOut() const
{
  if (!this->Kind.IsSolid())
  {
    return false;
  }
  dvec3 origin;
  this->Grid->GetPoint(this->Faces[0][0], &origin.x);
  double volume = 0.0;
  for (const std::vector<vtkIdType>& face : this->Faces)
  {
    std::array<dvec3, 3> x;
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      this->Grid->GetPoint(face[k], &x[std::min<std::size_t>(k, 2)].x);
      x[std::min<std::size_t>(k, 2)] -= origin;
      if (k >= 2)
      {
        volume += dot(x[0], cross(x[1], x[2]));
        x[1] = x[2];
      }
    }
  }
  return volume < 0.0;
}
}
