// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/TerrainColours.h"

#include "vtkColorTransferFunction.h"
#include "vtkHeightField.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeHypsometricTint(vtkHeightField* heights, vtkScalarsToColors* tint)
{
  const int largestTexture = 4096;
  const int numberOfColours = 256;
  double range[2];
  std::copy_n(tint->GetRange(), 2, range);
  std::vector<double> colours(3 * numberOfColours);
  for (int i = 0; i < numberOfColours; ++i)
  {
    tint->GetColor(
      range[0] + i * (range[1] - range[0]) / (numberOfColours - 1), &colours[3 * size_t(i)]);
  }

  int size[2];
  heights->GetDimensions(size);
  size[0] = std::min(size[0], largestTexture);
  size[1] = std::min(size[1], largestTexture);
  const double toColour = (numberOfColours - 1) / (range[1] - range[0]);

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  vtkSMPTools::For(0, size[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < size[0]; ++column)
        {
          const double height = heights->GetHeight((column + 0.5) / size[0], (row + 0.5) / size[1]);
          const int index = static_cast<int>(std::lround(toColour * (height - range[0])));
          const double* colour = &colours[3 * std::min(std::max(index, 0), numberOfColours - 1)];
          unsigned char* pixel = pixels + 3 * (row * size[0] + column);
          std::transform(colour, colour + 3, pixel,
            [](double value) { return static_cast<unsigned char>(std::lround(255.0 * value)); });
        }
      }
    });
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> StretchContrast(vtkImageData* image)
{
  const unsigned char nothing[3] = { 128, 128, 128 };
  auto stretched = vtkSmartPointer<vtkImageData>::New();
  stretched->DeepCopy(image);
  auto* begin = static_cast<unsigned char*>(stretched->GetScalarPointer());
  auto* end = begin + 3 * stretched->GetNumberOfPoints();

  std::array<std::array<vtkIdType, 256>, 3> histograms{};
  vtkIdType numberOfPixels = 0;
  for (const unsigned char* pixel = begin; pixel != end; pixel += 3)
  {
    if (!std::equal(pixel, pixel + 3, nothing))
    {
      ++numberOfPixels;
      for (int band = 0; band < 3; ++band)
      {
        ++histograms[band][pixel[band]];
      }
    }
  }

  std::array<std::array<unsigned char, 256>, 3> tables;
  for (int band = 0; band < 3; ++band)
  {
    const auto percentile = [&](double percent)
    {
      vtkIdType count = 0;
      int value = 0;
      while (value < 255 && (count += histograms[band][value]) < 0.01 * percent * numberOfPixels)
      {
        ++value;
      }
      return value;
    };
    const int low = percentile(0.1);
    const int high = std::max(percentile(98.0), low + 1);
    for (int value = 0; value < 256; ++value)
    {
      tables[band][value] =
        static_cast<unsigned char>(std::min(std::max(255 * (value - low) / (high - low), 0), 255));
    }
  }

  for (unsigned char* pixel = begin; pixel != end; pixel += 3)
  {
    if (!std::equal(pixel, pixel + 3, nothing))
    {
      for (int band = 0; band < 3; ++band)
      {
        pixel[band] = tables[band][pixel[band]];
      }
    }
  }
  return stretched;
}
