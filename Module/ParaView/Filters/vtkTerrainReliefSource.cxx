// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainReliefSource.h"

#include "Arrays/ImageExtents.h"
#include "Changes/LatestTime.h"
#include "Checks/ErrorCollector.h"
#include "Checks/ShouldReport.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkHeightMap.h"
#include "vtkHeightMapToRelief.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTerrainSource.h"

#include <string>

namespace
{
constexpr int LargestDimension = 2048;

// Return the first message, without the file, class and address with which it begins.
std::string ReadFirstMessage(std::string text)
{
  const std::size_t begin = text.find("): ");
  text = begin == std::string::npos ? text : text.substr(begin + 3);
  return text.substr(0, text.find('\n'));
}
}

vtkStandardNewMacro(vtkTerrainReliefSource);

vtkTerrainReliefSource::vtkTerrainReliefSource()
{
  this->SetNumberOfInputPorts(0);
  this->Terrain->SetResolution(1); // its mesh is not used
  this->Terrain->SetMaximumDimension(LargestDimension);
  this->Terrain->AddObserver(
    vtkCommand::WarningEvent, this, &vtkTerrainReliefSource::ForwardWarning);
}

vtkTerrainReliefSource::~vtkTerrainReliefSource() = default;

void vtkTerrainReliefSource::SetFileName(const char* name)
{
  this->Terrain->SetFileName(name);
}

const char* vtkTerrainReliefSource::GetFileName()
{
  return this->Terrain->GetFileName();
}

void vtkTerrainReliefSource::SetImageryFileName(const char* name)
{
  this->Terrain->SetImageryFileName(name);
}

const char* vtkTerrainReliefSource::GetImageryFileName()
{
  return this->Terrain->GetImageryFileName();
}

void vtkTerrainReliefSource::SetImageryBands(int red, int green, int blue)
{
  this->Terrain->SetImageryBands(red, green, blue);
}

int* vtkTerrainReliefSource::GetImageryBands()
{
  return this->Terrain->GetImageryBands();
}

void vtkTerrainReliefSource::SetExaggeration(double exaggeration)
{
  this->Converter->SetExaggeration(exaggeration);
}

double vtkTerrainReliefSource::GetExaggeration()
{
  return this->Converter->GetExaggeration();
}

void vtkTerrainReliefSource::SetTexelsPerSample(int texels)
{
  this->Converter->SetTexelsPerSample(texels);
}

int vtkTerrainReliefSource::GetTexelsPerSample()
{
  return this->Converter->GetTexelsPerSample();
}

void vtkTerrainReliefSource::SetMaximumDimension(int dimension)
{
  this->Terrain->SetMaximumDimension(dimension);
}

int vtkTerrainReliefSource::GetMaximumDimension()
{
  return this->Terrain->GetMaximumDimension();
}

vtkMTimeType vtkTerrainReliefSource::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(), { this->Terrain, this->Converter });
}

void vtkTerrainReliefSource::ForwardWarning(vtkObject*, unsigned long, void* text)
{
  vtkWarningMacro(<< ReadFirstMessage(text ? static_cast<const char*>(text) : ""));
}

bool vtkTerrainReliefSource::Convert()
{
  std::string errors;
  std::string ignored; // the executives repeat errors of the algorithms
  const auto collector = relevo::NewErrorCollector(errors);
  const auto listener = relevo::NewErrorCollector(ignored);
  vtkObject* const reporters[] = { this->Terrain, this->Converter };
  vtkObject* const repeaters[] = { this->Terrain->GetExecutive(), this->Converter->GetExecutive() };
  unsigned long tags[4];
  for (int i = 0; i < 2; ++i)
  {
    tags[i] = reporters[i]->AddObserver(vtkCommand::ErrorEvent, collector);
    tags[2 + i] = repeaters[i]->AddObserver(vtkCommand::ErrorEvent, listener);
  }
  this->Terrain->Update();
  this->Converter->SetHeightMap(this->Terrain->GetHeightMap());
  this->Converter->SetInputDataObject(this->Terrain->GetImagery());
  this->Converter->Update();
  for (int i = 0; i < 2; ++i)
  {
    reporters[i]->RemoveObserver(tags[i]);
    repeaters[i]->RemoveObserver(tags[2 + i]);
  }
  if (relevo::ShouldReport(this->Error, ReadFirstMessage(errors)))
  {
    vtkErrorMacro(<< this->Error);
  }
  return errors.empty();
}

// The size depends on the heights, so they are read here.
int vtkTerrainReliefSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->Convert())
  {
    vtkImageData::GetData(outputVector)->Initialize();
    return 0;
  }
  const int* size = this->Converter->GetOutput()->GetDimensions();
  relevo::SetImageSize(outputVector->GetInformationObject(0), size[0], size[1]);
  return 1;
}

int vtkTerrainReliefSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!this->Convert()) // a file may have changed since RequestInformation()
  {
    return 0;
  }
  output->ShallowCopy(this->Converter->GetOutput());
  return 1;
}

void vtkTerrainReliefSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Terrain:\n";
  this->Terrain->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Converter:\n";
  this->Converter->PrintSelf(os, indent.GetNextIndent());
}
