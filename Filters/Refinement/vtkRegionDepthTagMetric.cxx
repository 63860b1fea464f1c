// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRegionDepthTagMetric.h"

#include "vtkFloatArray.h"
#include "vtkImplicitFunction.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementMathematics.h"
#include "vtkRefinementView.h"
#include "vtkSMPTools.h"
#include "vtkWorldView.h"

#include <algorithm>
#include <cmath>

namespace relevo
{
#include "glsl/relevoMetrics.glsl"
}

namespace
{
using glm::dvec3;

constexpr double AutomaticFallOff = 0.1; // of the bounding box's diagonal

// NaN where nothing is known.
double GetDistance(vtkImplicitFunction* function, dvec3 x)
{
  const double value = function->FunctionValue(&x[0]);
  if (value <= 0.0)
  {
    return 0.0;
  }
  dvec3 gradient(0.0);
  function->FunctionGradient(&x[0], &gradient[0]);
  return value / glm::length(gradient);
}
}

vtkStandardNewMacro(vtkRegionDepthTagMetric);

vtkRegionDepthTagMetric::vtkRegionDepthTagMetric() = default;
vtkRegionDepthTagMetric::~vtkRegionDepthTagMetric() = default;

void vtkRegionDepthTagMetric::SetImplicitFunction(vtkImplicitFunction* function)
{
  if (this->ImplicitFunction != function)
  {
    this->ImplicitFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkRegionDepthTagMetric::GetImplicitFunction()
{
  return this->ImplicitFunction;
}

void vtkRegionDepthTagMetric::SetCenter(double x, double y, double z)
{
  const double center[3] = { x, y, z };
  if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z)))
  {
    vtkErrorMacro("Center (" << x << ", " << y << ", " << z << ") is not finite.");
    return;
  }
  if (!std::equal(center, center + 3, this->Center))
  {
    std::copy_n(center, 3, this->Center);
    this->Modified();
  }
}

void vtkRegionDepthTagMetric::SetLength(const char* name, double& length, double value)
{
  if (!(value >= 0.0 && value <= VTK_FLOAT_MAX))
  {
    vtkErrorMacro(<< name << " " << value
                  << " is not a length: give a finite number of world units, 0 or more.");
    return;
  }
  if (length != value)
  {
    length = value;
    this->Modified();
  }
}

void vtkRegionDepthTagMetric::SetRadius(double radius)
{
  this->SetLength("Radius", this->Radius, radius);
}

void vtkRegionDepthTagMetric::SetFallOff(double distance)
{
  this->SetLength("FallOff", this->FallOff, distance);
}

vtkMTimeType vtkRegionDepthTagMetric::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

bool vtkRegionDepthTagMetric::ComputeTags(
  vtkPolyData* mesh, const vtkRefinementView& view, int maximumLevel, vtkFloatArray* tags)
{
  if (!this->ImplicitFunction && this->Radius == 0.0)
  {
    vtkErrorMacro("There is no region: call SetImplicitFunction, or SetCenter and SetRadius.");
    return false;
  }
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  tags->SetNumberOfComponents(1);
  tags->SetNumberOfTuples(numberOfPoints);
  if (numberOfPoints == 0)
  {
    return true;
  }

  const relevo::Placement placement(view);
  const dvec3 center(this->Center[0], this->Center[1], this->Center[2]);
  const double fallOff =
    this->FallOff > 0.0 ? this->FallOff : AutomaticFallOff * placement.GetDiagonal(mesh);
  vtkPoints* points = mesh->GetPoints();
  const auto tag = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType point = begin; point < end; ++point)
    {
      dvec3 x;
      points->GetPoint(point, &x[0]);
      x = placement.GetPoint(x);
      double distance = vtkMath::Nan();
      if (std::isfinite(glm::dot(x, dvec3(1.0))))
      {
        distance = this->ImplicitFunction ? GetDistance(this->ImplicitFunction, x)
                                          : std::max(glm::distance(x, center) - this->Radius, 0.0);
      }
      // In fall-offs: neither leaves the range of floats.
      tags->SetValue(point,
        relevo::regionLevel(
          static_cast<float>(distance > 0.0 ? std::min(distance / fallOff, 2.0) : distance), 1.0f,
          maximumLevel));
    }
  };
  if (this->ImplicitFunction)
  {
    tag(0, numberOfPoints); // VTK's functions do not promise to be safe in threads
  }
  else
  {
    vtkSMPTools::For(0, numberOfPoints, tag);
  }
  tags->Modified();
  return true;
}

void vtkRegionDepthTagMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImplicitFunction: " << this->ImplicitFunction.Get() << "\n";
  os << indent << "Center: (" << this->Center[0] << ", " << this->Center[1] << ", "
     << this->Center[2] << ")\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "FallOff: " << this->FallOff << "\n";
}
