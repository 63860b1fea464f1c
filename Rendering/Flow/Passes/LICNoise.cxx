// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICNoise.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkLICNoiseSource.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <fstream>

namespace relevo
{
namespace
{
// The first counts: the executive's comes after the algorithm's.
void KeepMessage(vtkObject*, unsigned long, void* client, void* text)
{
  std::string& message = *static_cast<std::string*>(client);
  message = message.empty() ? static_cast<const char*>(text) : message;
}

// Runs an algorithm whose errors the user shall hear from the mapper.
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
}

LICNoise::LICNoise() = default;
LICNoise::~LICNoise() = default;

vtkMTimeType LICNoise::GetMTime() const
{
  vtkMTimeType time = std::max(this->Time.GetMTime(), this->Source->GetMTime());
  return this->Image ? std::max(time, this->Image->GetMTime()) : time;
}

bool LICNoise::Update()
{
  if (this->UpdateTime < this->GetMTime())
  {
    this->Error.clear();
    this->Texels.Values.clear();
    const bool made = this->Image ? this->TakeImage(this->Image, "The noise image")
      : !this->FileName.empty()   ? this->ReadFile()
                                  : this->Generate();
    if (!made)
    {
      this->Texels.Values.clear();
    }
    this->UpdateTime = this->GetMTime();
  }
  return this->Error.empty();
}

bool LICNoise::TakeImage(vtkImageData* image, const std::string& what)
{
  std::string error;
  if (!this->Texels.Read(image, error))
  {
    this->Error = what + " " + error + ".";
    return false;
  }
  return true;
}

bool LICNoise::ReadFile()
{
  const std::string what = "The noise file \"" + this->FileName + "\"";
  if (!std::ifstream(this->FileName))
  {
    this->Error = what + " cannot be opened.";
    return false;
  }
  auto reader =
    vtk::TakeSmartPointer(vtkImageReader2Factory::CreateImageReader2(this->FileName.c_str()));
  if (!reader)
  {
    this->Error = what + " is of no image format that VTK reads.";
    return false;
  }
  reader->SetFileName(this->FileName.c_str());
  if (!RunQuietly(reader).empty())
  {
    this->Error = what + " cannot be read.";
    return false;
  }
  return this->TakeImage(reader->GetOutput(), what);
}

bool LICNoise::Generate()
{
  vtkNew<vtkLICNoiseSource> byDefault;
  vtkLICNoiseSource* source = this->Generated ? this->Source.Get() : byDefault.Get();
  const std::string message = RunQuietly(source);
  if (!message.empty())
  {
    this->Error = "Noise cannot be made: " + message;
    source->Modified(); // says so again when it is asked again
    return false;
  }
  return this->TakeImage(source->GetOutput(), "The generated noise");
}

vtkTextureObject* LICNoise::GetTexture(vtkOpenGLRenderWindow* window)
{
  if (!this->Texture || this->TextureTime != this->UpdateTime ||
    this->Texture->GetContext() != window)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetWrapS(vtkTextureObject::Repeat);
    this->Texture->SetWrapT(vtkTextureObject::Repeat);
    this->TextureTime = this->UpdateTime;
    if (!this->Texture->Create2DFromRaw(static_cast<unsigned int>(this->Texels.Plane.Columns),
          static_cast<unsigned int>(this->Texels.Plane.Rows), 1, VTK_FLOAT,
          this->Texels.Values.data()))
    {
      this->Texture = nullptr;
    }
  }
  return this->Texture;
}

void LICNoise::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}

vtkTypeInt64 LICNoise::GetMemorySize() const
{
  return this->Texture ? static_cast<vtkTypeInt64>(this->Texels.Values.size() * sizeof(float)) : 0;
}
}
