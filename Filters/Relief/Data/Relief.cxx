// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Relief.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Maps (c, r, w, 1) to (c, r, 1, w), which is (c d, r d, d, 1) divided by d.
dmat4 GetSwap()
{
  dmat4 swap(1.0);
  swap[2] = dvec4(0.0, 0.0, 0.0, 1.0);
  swap[3] = dvec4(0.0, 0.0, 1.0, 0.0);
  return swap;
}

bool IsFinite(const dmat4& matrix)
{
  for (int i = 0; i < 16; ++i)
  {
    if (!std::isfinite(matrix[i / 4][i % 4]))
    {
      return false;
    }
  }
  return true;
}

// Scales columns and then rows by their largest elements before the test, so that it does not
// depend on units.
bool IsSingular(const dmat4& matrix)
{
  dmat4 scaled = matrix;
  for (int pass = 0; pass < 2; ++pass)
  {
    for (int i = 0; i < 4; ++i)
    {
      const dvec4 size = abs(scaled[i]);
      const double largest = max(max(size.x, size.y), max(size.z, size.w));
      if (largest == 0.0)
      {
        return true;
      }
      scaled[i] /= largest;
    }
    scaled = transpose(scaled);
  }
  return !(std::abs(determinant(scaled)) > 1e-14);
}

// Returns the array if its numbers of components and tuples are correct, or null.
template <class ArrayType>
ArrayType* FindArray(vtkImageData* image, const char* name, int least, int most)
{
  auto* array = ArrayType::SafeDownCast(image->GetPointData()->GetAbstractArray(name));
  return array && array->GetNumberOfComponents() >= least &&
      array->GetNumberOfComponents() <= most &&
      array->GetNumberOfTuples() == image->GetNumberOfPoints()
    ? array
    : nullptr;
}

std::string Quote(const char* name)
{
  return std::string("'") + name + "'";
}
}

void Relief::Describe(vtkImageData* image, ReliefProjection projection, const dmat4& matrix)
{
  vtkNew<vtkIntArray> kind;
  kind->SetName(GetProjectionName());
  kind->InsertNextValue(static_cast<int>(projection));
  image->GetFieldData()->AddArray(kind);

  vtkNew<vtkDoubleArray> rows;
  rows->SetName(GetMatrixName());
  for (int i = 0; i < 16; ++i)
  {
    rows->InsertNextValue(matrix[i % 4][i / 4]);
  }
  image->GetFieldData()->AddArray(rows);
}

std::string Relief::Read(vtkImageData* image)
{
  *this = Relief();
  if (!image)
  {
    return "There is no image.";
  }
  this->Image = image;
  int size[3];
  image->GetDimensions(size);
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    return "The image has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
      std::to_string(size[2]) + " points; a relief has n x m x 1.";
  }
  this->Width = size[0];
  this->Height = size[1];
  std::string wrong = this->ReadArrays();
  if (wrong.empty())
  {
    wrong = this->ReadDescription();
  }
  return wrong.empty() ? this->ReadDepths() : wrong;
}

std::string Relief::ReadArrays()
{
  auto* colors = FindArray<vtkUnsignedCharArray>(this->Image, GetColorName(), 3, 4);
  auto* depths = FindArray<vtkFloatArray>(this->Image, GetDepthName(), 1, 1);
  if (!colors)
  {
    return "A relief needs the point array " + Quote(GetColorName()) +
      " of type unsigned char, with 3 or 4 components.";
  }
  if (!depths)
  {
    return "A relief needs the point array " + Quote(GetDepthName()) +
      " of type float, with one component.";
  }
  auto* normals = FindArray<vtkFloatArray>(this->Image, GetNormalsName(), 3, 3);
  if (!normals && this->Image->GetPointData()->GetAbstractArray(GetNormalsName()))
  {
    return "The point array " + Quote(GetNormalsName()) +
      " of a relief must be of type float, with 3 components.";
  }
  this->NumberOfColorComponents = colors->GetNumberOfComponents();
  this->Colors = colors->GetPointer(0);
  this->Depths = depths->GetPointer(0);
  this->Normals = normals ? normals->GetPointer(0) : nullptr;
  return "";
}

std::string Relief::ReadDescription()
{
  if (this->Image->GetFieldData()->HasArray(GetWarpName()))
  {
    return "The image is the output of vtkReliefWarper, whose depths do not match its texels: use "
           "the "
           "relief itself.";
  }
  vtkDataArray* kind = this->Image->GetFieldData()->GetArray(GetProjectionName());
  const double value = kind && kind->GetNumberOfValues() == 1 ? kind->GetComponent(0, 0) : -1.0;
  if (value != 0.0 && value != 1.0)
  {
    return "A relief needs the field array " + Quote(GetProjectionName()) +
      " with one value, 0 (parallel) or 1 (perspective).";
  }
  this->Projection = value == 0.0 ? ReliefProjection::Parallel : ReliefProjection::Perspective;

  vtkDataArray* rows = this->Image->GetFieldData()->GetArray(GetMatrixName());
  if (!rows || rows->GetNumberOfValues() != 16)
  {
    return "A relief needs the field array " + Quote(GetMatrixName()) +
      " of 16 values, row by row.";
  }
  dmat4 matrix;
  const int components = rows->GetNumberOfComponents();
  for (int i = 0; i < 16; ++i)
  {
    matrix[i % 4][i / 4] = rows->GetComponent(i / components, i % components);
  }
  if (!IsFinite(matrix) || IsSingular(matrix))
  {
    return "The field array " + Quote(GetMatrixName()) + " is a singular matrix.";
  }
  this->TexelToWorld = this->IsPerspective() ? matrix * GetSwap() : matrix;
  this->WorldToTexel = inverse(this->TexelToWorld);
  return "";
}

std::string Relief::ReadDepths()
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  const vtkIdType number = this->GetNumberOfTexels();
  for (vtkIdType i = 0; i < number; ++i)
  {
    const double depth = this->Depths[i];
    if (std::isfinite(depth))
    {
      ++this->NumberOfValidTexels;
      least = std::min(least, depth);
      most = std::max(most, depth);
    }
  }
  if (this->NumberOfValidTexels == 0)
  {
    return "No value of the point array " + Quote(GetDepthName()) + " is finite.";
  }
  if (this->IsPerspective() && least <= 0.0)
  {
    return "The point array " + Quote(GetDepthName()) + " has the value " + std::to_string(least) +
      "; depths in perspective must be more than 0.";
  }
  this->DepthRange = dvec2(least, most);
  return "";
}

dvec2 Relief::GetHeightRange() const
{
  const dvec2& range = this->DepthRange;
  return this->IsPerspective() ? dvec2(1.0 / range.y, 1.0 / range.x) : range;
}

double Relief::GetPlane() const
{
  return this->IsPerspective() ? 1.0 / this->DepthRange.x : 0.0;
}

double Relief::GetTexelHeight(int column, int row) const
{
  const double depth = this->Depths[static_cast<vtkIdType>(row) * this->Width + column];
  return std::isfinite(depth) ? this->ToHeight(depth) : std::numeric_limits<double>::quiet_NaN();
}

dvec3 Relief::GetWorldPoint(double column, double row, double height) const
{
  const dvec4 point = this->TexelToWorld * dvec4(column, row, height, 1.0);
  return dvec3(point) / point.w;
}
}
