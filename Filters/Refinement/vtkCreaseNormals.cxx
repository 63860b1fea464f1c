// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCreaseNormals.h"

#include "Checks/InputType.h"
#include "Checks/SettingChecks.h"
#include "Mesh/CreaseNormals.h"
#include "Mesh/GivenNormals.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkInformationVector.h"
#include "vtkLinearSurface.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace
{
// The mesh with one point for each different normal at its points.
class SplitMesh
{
public:
  SplitMesh(vtkPolyData* input, const relevo::CreaseNormals& normals)
    : Input(input)
    , Normals(normals)
    , Copies(static_cast<size_t>(input->GetNumberOfPoints()), -1)
    , Next(this->Copies)
  {
    this->Sources.reserve(this->Copies.size());
    for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
    {
      this->Sources.push_back(point);
    }
    this->OutputNormals.resize(this->Copies.size(), relevo::dvec3(0.0));
  }

  void Build(vtkPolyData* output)
  {
    vtkNew<vtkCellArray> polygons;
    this->SplitPolygons(polygons);
    const std::vector<vtkIdType> stripCells = this->AddStrips(polygons);
    output->SetVerts(this->Input->GetVerts());
    output->SetLines(this->Input->GetLines());
    output->SetPolys(polygons);
    this->CopyPoints(output);
    this->CopyCellData(stripCells, output);
  }

private:
  // Returns the point with the normal at a triangle's corner.
  vtkIdType FindPoint(vtkIdType triangle, int corner)
  {
    const double rounding = 1e-5;
    const vtkIdType point = this->Normals.GetTriangles().GetPoints(triangle)[corner];
    const relevo::dvec3& normal = this->Normals.GetNormal(triangle, corner);
    if (this->Copies[point] < 0)
    {
      this->Copies[point] = point;
      this->OutputNormals[point] = normal;
      return point;
    }
    vtkIdType copy = this->Copies[point];
    for (; copy >= 0; copy = this->Next[copy])
    {
      const relevo::dvec3 difference = this->OutputNormals[copy] - normal;
      if (relevo::dot(difference, difference) <= rounding * rounding)
      {
        return copy;
      }
    }
    copy = static_cast<vtkIdType>(this->Sources.size());
    this->Sources.push_back(point);
    this->OutputNormals.push_back(normal);
    this->Next.push_back(this->Next[point]);
    this->Next[point] = copy;
    return copy;
  }

  // Polygons keep all corners, including those that no triangle has.
  void SplitPolygons(vtkCellArray* polygons)
  {
    const relevo::SurfaceTriangles& triangles = this->Normals.GetTriangles();
    const auto numberOfTriangles = static_cast<vtkIdType>(triangles.GetTriangles().size());
    std::vector<vtkIdType> cellOfPoint(this->Copies.size(), -1);
    std::vector<vtkIdType> copyOfPoint(this->Copies.size(), -1);
    std::vector<vtkIdType> corners;
    vtkIdType cell = this->Input->GetNumberOfVerts() + this->Input->GetNumberOfLines();
    vtkIdType triangle = 0;
    auto polygon = vtk::TakeSmartPointer(this->Input->GetPolys()->NewIterator());
    for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell(), ++cell)
    {
      for (; triangle < numberOfTriangles && triangles.GetCell(triangle) == cell; ++triangle)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          const vtkIdType point = triangles.GetPoints(triangle)[corner];
          if (cellOfPoint[point] != cell)
          {
            cellOfPoint[point] = cell;
            copyOfPoint[point] = this->FindPoint(triangle, corner);
          }
        }
      }
      vtkIdType size;
      const vtkIdType* points;
      polygon->GetCurrentCell(size, points);
      corners.assign(points, points + size);
      for (vtkIdType& point : corners)
      {
        point = cellOfPoint[point] == cell ? copyOfPoint[point] : point;
      }
      polygons->InsertNextCell(size, corners.data());
    }
    this->FirstStripTriangle = triangle;
  }

  // Adds the strips' triangles and returns their cells.
  std::vector<vtkIdType> AddStrips(vtkCellArray* polygons)
  {
    const relevo::SurfaceTriangles& triangles = this->Normals.GetTriangles();
    const auto numberOfTriangles = static_cast<vtkIdType>(triangles.GetTriangles().size());
    std::vector<vtkIdType> cells;
    for (vtkIdType t = this->FirstStripTriangle; t < numberOfTriangles; ++t)
    {
      const vtkIdType corners[3] = { this->FindPoint(t, 0), this->FindPoint(t, 1),
        this->FindPoint(t, 2) };
      polygons->InsertNextCell(3, corners);
      cells.push_back(triangles.GetCell(t));
    }
    return cells;
  }

  void CopyPoints(vtkPolyData* output) const
  {
    const auto size = static_cast<vtkIdType>(this->Sources.size());
    vtkNew<vtkPoints> points;
    points->SetDataType(this->Input->GetPoints()->GetDataType());
    points->SetNumberOfPoints(size);
    vtkPointData* data = output->GetPointData();
    data->CopyAllOn();
    data->CopyAllocate(this->Input->GetPointData(), size);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(size);
    vtkDataArray* given = relevo::GetGivenNormals(this->Input);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType source = this->Sources[i];
      points->SetPoint(i, this->Input->GetPoint(source));
      data->CopyData(this->Input->GetPointData(), source, i);
      // Points that no face uses keep their normals.
      const bool isUsed = i >= this->Input->GetNumberOfPoints() || this->Copies[i] >= 0;
      normals->SetTuple(i, given && !isUsed ? given->GetTuple(i) : &this->OutputNormals[i][0]);
    }
    output->SetPoints(points);
    data->SetNormals(normals);
  }

  void CopyCellData(const std::vector<vtkIdType>& stripCells, vtkPolyData* output) const
  {
    vtkCellData* from = this->Input->GetCellData();
    if (stripCells.empty() && this->Input->GetNumberOfStrips() == 0)
    {
      output->GetCellData()->PassData(from);
      return;
    }
    vtkCellData* data = output->GetCellData();
    const vtkIdType firstStrip = this->Input->GetNumberOfCells() - this->Input->GetNumberOfStrips();
    data->CopyAllOn();
    data->CopyAllocate(from, firstStrip + static_cast<vtkIdType>(stripCells.size()));
    for (vtkIdType cell = 0; cell < firstStrip; ++cell)
    {
      data->CopyData(from, cell, cell);
    }
    vtkIdType cell = firstStrip;
    for (vtkIdType strip : stripCells)
    {
      data->CopyData(from, strip, cell++);
    }
  }

  vtkPolyData* Input;
  const relevo::CreaseNormals& Normals;
  std::vector<vtkIdType> Copies;  // per input point: itself if a corner uses it, else -1
  std::vector<vtkIdType> Next;    // per point: another copy of the same point
  std::vector<vtkIdType> Sources; // per point: the input point
  std::vector<relevo::dvec3> OutputNormals;
  vtkIdType FirstStripTriangle = 0;
};

// Whether all cells refer to existing points.
bool HasAllPoints(vtkPolyData* mesh, vtkIdType& cell, vtkIdType& point)
{
  cell = 0;
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
         iterator->GoToNextCell(), ++cell)
    {
      vtkIdType size;
      const vtkIdType* points;
      iterator->GetCurrentCell(size, points);
      const vtkIdType* missing = std::find_if(points, points + size,
        [&](vtkIdType id) { return id < 0 || id >= mesh->GetNumberOfPoints(); });
      if (missing != points + size)
      {
        point = *missing;
        return false;
      }
    }
  }
  return true;
}
}

vtkStandardNewMacro(vtkCreaseNormals);

vtkCreaseNormals::vtkCreaseNormals() = default;

vtkCreaseNormals::~vtkCreaseNormals() = default;

void vtkCreaseNormals::SetFeatureAngle(double angle)
{
  relevo::SetInRange(this, "FeatureAngle", this->FeatureAngle, angle, 0.0, 180.0);
}

vtkRefinementSurface* vtkCreaseNormals::GetFittingSurface()
{
  return this->FittingSurface;
}

int vtkCreaseNormals::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->FittingSurface = nullptr;
  this->NumberOfCreases = 0;
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkIdType cell;
  vtkIdType point;
  if (!HasAllPoints(input, cell, point))
  {
    vtkErrorMacro("Cell " << cell << " refers to point " << point << ", but there are "
                          << input->GetNumberOfPoints() << " points.");
    return 0;
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  bool isCurved = false;
  if (input->GetNumberOfPoints() > 0)
  {
    const relevo::CreaseNormals normals(
      input, vtkMath::RadiansFromDegrees(this->FeatureAngle), this->KeepCoarseFlat);
    this->NumberOfCreases = normals.GetNumberOfCreases();
    isCurved = normals.AreCurved();
    this->UpdateProgress(0.5);
    SplitMesh(input, normals).Build(output);
  }
  this->FittingSurface = isCurved
    ? vtkSmartPointer<vtkRefinementSurface>::Take(vtkPNTriangleSurface::New())
    : vtkSmartPointer<vtkRefinementSurface>::Take(vtkLinearSurface::New());
  return 1;
}

void vtkCreaseNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "KeepCoarseFlat: " << this->KeepCoarseFlat << "\n";
  os << indent << "NumberOfCreases: " << this->NumberOfCreases << "\n";
  os << indent << "FittingSurface: " << this->FittingSurface.Get() << "\n";
}
