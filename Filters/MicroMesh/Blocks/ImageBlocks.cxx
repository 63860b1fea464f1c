// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/ImageBlocks.h"

#include "Blocks/BlockBorders.h"
#include "Blocks/ImageGradients.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace relevo
{
namespace
{
// Marks the points of a block on planes that other blocks share.
void MarkSharedPlanes(vtkImageData* image, const ImageExtent& whole)
{
  const int* extent = image->GetExtent();
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(FixedPointsName);
  marks->SetNumberOfComponents(2);
  marks->SetNumberOfTuples(image->GetNumberOfPoints());
  marks->Fill(0.0);
  for (int side = 0; side < 6; ++side)
  {
    if (extent[side] == whole[side])
    {
      continue;
    }
    int plane[6];
    std::copy_n(extent, 6, plane);
    plane[side / 2 * 2] = plane[side / 2 * 2 + 1] = extent[side];
    int ijk[3];
    for (ijk[2] = plane[4]; ijk[2] <= plane[5]; ++ijk[2])
    {
      for (ijk[1] = plane[2]; ijk[1] <= plane[3]; ++ijk[1])
      {
        for (ijk[0] = plane[0]; ijk[0] <= plane[1]; ++ijk[0])
        {
          unsigned char* mark = marks->GetPointer(2 * image->ComputePointId(ijk));
          mark[mark[0] == 0 ? 0 : 1] = BlockBorders::IsShared;
        }
      }
    }
  }
  image->GetPointData()->AddArray(marks);
}
}

std::vector<ImageExtent> DivideExtent(const ImageExtent& whole, int size)
{
  std::array<std::vector<int>, 3> ends;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int first = whole[2 * axis];
    const int cells = whole[2 * axis + 1] - first;
    if (cells < 1)
    {
      return {}; // no 3D cells
    }
    const int number = (cells + size - 1) / size;
    for (int i = 0; i <= number; ++i)
    {
      ends[axis].push_back(first + static_cast<int>(static_cast<long long>(cells) * i / number));
    }
  }
  std::vector<ImageExtent> blocks;
  for (std::size_t k = 1; k < ends[2].size(); ++k)
  {
    for (std::size_t j = 1; j < ends[1].size(); ++j)
    {
      for (std::size_t i = 1; i < ends[0].size(); ++i)
      {
        blocks.push_back({ { ends[0][i - 1], ends[0][i], ends[1][j - 1], ends[1][j], ends[2][k - 1],
          ends[2][k] } });
      }
    }
  }
  return blocks;
}

ImageExtent GrowExtent(const ImageExtent& block, const ImageExtent& whole, int layers)
{
  ImageExtent grown = block;
  for (std::size_t side = 0; side < 6; ++side)
  {
    grown[side] = side % 2 == 0 ? std::max(whole[side], block[side] - layers)
                                : std::min(whole[side], block[side] + layers);
  }
  return grown;
}

vtkSmartPointer<vtkPolyData> ContourImageBlock(vtkImageData* image, const ImageExtent& block,
  const ImageExtent& whole, const ContourSettings& settings, std::string& error)
{
  vtkDataArray* scalars = FindScalars(image, settings, error);
  if (!scalars)
  {
    return nullptr;
  }
  vtkNew<vtkImageData> cropped;
  cropped->CopyStructure(image);
  CopyContourArrays(image, scalars, settings, cropped->GetPointData());
  cropped->Crop(block.data());
  MarkSharedPlanes(cropped, whole);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(cropped);
  contour->ComputeNormalsOff();
  contour->SetComputeScalars(settings.ContourValues ? 1 : 0);
  contour->InterpolateAttributesOn();
  contour->SetNumberOfContours(static_cast<int>(settings.Values.size()));
  for (std::size_t i = 0; i < settings.Values.size(); ++i)
  {
    contour->SetValue(static_cast<int>(i), settings.Values[i]);
  }
  contour->Update();
  vtkSmartPointer<vtkPolyData> surface = contour->GetOutput();
  BlockBorders::SetFixedPoints(surface);
  CleanContour(cropped->GetPointData(), surface);
  if (settings.Gradients && surface->GetNumberOfPoints() > 0)
  {
    AddGradients(image, scalars, surface);
  }
  return surface;
}
}
