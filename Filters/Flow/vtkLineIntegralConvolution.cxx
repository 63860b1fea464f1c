// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineIntegralConvolution.h"

#include "Arrays/ImageExtents.h"
#include "Checks/InputType.h"
#include "Checks/MemoryGuard.h"
#include "Checks/MisplacedArray.h"
#include "Compatibility/VTKCompatibility.h"
#include "Image/ChosenNoise.h"
#include "Image/ForwardedSettings.h"
#include "Image/LICPassSettings.h"
#include "Image/LICPasses.h"
#include "Image/LICPlane.h"
#include "Image/LICVectors.h"
#include "Image/NoiseTexels.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>

namespace
{
bool CanBeVectors(vtkDataArray* array, vtkIdType numberOfPoints)
{
  return array && (array->GetNumberOfComponents() == 2 || array->GetNumberOfComponents() == 3) &&
    array->GetNumberOfTuples() == numberOfPoints;
}

// Returns the first array that can be vectors, or null.
vtkDataArray* FindDefaultVectors(vtkImageData* image)
{
  vtkPointData* data = image->GetPointData();
  const vtkIdType numberOfPoints = image->GetNumberOfPoints();
  vtkDataArray* found = nullptr;
  for (int i = 0; i < data->GetNumberOfArrays() && !CanBeVectors(found, numberOfPoints); ++i)
  {
    found = data->GetArray(i);
  }
  return CanBeVectors(found, numberOfPoints) ? found : nullptr;
}

// Repeats a tile over all samples of a plane.
std::vector<float> Tile(const relevo::NoiseTexels& tile, const relevo::LICPlane& plane)
{
  std::vector<float> tiled(plane.GetNumberOfSamples());
  float* value = tiled.data();
  for (int row = 0; row < plane.Rows; ++row)
  {
    const int columns = tile.Plane.Columns;
    const float* source =
      tile.Values.data() + static_cast<vtkIdType>(row % tile.Plane.Rows) * columns;
    for (int column = 0; column < plane.Columns; ++column)
    {
      *value++ = source[column % columns];
    }
  }
  return tiled;
}
}

vtkStandardNewMacro(vtkLineIntegralConvolution);

vtkLineIntegralConvolution::vtkLineIntegralConvolution()
  : LICSettings(vtkSmartPointer<vtkLICSettings>::New())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
}

vtkLineIntegralConvolution::~vtkLineIntegralConvolution() = default;

void vtkLineIntegralConvolution::SetNoiseData(vtkImageData* noise)
{
  this->SetInputData(1, noise);
}

int vtkLineIntegralConvolution::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1);
  return 1;
}

int vtkLineIntegralConvolution::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputVector->GetInformationObject(0), VTK_FLOAT, 1);
  return 1;
}

int vtkLineIntegralConvolution::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    relevo::RequestWholeExtent(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

vtkDataArray* vtkLineIntegralConvolution::FindVectors(
  vtkInformationVector** inputVector, std::string& error)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  int association = points;
  vtkDataArray* found = this->GetInputArrayToProcess(0, inputVector, association);
  if (!wanted->Has(vtkDataObject::FIELD_NAME()))
  {
    found = CanBeVectors(found, input->GetNumberOfPoints()) ? found : FindDefaultVectors(input);
    error = found ? "" : "has no point array of 2 or 3 components";
    return found;
  }
  std::ostringstream text;
  text << "has no point array \"" << wanted->Get(vtkDataObject::FIELD_NAME()) << "\"";
  if (!found || association != points)
  {
    const std::string misplaced =
      relevo::DescribeMisplacedArray(input, wanted->Get(vtkDataObject::FIELD_NAME()), points);
    error = misplaced.empty() ? text.str() : "has " + misplaced;
    return nullptr;
  }
  if (!CanBeVectors(found, input->GetNumberOfPoints()))
  {
    text << " with 2 or 3 components for each of " << input->GetNumberOfPoints()
         << " points; the array has " << found->GetNumberOfTuples() << " tuples of "
         << found->GetNumberOfComponents();
    error = text.str();
    return nullptr;
  }
  return found;
}

bool vtkLineIntegralConvolution::MakeNoise(vtkInformationVector* noiseVector,
  const relevo::LICPlane& plane, std::vector<float>& noise, float& mean, std::string& error)
{
  vtkImageData* image = vtkImageData::GetData(noiseVector);
  relevo::NoiseTexels read;
  if (image && !read.Read(image, error))
  {
    error = "The noise " + error + ".";
    return false;
  }
  relevo::ChosenNoise chosen;
  if (!image && !chosen.Update(this->LICSettings))
  {
    error = chosen.GetError();
    return false;
  }
  const relevo::NoiseTexels& tile = image ? read : chosen.GetTexels();
  noise = Tile(tile, plane);
  mean = tile.GetMean();
  return true;
}

int vtkLineIntegralConvolution::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!relevo::CheckInputTypes(this, inputVector))
  {
    return 0;
  }
  int result = 0;
  if (!relevo::FitsMemory([&] { result = this->Convolve(inputVector, input, output); }))
  {
    output->Initialize();
    vtkErrorMacro("Not enough memory for " << input->GetNumberOfPoints() << " points.");
  }
  return result;
}

int vtkLineIntegralConvolution::Convolve(
  vtkInformationVector** inputVector, vtkImageData* input, vtkImageData* output)
{
  std::string error = relevo::FindContrastError(this->LICSettings);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  relevo::LICPlane plane;
  vtkDataArray* array = nullptr;
  relevo::LICVectors vectors;
  if (!plane.Find(input, error) || !(array = this->FindVectors(inputVector, error)) ||
    !vectors.Read(input, array, plane, this->LICSettings->GetNoDataMagnitude(),
      this->LICSettings->GetMaskThreshold(), error))
  {
    vtkErrorMacro("The input " << error << ".");
    return 0;
  }
  std::vector<float> image;
  float mean;
  if (!this->MakeNoise(inputVector[1], plane, image, mean, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  const relevo::LICPassSettings settings =
    relevo::MakeLICPassSettings(this->LICSettings, vectors.GetLongest(), mean);
  relevo::LICPasses passes(plane, vectors, settings);
  const auto watch = [this](double share)
  {
    this->UpdateProgress(share);
    return !relevo::IsAborted(this);
  };
  if (!passes.Run(image, watch))
  {
    return 1;
  }

  vtkNew<vtkFloatArray> lic;
  lic->SetName("LIC");
  lic->SetNumberOfTuples(plane.GetNumberOfSamples());
  std::copy(image.begin(), image.end(), lic->GetPointer(0));
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("LICMask");
  mask->SetNumberOfTuples(plane.GetNumberOfSamples());
  std::copy(vectors.GetMask().begin(), vectors.GetMask().end(), mask->GetPointer(0));
  output->CopyStructure(input);
  output->GetPointData()->SetScalars(lic);
  output->GetPointData()->AddArray(mask);
  return 1;
}

//------------------------------------------------------------------------------
// Settings

relevoLICSettingsMacro(vtkLineIntegralConvolution);

vtkMTimeType vtkLineIntegralConvolution::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->LICSettings->GetMTime());
}

relevoForwardMacro(vtkLineIntegralConvolution, NumberOfSteps, int);
relevoForwardMacro(vtkLineIntegralConvolution, StepSize, double);
relevoForwardMacro(vtkLineIntegralConvolution, NormalizeVectors, bool);
relevoForwardMacro(vtkLineIntegralConvolution, EnhancedLIC, bool);
relevoForwardMacro(vtkLineIntegralConvolution, LowLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkLineIntegralConvolution, HighLICContrastEnhancementFactor, double);
relevoForwardMacro(vtkLineIntegralConvolution, AntiAlias, int);
relevoForwardMacro(vtkLineIntegralConvolution, MaskThreshold, double);
relevoForwardMacro(vtkLineIntegralConvolution, NoDataMagnitude, double);
relevoForwardMacro(vtkLineIntegralConvolution, OrientedLIC, bool);
relevoForwardMacro(vtkLineIntegralConvolution, Phase, double);
relevoForwardGreyContrastMacro(vtkLineIntegralConvolution);

void vtkLineIntegralConvolution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LICSettings:\n";
  this->LICSettings->PrintSelf(os, indent.GetNextIndent());
}
