// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerSurface.h"

#include "Options/ViewerOptions.h"

#include "vtkG1Surface.h"
#include "vtkLinearSurface.h"
#include "vtkMicroMeshSurface.h"
#include "vtkNew.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPatchSurface.h"
#include "vtkPhongSurface.h"
#include "vtkProceduralSurface.h"
#include "vtkScalarTaggedSurface.h"

namespace
{
using Surface = vtkSmartPointer<vtkRefinementSurface>;

void SetPhong(const ViewerOptions& options, vtkPhongSurface* surface)
{
  surface->SetAlpha(options.Alpha.value_or(vtkNew<vtkPhongSurface>()->GetAlpha()));
}

void SetProcedural(const ViewerOptions& options, double diagonal, vtkProceduralSurface* surface)
{
  surface->SetAmplitude(options.Amplitude.value_or(0.03 * diagonal));
  surface->SetFrequency(options.Frequency.value_or(vtkNew<vtkProceduralSurface>()->GetFrequency()));
}

Surface MakePhong(const ViewerOptions& options)
{
  vtkNew<vtkPhongSurface> surface;
  SetPhong(options, surface);
  return surface.Get();
}

Surface MakeProcedural(const ViewerOptions& options, double diagonal)
{
  vtkNew<vtkProceduralSurface> surface;
  SetProcedural(options, diagonal, surface);
  return surface.Get();
}
}

//------------------------------------------------------------------------------
Surface MakeSurface(const ViewerOptions& options, double diagonal)
{
  switch (options.GetSurface())
  {
    case ViewerOptions::SurfaceType::Linear:
      return Surface::Take(vtkLinearSurface::New());
    case ViewerOptions::SurfaceType::PNTriangle:
      return Surface::Take(vtkPNTriangleSurface::New());
    case ViewerOptions::SurfaceType::Phong:
      return MakePhong(options);
    case ViewerOptions::SurfaceType::ScalarTagged:
      return Surface::Take(vtkScalarTaggedSurface::New());
    case ViewerOptions::SurfaceType::Procedural:
      return MakeProcedural(options, diagonal);
    case ViewerOptions::SurfaceType::G1:
      return Surface::Take(vtkG1Surface::New());
    case ViewerOptions::SurfaceType::MicroMesh:
      return Surface::Take(vtkMicroMeshSurface::New());
    case ViewerOptions::SurfaceType::Patch:
      return Surface::Take(vtkPatchSurface::New());
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void UpdateSurface(const ViewerOptions& options, double diagonal, vtkRefinementSurface* surface)
{
  if (auto* phong = vtkPhongSurface::SafeDownCast(surface))
  {
    SetPhong(options, phong);
  }
  if (auto* procedural = vtkProceduralSurface::SafeDownCast(surface))
  {
    SetProcedural(options, diagonal, procedural);
  }
}
