// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoReliefs.h"

#include "vtkFloatArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

vtkSmartPointer<vtkImageData> RelevoMakeRelief(int width, int height,
  relevo::ReliefProjection projection, const relevo::dmat4& matrix, const RelevoDepth& depth)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> depths;
  depths->SetName("Depth");
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      colors->InsertNextTuple3(
        255.0 * column / std::max(width - 1, 1), 255.0 * row / std::max(height - 1, 1), 128.0);
      depths->InsertNextValue(static_cast<float>(depth(column, row)));
    }
  }
  image->GetPointData()->AddArray(colors);
  image->GetPointData()->AddArray(depths);
  relevo::Relief::Describe(image, projection, matrix);
  return image;
}

vtkSmartPointer<vtkImageData> RelevoMakeImage(
  int width, int height, int type, const RelevoDepth& value, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      for (int k = 0; k < components; ++k)
      {
        image->SetScalarComponentFromDouble(column, row, 0, k, value(column, row));
      }
    }
  }
  return image;
}

relevo::Relief RelevoReadRelief(RelevoCheck& check, vtkImageAlgorithm* filter)
{
  RelevoErrors errors(filter);
  filter->Update();
  CHECK(errors.None());
  relevo::Relief relief;
  CHECK(relief.Read(filter->GetOutput()).empty());
  return relief;
}

relevo::dvec3 RelevoGetPoint(const relevo::Relief& relief, int column, int row)
{
  return relief.GetWorldPoint(column, row, relief.GetTexelHeight(column, row));
}

relevo::dmat4 RelevoPinhole(int width, int height, double texel)
{
  relevo::dmat4 matrix(1.0);
  matrix[0][0] = texel;
  matrix[1][1] = texel;
  matrix[2] = relevo::dvec4(-0.5 * (width - 1) * texel, -0.5 * (height - 1) * texel, 1.0, 0.0);
  return matrix;
}
