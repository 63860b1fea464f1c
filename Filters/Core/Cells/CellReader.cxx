// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellReader.h"

#include "Compatibility/VTKCompatibility.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace relevo
{
namespace
{
// The degree of a cell for which the grid stores none.
int FindUniformDegree(CellTopology shape, vtkIdType nodes)
{
  int degree = 1;
  while (GetNumberOfNodes(shape, ivec3(degree)) < nodes)
  {
    ++degree;
  }
  return GetNumberOfNodes(shape, ivec3(degree)) == nodes ? degree : 0;
}
}

vtkIdType GetNumberOfNodes(CellTopology shape, const ivec3& degrees)
{
  const vtkIdType x = degrees.x + 1;
  const vtkIdType y = degrees.y + 1;
  const vtkIdType z = degrees.z + 1;
  switch (shape)
  {
    case CellTopology::Triangle:
      return x * (x + 1) / 2;
    case CellTopology::Quadrilateral:
      return x * y;
    case CellTopology::Tetrahedron:
      return x * (x + 1) * (x + 2) / 6;
    case CellTopology::Wedge:
      return x * (x + 1) / 2 * z;
    default:
      return x * y * z;
  }
}

CellReader::CellReader(vtkUnstructuredGrid* grid)
  : Grid(grid)
  , NumberOfTypes(GetNumberOfCellTypes(grid))
{
}

CellReader::~CellReader() = default;

bool CellReader::ReadNodes(vtkIdType cell)
{
  this->Cell = cell;
  const bool isListed =
    cell < this->NumberOfTypes && ReadCellPoints(this->Grid->GetCells(), cell, this->Nodes);
  this->Type = isListed ? this->Grid->GetCellType(cell) : VTK_EMPTY_CELL;
  this->Kind = GetCellKind(this->Type, this->Nodes->GetNumberOfIds());
  this->Faces.clear();
  return isListed;
}

bool CellReader::Read(vtkIdType cell)
{
  const bool isListed = this->ReadNodes(cell);
  this->ReadFaces();
  return isListed;
}

vtkIdType CellReader::GetNumberOfNodes() const
{
  return this->Nodes->GetNumberOfIds();
}

vtkIdType CellReader::GetNode(vtkIdType node) const
{
  return this->Nodes->GetId(node);
}

// The degree of simplices follows from their number of nodes.
ivec3 CellReader::GetDegrees() const
{
  const CellTopology shape = this->Kind.Shape;
  if (IsSimplex(shape) || !this->GetDegreeArray())
  {
    return ivec3(FindUniformDegree(shape, this->Nodes->GetNumberOfIds()));
  }
  ivec3 result(0);
  for (int c = 0; c < 3 && !this->LacksDegrees(); ++c)
  {
    const double degree = this->GetGivenDegree(c);
    result[c] = degree >= 0.0 && degree <= 1e6 ? static_cast<int>(degree) : 0;
  }
  return result;
}

vtkDataArray* CellReader::GetDegreeArray() const
{
  return this->Grid->GetCellData()->GetHigherOrderDegrees();
}

bool CellReader::LacksDegrees() const
{
  vtkDataArray* degrees = this->GetDegreeArray();
  return degrees &&
    (degrees->GetNumberOfComponents() != 3 || this->Cell >= degrees->GetNumberOfTuples());
}

double CellReader::GetGivenDegree(int direction) const
{
  vtkDataArray* degrees = this->GetDegreeArray();
  return degrees ? degrees->GetComponent(this->Cell, direction) : this->GetDegrees()[direction];
}

void CellReader::ReadFaces()
{
  const vtkIdType nodes = this->Nodes->GetNumberOfIds();
  if (this->Kind.Shape == CellTopology::Polyhedron)
  {
    if (!ReadPolyhedronFaces(this->Grid, this->Cell, this->Scratch, this->Faces))
    {
      this->Faces.clear();
    }
    return;
  }
  if (this->Kind.Shape == CellTopology::Polygon)
  {
    this->Faces.resize(1);
    this->Faces[0].assign(this->Nodes->begin(), this->Nodes->end());
    return;
  }
  if (this->Kind.Shape == CellTopology::TriangleStrip)
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
    const CornerNodes corners = this->GetCornerNodes(static_cast<int>(i));
    this->Faces[i].clear();
    for (int k = 0; k < corners.Size && corners.Corners[k] < nodes; ++k)
    {
      this->Faces[i].push_back(this->GetNode(corners.Corners[k]));
    }
  }
}

CornerNodes CellReader::GetCornerNodes(int face) const
{
  return GetFaceNodes(this->Kind, face);
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
