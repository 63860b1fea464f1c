// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/ImageGradients.h"

#include "Mathematics/RefinementMathematics.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
class GradientSampler
{
public:
  GradientSampler(vtkImageData* image, vtkDataArray* scalars)
    : Scalars(scalars)
  {
    image->GetExtent(this->Extent);
    image->GetSpacing(this->Spacing);
    image->GetDimensions(this->Dimensions);
  }

  // The gradient along the axes of the image, for indices as real numbers.
  dvec3 Find(const double index[3]) const
  {
    // Of the three coordinates, two are integers.
    int axis = 0;
    double largest = -1.0;
    int low[3];
    for (int c = 0; c < 3; ++c)
    {
      low[c] = this->Clamp(static_cast<int>(std::lround(index[c])), c);
      const double rest = std::abs(index[c] - std::round(index[c]));
      axis = rest > largest ? c : axis;
      largest = std::max(largest, rest);
    }
    low[axis] = this->Clamp(static_cast<int>(std::floor(index[axis])), axis);
    int high[3] = { low[0], low[1], low[2] };
    high[axis] = this->Clamp(low[axis] + 1, axis);
    const double share = std::max(0.0, std::min(1.0, index[axis] - low[axis]));
    return (1.0 - share) * this->GetDifferences(low) + share * this->GetDifferences(high);
  }

private:
  int Clamp(int index, int axis) const
  {
    return std::max(this->Extent[2 * axis], std::min(this->Extent[2 * axis + 1], index));
  }

  double GetScalar(const int ijk[3]) const
  {
    vtkIdType id = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      id = id * this->Dimensions[axis] + (ijk[axis] - this->Extent[2 * axis]);
    }
    return this->Scalars->GetComponent(id, 0);
  }

  dvec3 GetDifferences(const int ijk[3]) const
  {
    dvec3 gradient(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      int before[3] = { ijk[0], ijk[1], ijk[2] };
      int after[3] = { ijk[0], ijk[1], ijk[2] };
      before[axis] = this->Clamp(ijk[axis] - 1, axis);
      after[axis] = this->Clamp(ijk[axis] + 1, axis);
      const double length = (after[axis] - before[axis]) * this->Spacing[axis];
      gradient[axis] =
        length != 0.0 ? (this->GetScalar(after) - this->GetScalar(before)) / length : 0.0;
    }
    return gradient;
  }

  vtkDataArray* Scalars;
  int Extent[6];
  double Spacing[3];
  int Dimensions[3];
};
}

void AddGradients(vtkImageData* image, vtkDataArray* scalars, vtkPolyData* surface)
{
  vtkNew<vtkFloatArray> gradients;
  gradients->SetName("Gradients");
  gradients->SetNumberOfComponents(3);
  gradients->SetNumberOfTuples(surface->GetNumberOfPoints());
  const GradientSampler sampler(image, scalars);
  const double* directions = image->GetDirectionMatrix()->GetData();
  vtkSMPTools::For(0, surface->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double x[3];
        double index[3];
        surface->GetPoints()->GetPoint(i, x);
        image->TransformPhysicalPointToContinuousIndex(x, index);
        const bool isFinite =
          std::isfinite(index[0]) && std::isfinite(index[1]) && std::isfinite(index[2]);
        const dvec3 along = isFinite ? sampler.Find(index) : dvec3(0.0);
        for (int c = 0; c < 3; ++c)
        {
          const double value = directions[3 * c] * along[0] + directions[3 * c + 1] * along[1] +
            directions[3 * c + 2] * along[2];
          gradients->SetTypedComponent(i, c, static_cast<float>(value));
        }
      }
    });
  surface->GetPointData()->AddArray(gradients);
}
}
