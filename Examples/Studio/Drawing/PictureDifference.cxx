// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PictureDifference.h"

#include "Mathematics/PictureSimilarity.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

//------------------------------------------------------------------------------
void PictureDifference::Read(int picture, vtkRenderWindow* window, const std::array<int, 2>& size)
{
  this->Size = size;
  vtkNew<vtkUnsignedCharArray> pixels;
  const int isFront = 0;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, isFront, pixels.Get());
  this->Pixels[picture].assign(
    pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

//------------------------------------------------------------------------------
void PictureDifference::Compare()
{
  this->Similarity =
    relevo::GetPictureSimilarity(this->Pixels[0], this->Pixels[1], this->Size[0], this->Size[1]);
  this->NumberOfDifferentPixels = 0;
  for (std::size_t i = 0; i + 2 < this->Pixels[0].size(); i += 3)
  {
    const bool isSame =
      std::equal(&this->Pixels[0][i], &this->Pixels[0][i] + 3, &this->Pixels[1][i]);
    this->NumberOfDifferentPixels += isSame ? 0 : 1;
  }
}

//------------------------------------------------------------------------------
void PictureDifference::Draw(double gain, vtkImageData* image) const
{
  image->SetDimensions(this->Size[0], this->Size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* shades = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < this->Pixels[0].size(); ++i)
  {
    const int difference = std::abs(this->Pixels[0][i] - this->Pixels[1][i]);
    shades[i] = static_cast<unsigned char>(255.0 - std::min(std::round(gain * difference), 255.0));
  }
  image->Modified();
}
