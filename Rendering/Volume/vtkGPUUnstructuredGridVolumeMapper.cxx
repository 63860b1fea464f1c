// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGPUUnstructuredGridVolumeMapperInternals.h"

#include "Checks/MemoryGuard.h"
#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

vtkStandardNewMacro(vtkGPUUnstructuredGridVolumeMapper);

vtkGPUUnstructuredGridVolumeMapper::vtkGPUUnstructuredGridVolumeMapper()
  : Internals(std::make_unique<vtkInternals>())
{
  this->Internals->Context->OnRelease = [this](vtkWindow* window)
  {
    vtkInternals& data = *this->Internals;
    data.MeshBuffers.ReleaseGraphicsResources(window);
    data.Projected.ReleaseGraphicsResources(window);
    data.FunctionBuffers.ReleaseGraphicsResources(window);
    data.Surfaces.ReleaseGraphicsResources(window);
    data.Integrals.ReleaseGraphicsResources(window);
    data.Depth.ReleaseGraphicsResources(window);
    data.Limits.ReleaseGraphicsResources(window);
    data.Projection.ReleaseGraphicsResources(window);
    data.Entries.ReleaseGraphicsResources(window);
    data.Clock.ReleaseGraphicsResources();
    data.Programs.clear();
    data.Quads.ReleaseGraphicsResources();
    data.Screen.ReleaseGraphicsResources();
    data.HasMesh = false;
    data.AreFunctionsTried = false;
    data.MeshInput = nullptr;
  };
}

vtkGPUUnstructuredGridVolumeMapper::~vtkGPUUnstructuredGridVolumeMapper()
{
  this->ReleaseGraphicsResources(nullptr);
  this->Internals->Context->OnRelease = nullptr;
}

void vtkGPUUnstructuredGridVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Context->Release();
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkGPUUnstructuredGridVolumeMapper::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

double* vtkGPUUnstructuredGridVolumeMapper::GetBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return this->Bounds;
  }
  this->Update();
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    composite->GetBounds(this->Bounds);
  }
  else if (auto* mesh = vtkDataSet::SafeDownCast(input))
  {
    mesh->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

void vtkGPUUnstructuredGridVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  // Colours of a volume would be taken for the numbers of what is selected behind it.
  if (renderer->GetSelector())
  {
    return;
  }
  vtkInternals& data = *this->Internals;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("The render window is not one of OpenGL.");
    return;
  }
  data.Context->SetContext(window);
  data.Clock.Start();
  const auto draw = [&]
  {
    const bool isReady = this->UpdateMesh(volume) && this->UpdateFunctions(volume) &&
      this->UpdateView(renderer, volume);
    if (isReady)
    {
      this->UpdateFeatures(renderer, volume);
      if (this->UpdateTables())
      {
        this->Draw(renderer, volume);
      }
    }
    return isReady;
  };
  relevo::RunWithinMemory(this, "the picture", draw);
  this->TimeToDraw = data.Clock.Stop();
  data.WholeTime = this->TimeToDraw * data.SampleDistance * data.SampleDistance;
}

void vtkGPUUnstructuredGridVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VectorMode: " << this->VectorMode << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "IsoSurfaces: " << (this->IsoSurfaces ? "On" : "Off") << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Integration: " << this->Integration << "\n";
  os << indent << "TableSize: " << this->TableSize << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << (this->AutoAdjustSampleDistances ? "On" : "Off")
     << "\n";
}
