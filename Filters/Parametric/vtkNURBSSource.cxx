// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNURBSSource.h"

#include "Cells/BezierCells.h"
#include "Changes/LatestTime.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Splines/BSpline.h"
#include "Splines/KnotVector.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkNURBSSource);

namespace
{
// A net of homogeneous points, stored in rows.
struct Net
{
  std::size_t Width;
  std::vector<relevo::dvec4> Points;
};

Net GetNet(vtkPoints* points, vtkDoubleArray* weights, int width)
{
  Net net{ static_cast<std::size_t>(width), {} };
  net.Points.reserve(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    relevo::dvec3 x;
    points->GetPoint(i, &x.x);
    const double weight = weights ? weights->GetValue(i) : 1.0;
    net.Points.emplace_back(weight * x, weight);
  }
  return net;
}

// Converts rows to Bézier curves and transposes the net.
Net DecomposeRows(const Net& net, int degree, const std::vector<double>& knots)
{
  const std::size_t height = net.Points.size() / net.Width;
  const std::size_t width = relevo::FindSpans(knots, degree).size() * (degree + 1);
  Net result{ height, std::vector<relevo::dvec4>(height * width) };
  vtkSMPTools::For(0, static_cast<vtkIdType>(height),
    [&](vtkIdType first, vtkIdType end)
    {
      for (vtkIdType row = first; row < end; ++row)
      {
        const auto begin = net.Points.begin() + row * net.Width;
        const std::vector<relevo::dvec4> curve =
          relevo::DecomposeIntoBezier(degree, knots, { begin, begin + net.Width });
        for (std::size_t i = 0; i < width; ++i)
        {
          result.Points[i * height + row] = curve[i];
        }
      }
    });
  return result;
}

// Fails if weights are too large or too small for the computations.
bool IsFinite(const Net& net)
{
  return std::all_of(net.Points.begin(), net.Points.end(),
    [](const relevo::dvec4& point)
    {
      const relevo::dvec4 place = point / point.w;
      return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z) &&
        std::isfinite(place.w);
    });
}

// Resets weights that must be 1 but have rounding errors.
relevo::dvec4 Project(const relevo::dvec4& point, bool isRational)
{
  return isRational ? relevo::dvec4(relevo::dvec3(point) / point.w, point.w)
                    : relevo::dvec4(relevo::dvec3(point), 1.0);
}

// Returns the control points of a cell.
std::vector<relevo::dvec4> CopyPiece(
  const Net& net, std::size_t first, const relevo::ivec2& size, bool isRational)
{
  std::vector<relevo::dvec4> points;
  for (int j = 0; j < size.y; ++j)
  {
    for (int i = 0; i < size.x; ++i)
    {
      points.push_back(Project(net.Points[first + j * net.Width + i], isRational));
    }
  }
  return points;
}
}

vtkNURBSSource::vtkNURBSSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkNURBSSource::~vtkNURBSSource() = default;

bool vtkNURBSSource::IsDirection(int direction)
{
  return relevo::CheckRange(this, "Direction", direction, 0, 1);
}

void vtkNURBSSource::SetDegree(int direction, int degree)
{
  if (this->IsDirection(direction))
  {
    relevo::SetInRange(this, "Degree", this->Degrees[direction], degree, 1, relevo::LargestDegree);
  }
}

int vtkNURBSSource::GetDegree(int direction)
{
  return this->IsDirection(direction) ? this->Degrees[direction] : 0;
}

void vtkNURBSSource::SetKnots(int direction, vtkDoubleArray* knots)
{
  if (this->IsDirection(direction) && this->Knots[direction] != knots)
  {
    this->Knots[direction] = knots;
    this->Modified();
  }
}

vtkDoubleArray* vtkNURBSSource::GetKnots(int direction)
{
  return this->IsDirection(direction) ? this->Knots[direction].Get() : nullptr;
}

void vtkNURBSSource::SetDimensions(int first, int second)
{
  const bool isChange = first != this->Dimensions[0] || second != this->Dimensions[1];
  if (isChange && relevo::CheckRange(this, "Dimensions", std::min(first, second), 1, VTK_INT_MAX))
  {
    this->Dimensions[0] = first;
    this->Dimensions[1] = second;
    this->Modified();
  }
}

void vtkNURBSSource::SetControlPoints(vtkPoints* points)
{
  if (this->ControlPoints != points)
  {
    this->ControlPoints = points;
    this->Modified();
  }
}

vtkPoints* vtkNURBSSource::GetControlPoints()
{
  return this->ControlPoints;
}

void vtkNURBSSource::SetWeights(vtkDoubleArray* weights)
{
  if (this->Weights != weights)
  {
    this->Weights = weights;
    this->Modified();
  }
}

vtkDoubleArray* vtkNURBSSource::GetWeights()
{
  return this->Weights;
}

vtkMTimeType vtkNURBSSource::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(),
    { this->Knots[0], this->Knots[1], this->ControlPoints, this->Weights });
}

bool vtkNURBSSource::CheckPoints()
{
  if (!this->ControlPoints)
  {
    vtkErrorMacro("There are no control points: call SetControlPoints().");
    return false;
  }
  const vtkIdType number = this->ControlPoints->GetNumberOfPoints();
  if (number != static_cast<vtkIdType>(this->Dimensions[0]) * this->Dimensions[1])
  {
    vtkErrorMacro("There are " << number << " control points, but the dimensions are "
                               << this->Dimensions[0] << " x " << this->Dimensions[1] << ".");
    return false;
  }
  for (vtkIdType i = 0; i < number; ++i)
  {
    double x[3];
    this->ControlPoints->GetPoint(i, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      vtkErrorMacro("Control point " << i << " is not finite.");
      return false;
    }
  }
  return true;
}

bool vtkNURBSSource::CheckWeights()
{
  const vtkIdType number = this->ControlPoints->GetNumberOfPoints();
  if (this->Weights && this->Weights->GetNumberOfValues() != number)
  {
    vtkErrorMacro("There are " << this->Weights->GetNumberOfValues() << " weights, but " << number
                               << " control points.");
    return false;
  }
  for (vtkIdType i = 0; this->Weights && i < number; ++i)
  {
    const double weight = this->Weights->GetValue(i);
    if (!(weight > 0.0) || !std::isfinite(weight))
    {
      vtkErrorMacro("Weight " << i << " is " << weight << "; weights must be positive and finite.");
      return false;
    }
  }
  return true;
}

bool vtkNURBSSource::CheckDirection(int direction)
{
  const int degree = this->Degrees[direction];
  const int number = this->Dimensions[direction];
  if (number <= degree)
  {
    vtkErrorMacro("Direction " << direction << " has " << number << " control points, but degree "
                               << degree << " needs at least " << degree + 1 << ".");
    return false;
  }
  if (!this->Knots[direction])
  {
    vtkErrorMacro("There are no knots of direction " << direction << ": call SetKnots().");
    return false;
  }
  const std::string error =
    relevo::FindKnotError(this->CopyKnots(direction), degree, static_cast<std::size_t>(number));
  if (!error.empty())
  {
    vtkErrorMacro("Knots of direction " << direction << ": " << error);
  }
  return error.empty();
}

bool vtkNURBSSource::IsRational()
{
  bool isRational = false;
  for (vtkIdType i = 0; this->Weights && i < this->Weights->GetNumberOfValues(); ++i)
  {
    isRational = isRational || this->Weights->GetValue(i) != 1.0;
  }
  return isRational;
}

std::vector<double> vtkNURBSSource::CopyKnots(int direction)
{
  vtkDoubleArray* knots = this->Knots[direction];
  return { knots->GetPointer(0), knots->GetPointer(0) + knots->GetNumberOfValues() };
}

int vtkNURBSSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return relevo::RequestWithinMemory(this, outputVector, "the control points",
    [&] { return this->Decompose(vtkUnstructuredGrid::GetData(outputVector)); });
}

int vtkNURBSSource::Decompose(vtkUnstructuredGrid* output)
{
  output->Initialize();
  if (!this->CheckPoints() || !this->CheckWeights() || !this->CheckDirection(0) ||
    (!this->IsCurve() && !this->CheckDirection(1)))
  {
    return 0;
  }
  const bool isRational = this->IsRational();
  Net net = GetNet(this->ControlPoints, this->Weights, this->Dimensions[0]);
  net = DecomposeRows(net, this->Degrees[0], this->CopyKnots(0));
  if (!this->IsCurve())
  {
    net = DecomposeRows(net, this->Degrees[1], this->CopyKnots(1));
  }
  if (!IsFinite(net))
  {
    vtkErrorMacro("The weights are too large or too small: their products with the control points "
                  "are not finite numbers, or 0.");
    return 0;
  }
  relevo::BezierCells cells(output, isRational);
  if (this->IsCurve())
  {
    const relevo::ivec2 size(this->Degrees[0] + 1, 1);
    for (std::size_t i = 0; i < net.Points.size(); i += size.x)
    {
      cells.AddCurve(this->Degrees[0], CopyPiece(net, i, size, isRational));
    }
    return 1;
  }
  const relevo::ivec2 degrees(this->Degrees[0], this->Degrees[1]);
  const relevo::ivec2 size = degrees + 1;
  for (std::size_t row = 0; row < net.Points.size(); row += size.y * net.Width)
  {
    for (std::size_t i = 0; i < net.Width; i += size.x)
    {
      cells.AddQuadrilateral(degrees, CopyPiece(net, row + i, size, isRational));
    }
  }
  return 1;
}

void vtkNURBSSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Degrees: " << this->Degrees[0] << " " << this->Degrees[1] << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << "\n";
  os << indent << "Knots: " << this->Knots[0] << " " << this->Knots[1] << "\n";
  os << indent << "ControlPoints: " << this->ControlPoints << "\n";
  os << indent << "Weights: " << this->Weights << "\n";
}
