// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMicroMeshFilter.h"

#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Data/MicroGrid.h"
#include "Data/MicroMeshArrays.h"
#include "Dense/DenseMesh.h"
#include "Encoding/AttributeSampling.h"
#include "Encoding/FaceOrder.h"
#include "Encoding/MicroMeshEncoder.h"
#include "Encoding/MicroMeshOutput.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMicroMeshFilter);

vtkMicroMeshFilter::vtkMicroMeshFilter() = default;
vtkMicroMeshFilter::~vtkMicroMeshFilter() = default;

void vtkMicroMeshFilter::SetTolerance(double tolerance)
{
  if (!(tolerance > 0.0) || !std::isfinite(tolerance))
  {
    vtkErrorMacro("Tolerance must be more than 0 and finite, got " << tolerance << ".");
  }
  else if (this->Tolerance != tolerance)
  {
    this->Tolerance = tolerance;
    this->Modified();
  }
}

void vtkMicroMeshFilter::SetTargetReduction(double reduction)
{
  relevo::SetInRange(this, "TargetReduction", this->TargetReduction, reduction, 0.0, 1.0);
}

void vtkMicroMeshFilter::SetMaximumLevel(int level)
{
  relevo::SetInRange(this, "MaximumLevel", this->MaximumLevel, level, 0, relevo::LargestMicroLevel);
}

void vtkMicroMeshFilter::SetFeatureAngle(double degrees)
{
  relevo::SetInRange(this, "FeatureAngle", this->FeatureAngle, degrees, 0.0, 180.0);
}

void vtkMicroMeshFilter::SetMaterialArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->MaterialArrayName != text)
  {
    this->MaterialArrayName = text;
    this->Modified();
  }
}

void vtkMicroMeshFilter::SetFixedPointArrayName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->FixedPointArrayName != text)
  {
    this->FixedPointArrayName = text;
    this->Modified();
  }
}

bool vtkMicroMeshFilter::CheckInput(vtkPolyData* input)
{
  if (this->Tolerance == 0.0)
  {
    vtkErrorMacro("Tolerance is not set. Call SetTolerance() with a length above 0.");
    return false;
  }
  constexpr vtkIdType mostTriangles = 500000000;
  constexpr double mostCoordinate = 1e300;
  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    if (cells->GetNumberOfConnectivityIds() > 3 * mostTriangles)
    {
      vtkErrorMacro("The input has more than " << mostTriangles << " triangles.");
      return false;
    }
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* points;
      iterator->GetCurrentCell(size, points);
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (points[i] < 0 || points[i] >= input->GetNumberOfPoints())
        {
          vtkErrorMacro("Cell " << cell << " of the input refers to point " << points[i]
                                << ", but there are " << input->GetNumberOfPoints() << " points.");
          return false;
        }
        double x[3];
        input->GetPoint(points[i], x);
        if (!std::all_of(x, x + 3, [](double value) { return std::abs(value) <= mostCoordinate; }))
        {
          vtkErrorMacro("Point " << points[i] << " of the input, which cell " << cell
                                 << " refers to, is not finite or exceeds 1e300.");
          return false;
        }
      }
      ++cell;
    }
  }
  return true;
}

bool vtkMicroMeshFilter::FindMaterials(vtkPolyData* input, vtkDataArray*& materials)
{
  materials = nullptr;
  if (this->MaterialArrayName.empty())
  {
    return true;
  }
  materials = input->GetCellData()->GetArray(this->MaterialArrayName.c_str());
  if (!materials)
  {
    vtkErrorMacro("The input has no numeric cell array \"" << this->MaterialArrayName
                                                           << "\" with the materials.");
    return false;
  }
  if (materials->GetNumberOfTuples() < input->GetNumberOfCells())
  {
    vtkErrorMacro("The cell array \"" << this->MaterialArrayName << "\" has "
                                      << materials->GetNumberOfTuples() << " tuples, but there are "
                                      << input->GetNumberOfCells() << " cells.");
    return false;
  }
  return true;
}

bool vtkMicroMeshFilter::FindFixedPoints(vtkPolyData* input, vtkDataArray*& fixed)
{
  fixed = nullptr;
  if (this->FixedPointArrayName.empty())
  {
    return true;
  }
  fixed = input->GetPointData()->GetArray(this->FixedPointArrayName.c_str());
  if (!fixed)
  {
    vtkErrorMacro("The input has no numeric point array \"" << this->FixedPointArrayName
                                                            << "\" with the fixed points.");
    return false;
  }
  if (fixed->GetNumberOfTuples() < input->GetNumberOfPoints() ||
    (fixed->GetNumberOfComponents() != 1 && fixed->GetNumberOfComponents() != 4))
  {
    vtkErrorMacro("The point array \""
      << this->FixedPointArrayName << "\" has " << fixed->GetNumberOfTuples() << " tuples of "
      << fixed->GetNumberOfComponents() << " components, but " << input->GetNumberOfPoints()
      << " of 1 or 4 are needed.");
    return false;
  }
  return true;
}

void vtkMicroMeshFilter::RemoveShortArrays(vtkPolyData* mesh)
{
  const auto remove = [this](vtkDataSetAttributes* data, vtkIdType tuples)
  {
    for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      if (array->GetNumberOfTuples() < tuples)
      {
        vtkWarningMacro("Array \"" << (array->GetName() ? array->GetName() : "")
                                   << "\" has too few tuples and is left out.");
        data->RemoveArray(i);
      }
    }
  };
  remove(mesh->GetPointData(), mesh->GetNumberOfPoints());
  remove(mesh->GetCellData(), mesh->GetNumberOfCells());
}

void vtkMicroMeshFilter::WarnOfTriangles(const relevo::DenseMesh& dense)
{
  if (dense.NumberOfDegenerateTriangles > 0)
  {
    vtkWarningMacro(<< dense.NumberOfDegenerateTriangles
                    << " triangles with coincident corners are left out.");
  }
  if (dense.NumberOfDuplicates > 0)
  {
    vtkWarningMacro(<< dense.NumberOfDuplicates << " duplicates of triangles are left out.");
  }
  if (dense.NumberOfUnclearEdges > 0)
  {
    vtkWarningMacro(<< dense.NumberOfUnclearEdges
                    << " edges have more than two triangles or inconsistent winding and are kept.");
  }
}

void vtkMicroMeshFilter::WarnOfSharpEdges(const relevo::DenseMesh& dense, vtkIdType faces)
{
  constexpr double many = 0.1;
  const auto triangles = static_cast<vtkIdType>(dense.Triangles.size());
  const auto edges = 1.5 * static_cast<double>(triangles);
  if (static_cast<double>(dense.NumberOfSharpEdges) > many * edges &&
    static_cast<double>(faces) > many * static_cast<double>(triangles))
  {
    vtkWarningMacro(<< "The coarse mesh has " << faces << " of " << triangles
                    << " triangles, because " << dense.NumberOfSharpEdges
                    << " edges are sharper than FeatureAngle, " << this->FeatureAngle
                    << " degrees, and are kept. If these are noise, set "
                    << "FeatureAngle to 180, or smooth the mesh first.");
  }
}

int vtkMicroMeshFilter::Encode(vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* materials = nullptr;
  vtkDataArray* fixed = nullptr;
  if (!this->CheckInput(input) || !this->FindMaterials(input, materials) ||
    !this->FindFixedPoints(input, fixed))
  {
    return 0;
  }
  if (input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    return 1;
  }
  vtkNew<vtkPolyData> whole;
  whole->ShallowCopy(input);
  this->RemoveShortArrays(whole);
  const relevo::DenseMesh dense(whole, materials, this->FeatureAngle, fixed);
  this->WarnOfTriangles(dense);
  if (dense.Triangles.empty())
  {
    return 1;
  }
  const auto encoded =
    relevo::EncodeMicroMesh(dense, { this->Tolerance, this->TargetReduction, this->MaximumLevel },
      [this](double share)
      {
        this->UpdateProgress(share);
        return !relevo::IsAborted(this);
      });
  if (!encoded)
  {
    return 1; // aborted
  }
  this->Error = std::max(encoded->InputToResult, encoded->ResultToInput);
  this->WarnOfSharpEdges(dense, static_cast<vtkIdType>(encoded->Mesh.Faces.size()));
  relevo::OrderFaces(*encoded);
  relevo::StoreEncodedMesh(dense, *encoded, whole, output);
  double bounds[6];
  input->GetBounds(bounds);
  relevo::StoreInputBounds(bounds, output);
  if (!this->PassThroughCellIds)
  {
    output->GetCellData()->RemoveArray("vtkOriginalCellIds");
  }
  if (this->Attributes)
  {
    whole->GetPointData()->RemoveArray(this->FixedPointArrayName.c_str());
    relevo::SampleAttributes(dense, *encoded, whole, output);
  }
  return 1;
}

int vtkMicroMeshFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Error = 0.0;
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  return relevo::RequestWithinMemory(this, outputVector, "the micro-mesh",
    [&] {
      return this->Encode(vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(outputVector));
    });
}

void vtkMicroMeshFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "TargetReduction: " << this->TargetReduction << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MaterialArrayName: " << this->MaterialArrayName << "\n";
  os << indent << "FixedPointArrayName: " << this->FixedPointArrayName << "\n";
  os << indent << "Attributes: " << (this->Attributes ? "on" : "off") << "\n";
  os << indent << "PassThroughCellIds: " << (this->PassThroughCellIds ? "on" : "off") << "\n";
  os << indent << "Error: " << this->Error << "\n";
}
