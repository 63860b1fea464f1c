// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Image/ChosenNoise.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkLICNoiseSource.h"
#include "vtkLICSettings.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <fstream>
#include <utility>

namespace relevo
{
namespace
{
// Keeps the first message, which is more specific than that of the executive.
void KeepMessage(vtkObject*, unsigned long, void* client, void* text)
{
  std::string& message = *static_cast<std::string*>(client);
  message = message.empty() ? static_cast<const char*>(text) : message;
}

// Runs an algorithm and returns its error, so that the object that uses the noise reports it.
std::string RunQuietly(vtkAlgorithm* algorithm)
{
  std::string message;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback(KeepMessage);
  listener->SetClientData(&message);
  for (vtkObject* object :
    { static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive()) })
  {
    object->AddObserver(vtkCommand::ErrorEvent, listener);
  }
  algorithm->Update();
  algorithm->RemoveObserver(listener);
  algorithm->GetExecutive()->RemoveObserver(listener);
  return message;
}

// The noise depends on the image, otherwise on the file, otherwise on the settings of the source.
Dependencies GetSources(vtkLICSettings* settings)
{
  vtkImageData* image = settings->GetNoiseDataSet();
  const char* fileName = settings->GetNoiseFileName();
  Dependencies sources;
  sources.AddObject(image);
  if (!image && fileName)
  {
    sources.Add(std::string(fileName));
  }
  else if (!image && settings->GetGenerateNoiseTexture())
  {
    const auto add = [&sources](auto... values) { (sources.Add(values), ...); };
    add(settings->GetNoiseType(), settings->GetNoiseTextureSize(), settings->GetNoiseGrainSize(),
      settings->GetMinNoiseValue(), settings->GetMaxNoiseValue(),
      settings->GetNumberOfNoiseLevels(), settings->GetImpulseNoiseProbability(),
      settings->GetImpulseNoiseBackgroundValue(), settings->GetNoiseGeneratorSeed());
  }
  return sources;
}
}

bool ChosenNoise::Update(vtkLICSettings* settings)
{
  Dependencies sources = GetSources(settings);
  if (sources == this->Sources)
  {
    return true;
  }
  vtkImageData* image = settings->GetNoiseDataSet();
  const char* fileName = settings->GetNoiseFileName();
  const bool made = image ? this->ReadImage(image, "The noise image")
    : fileName            ? this->ReadFile(fileName)
                          : this->Generate(settings);
  if (made)
  {
    ++this->Version;
    this->Error.clear();
    this->Sources = std::move(sources);
  }
  else
  {
    this->Texels.Values.clear();
    this->Sources.Clear(); // the file may exist next time
  }
  return made;
}

bool ChosenNoise::ReadImage(vtkImageData* image, const std::string& what)
{
  std::string error;
  if (!this->Texels.Read(image, error))
  {
    this->Error = what + " " + error + ".";
    return false;
  }
  return true;
}

bool ChosenNoise::ReadFile(const std::string& fileName)
{
  const std::string what = "The noise file \"" + fileName + "\"";
  if (!std::ifstream(fileName))
  {
    this->Error = what + " cannot be opened.";
    return false;
  }
  auto reader = vtk::TakeSmartPointer(vtkImageReader2Factory::CreateImageReader2(fileName.c_str()));
  if (!reader)
  {
    this->Error = what + " is not in an image format that VTK can read.";
    return false;
  }
  reader->SetFileName(fileName.c_str());
  if (!RunQuietly(reader).empty())
  {
    this->Error = what + " cannot be read.";
    return false;
  }
  return this->ReadImage(reader->GetOutput(), what);
}

bool ChosenNoise::Generate(vtkLICSettings* settings)
{
  vtkNew<vtkLICNoiseSource> source;
  if (settings->GetGenerateNoiseTexture())
  {
    source->SetNoiseType(settings->GetNoiseType());
    source->SetNoiseTextureSize(settings->GetNoiseTextureSize());
    source->SetNoiseGrainSize(settings->GetNoiseGrainSize());
    source->SetMinNoiseValue(settings->GetMinNoiseValue());
    source->SetMaxNoiseValue(settings->GetMaxNoiseValue());
    source->SetNumberOfNoiseLevels(settings->GetNumberOfNoiseLevels());
    source->SetImpulseNoiseProbability(settings->GetImpulseNoiseProbability());
    source->SetImpulseNoiseBackgroundValue(settings->GetImpulseNoiseBackgroundValue());
    source->SetNoiseGeneratorSeed(settings->GetNoiseGeneratorSeed());
  }
  if (!RunQuietly(source).empty())
  {
    this->Error = std::string("Cannot generate the noise: ") + source->GetErrorMessage();
    return false;
  }
  return this->ReadImage(source->GetOutput(), "The generated noise");
}
}
