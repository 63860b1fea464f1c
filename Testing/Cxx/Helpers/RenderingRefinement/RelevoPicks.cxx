// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoPicks.h"

#include "vtkHardwareSelector.h"

namespace RelevoPicks
{
bool Hit::operator==(const Hit& other) const
{
  return this->Actor == other.Actor && this->Block == other.Block && this->Id == other.Id;
}

int FindActor(RelevoScene& scene, vtkProp* prop)
{
  for (size_t i = 0; i < scene.GetNumberOfActors(); ++i)
  {
    if (scene.GetActor(i) == prop)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::vector<Hit> SelectPixels(RelevoScene& scene, int association)
{
  const int* size = scene.Window->GetSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, size[0] - 1, size[1] - 1);
  selector->SetFieldAssociation(association);
  std::vector<Hit> hits;
  if (!selector->CaptureBuffers())
  {
    return hits;
  }
  for (unsigned int y = 0; y < static_cast<unsigned int>(size[1]); ++y)
  {
    for (unsigned int x = 0; x < static_cast<unsigned int>(size[0]); ++x)
    {
      const unsigned int position[2] = { x, y };
      const auto pixel = selector->GetPixelInformation(position);
      Hit hit;
      if (pixel.Valid)
      {
        hit.Actor = FindActor(scene, pixel.Prop);
        hit.Block = static_cast<int>(pixel.CompositeID);
        hit.Id = pixel.AttributeID;
      }
      hits.push_back(hit);
    }
  }
  return hits;
}
}
