// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMicroMeshSurface.h"

#include "Data/MicroMeshArrays.h"
#include "Tables/MicroMeshTables.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "relevoMicroCells.h"
#include "relevoMicroField.h"
#include "relevoMicroMesh.h"
#include "relevoMicroTriangle.h"

#include <algorithm>

vtkStandardNewMacro(vtkMicroMeshSurface);

vtkMicroMeshSurface::vtkMicroMeshSurface() = default;
vtkMicroMeshSurface::~vtkMicroMeshSurface() = default;

bool vtkMicroMeshSurface::GetPointValues(vtkPolyData* mesh, float* values, std::string& error)
{
  auto directions = vtkFloatArray::SafeDownCast(
    mesh->GetPointData()->GetAbstractArray(relevo::MicroDirectionsName));
  if (!directions || directions->GetNumberOfComponents() != 3 ||
    directions->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    error = std::string("the mesh is not a micro-mesh: it has no point array \"") +
      relevo::MicroDirectionsName + "\" of 3 floats. Use vtkMicroMeshFilter";
    return false;
  }
  std::copy_n(directions->GetPointer(0), 3 * mesh->GetNumberOfPoints(), values);
  return true;
}

bool vtkMicroMeshSurface::BuildTables(
  vtkPolyData* mesh, const double*, Tables& tables, std::string& error)
{
  return relevo::BuildMicroMeshTables(mesh, tables, error);
}

void vtkMicroMeshSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  relevo::MicroMeshFace micro(face);
  const relevo::MicroMeshFace::MicroPoint point =
    micro.microPoint(relevo::MicroMeshFace::Load(weights));
  relevo::store(point.Position, position);
  relevo::store(point.Normal, normal);
}

vtkDataArray* vtkMicroMeshSurface::FindCoefficients(vtkPolyData* mesh, vtkDataArray* pointArray)
{
  return relevo::FindMicroPointData(mesh, pointArray);
}

void vtkMicroMeshSurface::EvaluateField(
  const Face& face, const float weights[3], vtkDataArray* coefficients, double* tuple)
{
  relevo::EvaluateMicroPointData(face, weights, coefficients, tuple);
}

void vtkMicroMeshSurface::ExtendBox(const Face& face, double low[3], double high[3])
{
  const relevo::MicroMeshFace micro(face);
  const glm::ivec2 range = micro.GetRange();
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int end = 0; end < 2; ++end)
    {
      const glm::dvec3 point = glm::dvec3(micro.cornerPoint(corner)) +
        double(range[end]) * glm::dvec3(glm::vec3(micro.cornerValues(corner)));
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], point[c]);
        high[c] = std::max(high[c], point[c]);
      }
    }
  }
}

std::string vtkMicroMeshSurface::GetShaderSource()
{
  return relevoMicroMesh;
}

std::string vtkMicroMeshSurface::GetFieldShaderSource()
{
  return std::string(relevoMicroTriangle) + relevoMicroField;
}

vtkSmartPointer<vtkDataArray> vtkMicroMeshSurface::FindCellValues(
  vtkPolyData* mesh, vtkDataArray* cellArray)
{
  return relevo::FindMicroCellData(mesh, cellArray);
}

vtkIdType vtkMicroMeshSurface::FindCellTuple(const Face& face, const float weights[3])
{
  return relevo::FindMicroCellTuple(face, weights);
}

std::string vtkMicroMeshSurface::GetCellFieldShaderSource()
{
  return std::string(relevoMicroTriangle) + relevoMicroCells + R"(
struct FieldPlace
{
  ivec3 Indices; // of values
  vec3 Weights;
};

FieldPlace fieldPlace(ivec2 record, vec3 w)
{
  FieldPlace place;
  place.Indices = ivec3(microCell(record, w));
  place.Weights = vec3(1.0, 0.0, 0.0);
  return place;
}
)";
}

void vtkMicroMeshSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
