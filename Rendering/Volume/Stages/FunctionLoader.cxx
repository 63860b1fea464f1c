// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/FunctionLoader.h"

#include "Checks/ShouldReport.h"
#include "Mesh/RayCastMesh.h"

#include "vtkContourValues.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

namespace relevo
{
namespace
{
Dependencies FindLoaded(const FunctionRequest& request, Dependencies now)
{
  vtkVolumeProperty* property = request.Property;
  now.AddObject(property->GetIsoSurfaceValues());
  now.Add(request.Mesh.Radius);
  for (int i = 0; i < MaximumComponents; ++i)
  {
    now.Add(property->GetComponentWeight(i));
    now.Add(request.Mesh.ScalarLow[i]);
    now.Add(request.Mesh.ScalarSize[i]);
  }
  return now;
}
}

bool FunctionLoader::Update(const FunctionRequest& request, StageReport& report)
{
  const Dependencies functions =
    TransferFunctions::FindDependencies(request.Property, request.NumberOfComponents);
  if (this->Reported.Update(functions))
  {
    this->Error.clear();
    this->Warning.clear();
  }
  if (this->Known.Update(FindLoaded(request, functions)))
  {
    std::string warning;
    const std::string error = this->Load(request, warning);
    if (ShouldReport(this->Error, error))
    {
      report.Errors.push_back(error);
    }
    if (ShouldReport(this->Warning, warning))
    {
      report.Warnings.push_back(warning);
    }
  }
  return this->Error.empty();
}

std::string FunctionLoader::Load(const FunctionRequest& request, std::string& warning)
{
  VolumeFunctions& to = this->Functions;
  std::string words;
  if (!to.Functions.Read(request.Property, request.NumberOfComponents, words, warning))
  {
    warning.clear();
    return "The volume property " + words + ".";
  }
  if (!warning.empty())
  {
    warning = "The volume property " + warning + ".";
  }
  ++to.Version;
  const RayCastMesh& mesh = request.Mesh;
  const bool isUploaded =
    to.Buffers.Upload(request.Window, to.Functions, mesh.ScalarLow, mesh.ScalarSize, mesh.Radius) &&
    to.Surfaces.Upload(
      request.Window, request.Property, to.Functions, mesh.ScalarLow, mesh.ScalarSize);
  return isUploaded ? ""
                    : "The functions of the volume property have too many nodes or texels for the "
                      "buffer textures of this OpenGL.";
}

void FunctionLoader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Functions.Buffers.ReleaseGraphicsResources(window);
  this->Functions.Surfaces.ReleaseGraphicsResources(window);
  this->Known.Clear();
}
}
