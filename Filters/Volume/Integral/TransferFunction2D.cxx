// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/TransferFunction2D.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
namespace
{
std::vector<double> MakeAxis(vtkImageData* image, int axis)
{
  std::vector<double> values;
  for (int i = 0; i < image->GetDimensions()[axis]; ++i)
  {
    values.push_back(
      image->GetOrigin()[axis] + (image->GetExtent()[2 * axis] + i) * image->GetSpacing()[axis]);
  }
  return values;
}

// The two neighbours of x on an axis, and the fraction between them.
struct AxisPosition
{
  size_t First;
  size_t Last;
  double Share;

  AxisPosition(const std::vector<double>& axis, double x)
  {
    this->Last = std::lower_bound(axis.begin(), axis.end(), x) - axis.begin();
    this->Last = std::min(this->Last, axis.size() - 1);
    this->First = this->Last > 0 ? this->Last - 1 : 0;
    const double size = axis[this->Last] - axis[this->First];
    this->Share = size > 0.0 ? std::clamp((x - axis[this->First]) / size, 0.0, 1.0) : 0.0;
  }
};

std::string FindError(vtkImageData* image)
{
  vtkDataArray* colors = image->GetPointData()->GetScalars();
  if (!colors || colors->GetNumberOfComponents() != 4)
  {
    return "without scalars of 4 components";
  }
  if (image->GetDimensions()[2] != 1 || colors->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    colors->GetNumberOfTuples() == 0)
  {
    return "that is not an image of one slice";
  }
  if (!(image->GetSpacing()[0] > 0.0) || !(image->GetSpacing()[1] > 0.0))
  {
    return "whose spacing is not positive";
  }
  for (vtkIdType i = 0; i < 4 * colors->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(colors->GetComponent(i / 4, static_cast<int>(i % 4))))
    {
      return "with values that are not finite";
    }
  }
  return "";
}
}

bool TransferFunction2D::Read(vtkImageData* image, std::string& error)
{
  const std::string reason = FindError(image);
  if (!reason.empty())
  {
    error = reason;
    return false;
  }
  this->Columns = MakeAxis(image, 0);
  this->Rows = MakeAxis(image, 1);
  vtkDataArray* colors = image->GetPointData()->GetScalars();
  this->Texels.clear();
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    dvec4 texel;
    colors->GetTuple(i, &texel.x);
    this->Texels.push_back(max(texel, dvec4(0.0)));
  }
  return true;
}

dvec4 TransferFunction2D::Evaluate(double scalar, double steepness) const
{
  const AxisPosition column(this->Columns, scalar);
  const AxisPosition row(this->Rows, steepness);
  const auto get = [&](size_t y)
  {
    const dvec4* texels = &this->Texels[y * this->Columns.size()];
    return mix(texels[column.First], texels[column.Last], column.Share);
  };
  return mix(get(row.First), get(row.Last), row.Share);
}
}
