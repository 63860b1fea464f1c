// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICHoles.h"

#include "Changes/Dependencies.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

namespace relevo
{
namespace
{
void AddTexture(Dependencies& dependencies, vtkTexture* texture)
{
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  if (image && image->GetNumberOfScalarComponents() % 2 == 0) // the last component is the opacity
  {
    dependencies.AddObject(texture);
    dependencies.AddObject(image);
  }
}
}

void AddHoles(Dependencies& dependencies, vtkActor* act, vtkScalarsToColors* table)
{
  dependencies.AddObject(table && !table->IsOpaque() ? table : nullptr);
  AddTexture(dependencies, act->GetTexture());
  for (const auto& texture : act->GetProperty()->GetAllTextures())
  {
    AddTexture(dependencies, texture.second);
  }
}
}
