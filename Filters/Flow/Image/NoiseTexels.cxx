// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Image/NoiseTexels.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <numeric>
#include <sstream>

namespace relevo
{
namespace
{
// Returns the factor that maps the values of the array to [0, 1].
double GetScale(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      return 1.0 / VTK_UNSIGNED_CHAR_MAX;
    case VTK_UNSIGNED_SHORT:
      return 1.0 / VTK_UNSIGNED_SHORT_MAX;
    default:
      return 1.0;
  }
}
}

bool NoiseTexels::Read(vtkImageData* image, std::string& error)
{
  if (!this->Plane.Find(image, error))
  {
    return false;
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != this->Plane.GetNumberOfSamples())
  {
    error = "has no point scalars";
    return false;
  }
  const double scale = GetScale(scalars);
  this->Values.resize(this->Plane.GetNumberOfSamples());
  for (vtkIdType i = 0; i < this->Plane.GetNumberOfSamples(); ++i)
  {
    const double value = scale * scalars->GetComponent(i, 0);
    if (!(value >= 0.0 && value <= 1.0))
    {
      std::ostringstream text;
      text << "has the value " << value << " outside [0, 1] at point " << i;
      error = text.str();
      return false;
    }
    this->Values[i] = static_cast<float>(value);
  }
  return true;
}

float NoiseTexels::GetMean() const
{
  const double sum = std::accumulate(this->Values.begin(), this->Values.end(), 0.0);
  return this->Values.empty() ? 0.0f : static_cast<float>(sum / this->Values.size());
}
}
