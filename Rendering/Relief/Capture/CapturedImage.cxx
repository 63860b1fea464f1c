// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/CapturedImage.h"

#include "Capture/CaptureTarget.h"
#include "Capture/FittedCamera.h"
#include "Data/Relief.h"
#include "Data/ReliefNormals.h"
#include "Data/ZBufferSpace.h"
#include "View/WorldView.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// Return whether a pixel has been drawn; nothing is drawn at the far plane itself.
bool IsDrawn(float z)
{
  return z < 1.0f;
}

class ImageMaker
{
public:
  ImageMaker(const CapturedPixels& pixels, const FittedCamera& camera, const PixelWindow& window)
    : Pixels(pixels)
    , Part(window)
    , Space(camera.Camera, pixels.Width, pixels.Height)
    , Offset(camera.Range.x)
    , NormalsToWorld(transpose(dmat3(MakeMatrix(camera.Camera->GetModelViewTransformMatrix()))))
  {
  }

  vtkSmartPointer<vtkImageData> Make(bool withNormals)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    const int width = this->Part.End[0] - this->Part.Begin[0];
    const int height = this->Part.End[1] - this->Part.Begin[1];
    image->SetDimensions(width, height, 1);
    const vtkIdType number = image->GetNumberOfPoints();
    this->Colors->SetName(Relief::GetColorName());
    this->Colors->SetNumberOfComponents(3);
    this->Colors->SetNumberOfTuples(number);
    this->Depths->SetName(Relief::GetDepthName());
    this->Depths->SetNumberOfTuples(number);
    this->Normals->SetName(Relief::GetNormalsName());
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetNumberOfTuples(withNormals ? number : 0);
    vtkSMPTools::For(0, height,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin * width; i < end * width; ++i)
        {
          this->MakeTexel(i, static_cast<int>(i % width), static_cast<int>(i / width), withNormals);
        }
      });
    image->GetPointData()->AddArray(this->Colors);
    image->GetPointData()->AddArray(this->Depths);
    Relief::Describe(image, this->Space.GetProjection(), this->GetMatrix());
    if (withNormals)
    {
      this->FillNormals(image);
      image->GetPointData()->AddArray(this->Normals);
    }
    return image;
  }

private:
  void MakeTexel(vtkIdType to, int column, int row, bool withNormals)
  {
    const int x = column + this->Part.Begin[0];
    const int y = row + this->Part.Begin[1];
    const size_t from = static_cast<size_t>(y) * this->Pixels.Width + x;
    const float z = this->Pixels.ZBuffer[from];
    std::copy_n(&this->Pixels.Colors[3 * from], 3, this->Colors->GetPointer(3 * to));
    // Another prop may have drawn over the shader's values.
    const float* written = &this->Pixels.Depths[2 * from];
    const bool isWritten = IsDrawn(z) && std::abs(written[1] - z) <= 1e-6f;
    this->Depths->SetValue(
      to, IsDrawn(z) ? this->GetDepth(x, y, z, isWritten ? written[0] : 0.0f) : NaN);
    if (withNormals)
    {
      const float* n = &this->Pixels.Normals[4 * from];
      dvec3 normal = this->NormalsToWorld * dvec3(n[0], n[1], n[2]);
      const double size = length(normal);
      normal = isWritten && size > 0.0 && std::isfinite(size) ? normal / size : dvec3(0.0);
      const vec3 rounded(normal);
      this->Normals->SetTypedTuple(to, &rounded[0]);
    }
  }

  // In perspective, a depth from a shader is more precise far from the camera.
  float GetDepth(int x, int y, float z, float written) const
  {
    if (this->Space.GetProjection() == ReliefProjection::Parallel)
    {
      return static_cast<float>(this->Space.GetDepth(x, y, z) - this->Offset);
    }
    return written > 0.0f ? written : static_cast<float>(this->Space.GetDepth(x, y, z));
  }

  dmat4 GetMatrix() const
  {
    dmat4 matrix = this->Space.GetMatrix(this->Offset);
    const int origin = this->Space.GetProjection() == ReliefProjection::Parallel ? 3 : 2;
    matrix[origin] += static_cast<double>(this->Part.Begin[0]) * matrix[0] +
      static_cast<double>(this->Part.Begin[1]) * matrix[1];
    return matrix;
  }

  // Compute normals that no shader has written from the depths.
  void FillNormals(vtkImageData* image)
  {
    vtkSmartPointer<vtkFloatArray> others;
    for (vtkIdType i = 0; i < this->Normals->GetNumberOfTuples(); ++i)
    {
      const float* normal = this->Normals->GetPointer(3 * i);
      const bool isMissing = normal[0] == 0.0f && normal[1] == 0.0f && normal[2] == 0.0f;
      if (!isMissing || std::isnan(this->Depths->GetValue(i)))
      {
        continue;
      }
      if (!others)
      {
        Relief relief;
        relief.Read(image);
        others = ComputeReliefNormals(relief);
      }
      this->Normals->SetTypedTuple(i, others->GetPointer(3 * i));
    }
  }

  static constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

  const CapturedPixels& Pixels;
  const PixelWindow Part;
  const ZBufferSpace Space;
  const double Offset;
  const dmat3 NormalsToWorld;
  vtkNew<vtkUnsignedCharArray> Colors;
  vtkNew<vtkFloatArray> Depths;
  vtkNew<vtkFloatArray> Normals;
};
}

PixelWindow FindDrawn(const CapturedPixels& pixels)
{
  PixelWindow window = { { pixels.Width, pixels.Height }, { 0, 0 } };
  for (int row = 0; row < pixels.Height; ++row)
  {
    const float* z = &pixels.ZBuffer[static_cast<size_t>(row) * pixels.Width];
    const float* end = z + pixels.Width;
    const float* first = std::find_if(z, end, IsDrawn);
    if (first != end)
    {
      const float* last = end - 1;
      while (!IsDrawn(*last))
      {
        --last;
      }
      window.Begin[0] = std::min(window.Begin[0], static_cast<int>(first - z));
      window.End[0] = std::max(window.End[0], static_cast<int>(last - z) + 1);
      window.Begin[1] = std::min(window.Begin[1], row);
      window.End[1] = row + 1;
    }
  }
  return window;
}

vtkSmartPointer<vtkImageData> MakeCapturedImage(
  const CapturedPixels& pixels, const FittedCamera& camera, bool withNormals, bool cropped)
{
  const PixelWindow drawn = FindDrawn(pixels);
  if (drawn.End[0] == 0)
  {
    return nullptr;
  }
  const PixelWindow whole = { { 0, 0 }, { pixels.Width, pixels.Height } };
  return ImageMaker(pixels, camera, cropped ? drawn : whole).Make(withNormals);
}
}
