// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoTextures.h"

#include "vtkImageData.h"
#include "vtkNew.h"

namespace RelevoTextures
{
vtkSmartPointer<vtkTexture> Make(
  int width, int height, int components, const std::function<Texel(int x, int y)>& getTexel)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const Texel texel = getTexel(x, y);
      for (int c = 0; c < components; ++c)
      {
        *value++ = static_cast<unsigned char>(texel[static_cast<size_t>(c)]);
      }
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

vtkSmartPointer<vtkTexture> MakeMotley()
{
  return Make(8, 8, 3,
    [](int x, int y)
    {
      const int i = 3 * (8 * y + x);
      return Texel{ { i * 41 % 256, (i + 1) * 41 % 256, (i + 2) * 41 % 256, 255 } };
    });
}
}
