// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHairSource.h"

#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Curves/HairGrowth.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <new>
#include <vector>

vtkStandardNewMacro(vtkHairSource);

namespace
{
constexpr double MaximumHairs = 1e9; // more than memory can hold
constexpr double StrongestGravity = 1000.0;

// The preallocated arrays of all hairs.
struct Hairs
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Radii;
  vtkNew<vtkIdTypeArray> Ids;
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIntArray> Degrees;
  vtkNew<vtkIdTypeArray> Cells;

  Hairs(vtkIdType curves, vtkIdType points)
  {
    this->Points->SetDataTypeToDouble();
    this->Points->SetNumberOfPoints(points);
    this->Radii->SetName("HairRadius");
    this->Radii->SetNumberOfValues(points);
    this->Ids->SetNumberOfValues(4 * curves);
    this->Offsets->SetNumberOfValues(curves + 1);
    this->Degrees->SetName("HigherOrderDegrees");
    this->Degrees->SetNumberOfComponents(3);
    this->Degrees->SetNumberOfTuples(curves);
    this->Cells->SetName("vtkOriginalCellIds");
    this->Cells->SetNumberOfValues(curves);
    this->Offsets->SetValue(curves, 4 * curves);
  }

  void Set(const relevo::HairGrowth& growth, vtkIdType hair, std::vector<relevo::dvec3>& places)
  {
    const vtkIdType cell = growth.Grow(hair, places.data());
    const vtkIdType first = hair * growth.GetNumberOfPoints();
    for (int i = 0; i < growth.GetNumberOfPoints(); ++i)
    {
      this->Points->SetPoint(first + i, &places[i].x);
      this->Radii->SetValue(first + i, static_cast<float>(growth.GetRadius(i)));
    }
    for (int i = 0; i < growth.GetNumberOfCurves(); ++i)
    {
      // VTK stores both ends first.
      const vtkIdType curve = hair * growth.GetNumberOfCurves() + i;
      const vtkIdType start = first + 3 * i;
      const std::array<vtkIdType, 4> points{ start, start + 3, start + 1, start + 2 };
      std::copy(points.begin(), points.end(), this->Ids->GetPointer(4 * curve));
      this->Offsets->SetValue(curve, 4 * curve);
      const std::array<int, 3> degrees{ 3, 0, 0 };
      this->Degrees->SetTypedTuple(curve, degrees.data());
      this->Cells->SetValue(curve, cell);
    }
  }

  void MoveTo(vtkUnstructuredGrid* output)
  {
    vtkNew<vtkCellArray> cells;
    cells->SetData(this->Offsets, this->Ids);
    output->SetPoints(this->Points);
    output->SetCells(VTK_BEZIER_CURVE, cells);
    output->GetPointData()->AddArray(this->Radii);
    output->GetCellData()->SetHigherOrderDegrees(this->Degrees);
    output->GetCellData()->AddArray(this->Cells);
  }
};
}

vtkHairSource::vtkHairSource() = default;
vtkHairSource::~vtkHairSource() = default;

void vtkHairSource::SetDensity(double density)
{
  relevo::SetInRange(this, "Density", this->Density, density, this->GetDensityMinValue(),
    this->GetDensityMaxValue());
}

void vtkHairSource::SetLength(double length)
{
  relevo::SetInRange(
    this, "Length", this->Length, length, this->GetLengthMinValue(), this->GetLengthMaxValue());
}

void vtkHairSource::SetCurl(double turns)
{
  relevo::SetInRange(
    this, "Curl", this->Curl, turns, this->GetCurlMinValue(), this->GetCurlMaxValue());
}

void vtkHairSource::SetGravity(double x, double y, double z)
{
  relevo::SetVector<3>(
    this, "Gravity", this->Gravity, { x, y, z }, -StrongestGravity, StrongestGravity);
}

int vtkHairSource::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

bool vtkHairSource::Grow(vtkPolyData* input, vtkUnstructuredGrid* output)
{
  const relevo::HairGrowth growth(input,
    { this->Density, this->Length, this->Curl, this->Seed,
      relevo::dvec3(this->Gravity[0], this->Gravity[1], this->Gravity[2]) });
  if (growth.GetNumberOfBadTriangles() > 0)
  {
    vtkWarningMacro(<< growth.GetNumberOfBadTriangles()
                    << " triangles have no hair: they have no area, or points that do not exist "
                       "or are not finite.");
  }
  if (!(growth.GetArea() > 0.0))
  {
    vtkErrorMacro("The input's polygons have no area for hair to grow on.");
    return false;
  }
  const double number = growth.GetNumberOfHairs();
  if (number > MaximumHairs)
  {
    throw std::bad_alloc();
  }
  const auto hairs = static_cast<vtkIdType>(number);
  Hairs all(hairs * growth.GetNumberOfCurves(), hairs * growth.GetNumberOfPoints());
  vtkSMPTools::For(0, hairs,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<relevo::dvec3> places(growth.GetNumberOfPoints());
      for (vtkIdType hair = begin; hair < end; ++hair)
      {
        all.Set(growth, hair, places);
      }
    });
  all.MoveTo(output);
  return true;
}

int vtkHairSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (input->GetNumberOfPoints() == 0 ||
    input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    vtkErrorMacro("The input has no polygons for hair to grow on.");
    return 0;
  }
  return relevo::RequestWithinMemory(this, outputVector, "the hairs: lower Density",
    [&] { return this->Grow(input, vtkUnstructuredGrid::GetData(outputVector)) ? 1 : 0; });
}

void vtkHairSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "Curl: " << this->Curl << "\n";
  os << indent << "Gravity: " << this->Gravity[0] << " " << this->Gravity[1] << " "
     << this->Gravity[2] << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
