// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/VolumeFrame.h"

#include "Buffers/IntegralTable.h"
#include "Stages/FeatureSelector.h"
#include "Stages/FunctionLoader.h"
#include "Stages/MeshLoader.h"
#include "View/OpaqueDepth.h"

namespace relevo
{
RayView VolumeFrame::GetView(const std::array<int, 4>& viewport) const
{
  RayView view = this->View;
  view.SetViewport(dvec4(viewport[0], viewport[1], viewport[2], viewport[3]));
  return view;
}

std::string VolumeFrame::DescribeTooLarge(const std::array<int, 2>& size)
{
  return "There is not enough graphics memory for " + std::to_string(size[0]) + " x " +
    std::to_string(size[1]) + " pixels: raise ImageSampleDistance.";
}

void VolumeFrame::Activate(vtkShaderProgram* program) const
{
  this->Features.Planes.SetUniforms(program);
  this->Features.Lights.SetUniforms(program);
  this->Mesh.Buffers.Activate(program);
  this->Functions.Buffers.Activate(program);
  this->Functions.Surfaces.Activate(program);
  this->Table.Activate(program);
  this->Depth.Activate(program);
}

void VolumeFrame::Deactivate() const
{
  this->Depth.Deactivate();
  this->Table.Deactivate();
  this->Functions.Surfaces.Deactivate();
  this->Functions.Buffers.Deactivate();
  this->Mesh.Buffers.Deactivate();
}
}
