// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Image/LICVectors.h"

#include "Arrays/VectorData.h"
#include "Mesh/PointBlanking.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// Converts vectors to units of samples.
class SampleUnits
{
public:
  SampleUnits(vtkImageData* image, const relevo::LICPlane& plane, int numberOfComponents)
  {
    const double* spacing = image->GetSpacing();
    const double* direction = image->GetDirectionMatrix()->GetData();
    this->Valid = true;
    for (int axis = 0; axis < 2; ++axis)
    {
      const int a = plane.Axes[axis];
      this->Spacing[axis] = spacing[a];
      this->Valid = this->Valid && std::isfinite(spacing[a]) && spacing[a] != 0.0;
      for (int c = 0; c < 3; ++c)
      {
        // The direction matrix is orthonormal, so that its inverse is the transpose.
        this->Directions[axis][c] =
          numberOfComponents == 2 ? (c == axis ? 1.0 : 0.0) : direction[3 * c + a];
      }
    }
  }

  bool IsValid() const { return this->Valid; }

  // Projects a vector to the plane, in units of the array.
  relevo::dvec2 Project(const double vector[3]) const
  {
    relevo::dvec2 projected;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double* d = this->Directions[axis];
      projected[axis] = d[0] * vector[0] + d[1] * vector[1] + d[2] * vector[2];
    }
    return projected;
  }

  relevo::dvec2 ToSamples(const relevo::dvec2& projected) const
  {
    return projected / this->Spacing;
  }

private:
  bool Valid;
  relevo::dvec2 Spacing;
  double Directions[2][3];
};

bool IsFinite(const relevo::dvec2& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y);
}

// Tests whether data is available.
class Validity
{
public:
  Validity(vtkImageData* image, int numberOfComponents, double noDataMagnitude)
    : Blanking(image)
    , NumberOfComponents(numberOfComponents)
    , NoDataMagnitude(noDataMagnitude)
  {
  }

  bool HasData(vtkIdType point, const double* tuple) const
  {
    return !this->Blanking.IsHidden(point) &&
      relevo::IsVectorData(tuple, this->NumberOfComponents, this->NoDataMagnitude);
  }

private:
  relevo::PointBlanking Blanking;
  int NumberOfComponents;
  double NoDataMagnitude;
};
}

namespace relevo
{
bool LICVectors::Read(vtkImageData* image, vtkDataArray* array, const LICPlane& plane,
  double noDataMagnitude, double threshold, std::string& error)
{
  const int numberOfComponents = array->GetNumberOfComponents();
  const SampleUnits units(image, plane, numberOfComponents);
  if (!units.IsValid())
  {
    error = "has a spacing that is zero or not finite";
    return false;
  }
  const Validity validity(image, numberOfComponents, noDataMagnitude);
  const vtkIdType numberOfSamples = plane.GetNumberOfSamples();
  std::vector<dvec2> vectors(numberOfSamples, dvec2(0.0));
  this->Mask.assign(numberOfSamples, 1);
  vtkSMPTools::For(0, numberOfSamples,
    [&](vtkIdType begin, vtkIdType end)
    {
      double tuple[3] = { 0.0, 0.0, 0.0 };
      for (vtkIdType i = begin; i < end; ++i)
      {
        array->GetTuple(i, tuple);
        const dvec2 projected = units.Project(tuple);
        const dvec2 vector = units.ToSamples(projected);
        if (validity.HasData(i, tuple) && IsFinite(vector))
        {
          vectors[i] = vector;
          this->Mask[i] = std::hypot(projected.x, projected.y) > threshold ? 0 : 1;
        }
      }
    });
  this->Longest = 0.0;
  for (const dvec2& vector : vectors)
  {
    this->Longest = std::max(this->Longest, std::hypot(vector.x, vector.y));
  }
  this->Pad(vectors, plane);
  return true;
}

void LICVectors::Pad(const std::vector<dvec2>& vectors, const LICPlane& plane)
{
  const double unit = this->Longest > 0.0 ? this->Longest : 1.0;
  this->Padded.resize((plane.Columns + vtkIdType(2)) * (plane.Rows + vtkIdType(2)));
  vec2* padded = this->Padded.data();
  for (int row = -1; row <= plane.Rows; ++row)
  {
    const dvec2* source = vectors.data() +
      static_cast<vtkIdType>(std::min(std::max(row, 0), plane.Rows - 1)) * plane.Columns;
    for (int column = -1; column <= plane.Columns; ++column)
    {
      *padded++ = vec2(source[std::min(std::max(column, 0), plane.Columns - 1)] / unit);
    }
  }
}
}
