// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthImageToRelief.h"

#include "Arrays/ImageExtents.h"
#include "Changes/LatestTime.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/MisplacedArray.h"
#include "Checks/SettingChecks.h"
#include "Data/Relief.h"
#include "Data/ReliefColors.h"
#include "Data/ReliefNormals.h"
#include "Data/ZBufferSpace.h"
#include "View/WorldView.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkDepthImageToRelief);

namespace
{
constexpr float NoDepth = std::numeric_limits<float>::quiet_NaN();

std::string DescribeSize(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]);
}

// Computes a depth for each texel from column, row and sample.
template <class ToDepth>
vtkSmartPointer<vtkFloatArray> MakeDepths(vtkDataArray* samples, int width, const ToDepth& toDepth)
{
  auto depths = vtkSmartPointer<vtkFloatArray>::New();
  depths->SetName(relevo::Relief::GetDepthName());
  depths->SetNumberOfTuples(samples->GetNumberOfTuples());
  float* all = depths->GetPointer(0);
  vtkSMPTools::For(0, samples->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        all[i] = toDepth(
          static_cast<int>(i % width), static_cast<int>(i / width), samples->GetComponent(i, 0));
      }
    });
  return depths;
}

// Returns a depth in the range of float, or no depth.
float ToValidDepth(double depth)
{
  using Limits = std::numeric_limits<float>;
  return depth >= Limits::min() && depth <= Limits::max() ? static_cast<float>(depth) : NoDepth;
}
}

vtkDepthImageToRelief::vtkDepthImageToRelief()
{
  this->SetNumberOfInputPorts(2);
}

vtkDepthImageToRelief::~vtkDepthImageToRelief() = default;

void vtkDepthImageToRelief::SetDepthScale(double scale)
{
  if (!(scale > 0.0 && std::isfinite(scale)))
  {
    vtkErrorMacro("DepthScale must be more than 0 and finite, got " << scale << ".");
  }
  else if (this->DepthScale != scale)
  {
    this->DepthScale = scale;
    this->Modified();
  }
}

void vtkDepthImageToRelief::SetIntrinsics(double fx, double fy, double cx, double cy)
{
  const double values[4] = { fx, fy, cx, cy };
  const bool areFinite =
    std::all_of(values, values + 4, [](double value) { return std::isfinite(value); });
  const bool areUnset = std::count(values, values + 4, 0.0) == 4;
  if (!areUnset && !(areFinite && fx > 0.0 && fy > 0.0))
  {
    vtkErrorMacro("Intrinsics must be finite, with fx and fy of more than 0, got ("
      << fx << ", " << fy << ", " << cx << ", " << cy << ").");
  }
  else if (!std::equal(values, values + 4, this->Intrinsics))
  {
    std::copy_n(values, 4, this->Intrinsics);
    this->Modified();
  }
}

vtkCxxSetSmartPointerMacro(vtkDepthImageToRelief, Pose, vtkMatrix4x4);

vtkMatrix4x4* vtkDepthImageToRelief::GetPose()
{
  return this->Pose;
}

vtkCxxSetSmartPointerMacro(vtkDepthImageToRelief, Camera, vtkCamera);

vtkCamera* vtkDepthImageToRelief::GetCamera()
{
  return this->Camera;
}

vtkMTimeType vtkDepthImageToRelief::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(), { this->Camera, this->Pose });
}

int vtkDepthImageToRelief::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
  {
    information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkDepthImageToRelief::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  inputVector[0]->GetInformationObject(0)->Get(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  relevo::SetImageSize(
    outputVector->GetInformationObject(0), extent[1] - extent[0] + 1, extent[3] - extent[2] + 1);
  return 1;
}

// Requests the whole of both images.
int vtkDepthImageToRelief::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    relevo::RequestWholeExtent(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

int vtkDepthImageToRelief::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  std::string error;
  const auto build = [&]
  {
    error = this->Build(
      vtkImageData::GetData(inputVector[0]), vtkImageData::GetData(inputVector[1]), output);
  };
  if (!relevo::FitsMemory(build))
  {
    error = "Not enough memory for the relief.";
  }
  if (!error.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< error);
    return 0;
  }
  return 1;
}

std::string vtkDepthImageToRelief::Build(
  vtkImageData* input, vtkImageData* colorInput, vtkImageData* output)
{
  const int* size = input->GetDimensions();
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    return "The depth image has " + DescribeSize(input) + " points, but n x m x 1 are needed.";
  }
  vtkDataArray* samples = this->FindDepths(input);
  if (!samples)
  {
    return this->DescribeMissingDepths(input);
  }
  if (samples->GetNumberOfComponents() != 1 ||
    samples->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    return "The depth image has " + std::to_string(samples->GetNumberOfTuples()) + " tuples of " +
      std::to_string(samples->GetNumberOfComponents()) +
      " components, but one number for each of " + std::to_string(input->GetNumberOfPoints()) +
      " points is needed.";
  }
  output->SetDimensions(size);
  std::string error = this->Camera ? this->AddZBufferDepths(samples, output)
                                   : this->AddPinholeDepths(samples, output);
  if (error.empty())
  {
    error = this->AddColors(input, colorInput, samples, output);
  }
  relevo::Relief relief;
  if (error.empty())
  {
    error = relief.Read(output);
  }
  if (error.empty() && this->ComputeNormals)
  {
    output->GetPointData()->SetNormals(relevo::ComputeReliefNormals(relief));
  }
  return error;
}

// Returns the name of the array that was chosen. An empty name chooses none.
std::string vtkDepthImageToRelief::GetChosenName()
{
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  const char* name =
    wanted->Has(vtkDataObject::FIELD_NAME()) ? wanted->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  return name ? name : "";
}

vtkDataArray* vtkDepthImageToRelief::FindDepths(vtkImageData* input)
{
  if (!this->GetChosenName().empty())
  {
    return this->GetInputArrayToProcess(0, input);
  }
  vtkDataArray* depths = this->Camera ? input->GetPointData()->GetArray("ZBuffer") : nullptr;
  return depths ? depths : input->GetPointData()->GetScalars();
}

std::string vtkDepthImageToRelief::DescribeMissingDepths(vtkImageData* input)
{
  const std::string name = this->GetChosenName();
  if (name.empty())
  {
    return "The depth image has no point scalars.";
  }
  const std::string misplaced =
    relevo::DescribeMisplacedArray(input, name.c_str(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
  return "The depth image has " +
    (misplaced.empty() ? "no point array \"" + name + "\"" : misplaced) + ".";
}

std::string vtkDepthImageToRelief::AddPinholeDepths(vtkDataArray* samples, vtkImageData* output)
{
  const double* f = this->Intrinsics;
  if (!(f[0] > 0.0))
  {
    return "There are neither intrinsics nor a camera: call SetIntrinsics() or SetCamera().";
  }
  const int* size = output->GetDimensions();
  output->GetPointData()->AddArray(MakeDepths(samples, size[0],
    [this](int, int, double sample) { return ToValidDepth(sample * this->DepthScale); }));

  // Converts rows of the image to rows from the top.
  const double step = this->BottomRowFirst ? -1.0 : 1.0;
  const double first = this->BottomRowFirst ? size[1] - 1.0 : 0.0;
  relevo::dmat4 toCamera(1.0);
  toCamera[0].x = 1.0 / f[0];
  toCamera[1].y = step / f[1];
  toCamera[2] = relevo::dvec4(-f[2] / f[0], (first - f[3]) / f[1], 1.0, 0.0);
  relevo::Relief::Describe(
    output, relevo::ReliefProjection::Perspective, relevo::MakeMatrix(this->Pose) * toCamera);
  return "";
}

std::string vtkDepthImageToRelief::AddZBufferDepths(vtkDataArray* samples, vtkImageData* output)
{
  const int* size = output->GetDimensions();
  const relevo::ZBufferSpace space(this->Camera, size[0], size[1]);
  if (!space.IsRegular())
  {
    return "The camera's matrices are singular: check its position, focal point and view up.";
  }
  const auto isSeen = [](double z) { return z >= 0.0 && z < 1.0; };
  const bool isParallel = space.GetProjection() == relevo::ReliefProjection::Parallel;
  double nearest = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; isParallel && i < samples->GetNumberOfTuples(); ++i)
  {
    const double z = samples->GetComponent(i, 0);
    const int column = static_cast<int>(i % size[0]);
    const int row = static_cast<int>(i / size[0]);
    nearest = isSeen(z) ? std::min(nearest, space.GetDepth(column, row, z)) : nearest;
  }
  const double offset = std::isfinite(nearest) ? nearest : 0.0;
  output->GetPointData()->AddArray(MakeDepths(samples, size[0],
    [&](int column, int row, double z)
    {
      const double depth = isSeen(z) ? space.GetDepth(column, row, z) : NoDepth;
      return isParallel ? static_cast<float>(depth - offset) : ToValidDepth(depth);
    }));
  relevo::Relief::Describe(output, space.GetProjection(), space.GetMatrix(offset));
  return "";
}

std::string vtkDepthImageToRelief::AddColors(
  vtkImageData* input, vtkImageData* colorInput, vtkDataArray* samples, vtkImageData* output)
{
  vtkPointData* data = output->GetPointData();
  vtkDataArray* colors = (colorInput ? colorInput : input)->GetPointData()->GetScalars();
  if (colorInput && !colors)
  {
    return "The colour image has no point scalars.";
  }
  if (colorInput &&
    (DescribeSize(colorInput) != DescribeSize(input) ||
      colors->GetNumberOfTuples() != samples->GetNumberOfTuples()))
  {
    return "The colour image has " + DescribeSize(colorInput) + " points and " +
      std::to_string(colors->GetNumberOfTuples()) + " colours, but the depth image has " +
      DescribeSize(input) + " points.";
  }
  // If depths are in a separate array, the scalars are the rendered colours.
  const bool isPicture = this->Camera && colors && colors != samples &&
    colors->GetNumberOfTuples() == samples->GetNumberOfTuples();
  if (!colorInput && !isPicture)
  {
    data->SetScalars(relevo::MakeDepthColors(
      vtkFloatArray::SafeDownCast(data->GetArray(relevo::Relief::GetDepthName()))));
    return "";
  }
  std::string error;
  if (const auto converted = relevo::ConvertColors(colors, error))
  {
    data->SetScalars(converted);
  }
  return error;
}

void vtkDepthImageToRelief::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DepthScale: " << this->DepthScale << "\n";
  os << indent << "Intrinsics: " << this->Intrinsics[0] << " " << this->Intrinsics[1] << " "
     << this->Intrinsics[2] << " " << this->Intrinsics[3] << "\n";
  os << indent << "Pose: " << this->Pose << "\n";
  os << indent << "BottomRowFirst: " << (this->BottomRowFirst ? "On" : "Off") << "\n";
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "ComputeNormals: " << (this->ComputeNormals ? "On" : "Off") << "\n";
}
