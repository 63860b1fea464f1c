// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpedImage.h"

#include "Warp/WarpSource.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace relevo
{
namespace
{
// Creates an array of this size, unless there is one that nobody else references.
template <class ArrayType>
void MakeArray(
  vtkSmartPointer<ArrayType>& array, const char* name, int components, vtkIdType tuples)
{
  if (!array || array->GetReferenceCount() > 1 || array->GetNumberOfTuples() != tuples ||
    array->GetNumberOfComponents() != components)
  {
    array = vtkSmartPointer<ArrayType>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
  }
}
}

void WarpedImage::Prepare(
  const std::shared_ptr<const WarpSource>& source, const WarpCoefficients& coefficients)
{
  this->Source = nullptr; // in case allocation fails
  const Relief& relief = source->GetRelief();
  const vtkIdType texels = relief.GetNumberOfTexels();
  MakeArray(this->Depths, Relief::GetDepthName(), 1, texels);
  MakeArray(this->Colors, Relief::GetColorName(), relief.GetNumberOfColorComponents(), texels);
  if (relief.GetNormals())
  {
    MakeArray(this->Normals, Relief::GetNormalsName(), 3, texels);
  }
  else
  {
    this->Normals = nullptr;
  }
  this->Picture.SetArrays(this->Depths->GetPointer(0), this->Colors->GetPointer(0),
    this->Normals ? this->Normals->GetPointer(0) : nullptr);
  this->Picture.Begin(relief);
  this->Source = source;
  this->Coefficients = coefficients;
}

bool WarpedImage::HasSizeOf(const WarpSource& source) const
{
  return this->Source && this->Source->GetWidth() == source.GetWidth() &&
    this->Source->GetHeight() == source.GetHeight();
}

void WarpedImage::CopyTo(vtkImageData* image) const
{
  vtkImageData* input = this->Source->GetRelief().GetImage();
  image->Initialize();
  image->CopyStructure(input);
  // The arrays are the same, but their values have changed.
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(this->Colors),
         static_cast<vtkDataArray*>(this->Depths), static_cast<vtkDataArray*>(this->Normals) })
  {
    if (array)
    {
      array->Modified();
      image->GetPointData()->AddArray(array);
    }
  }
  image->GetPointData()->SetActiveScalars(Relief::GetColorName());
  for (const char* name : { Relief::GetProjectionName(), Relief::GetMatrixName() })
  {
    image->GetFieldData()->AddArray(input->GetFieldData()->GetArray(name));
  }
  vtkNew<vtkDoubleArray> warp;
  warp->SetName(Relief::GetWarpName());
  for (double value : { this->Coefficients.K1, this->Coefficients.K2, this->Coefficients.K3,
         this->Coefficients.Plane })
  {
    warp->InsertNextValue(value);
  }
  image->GetFieldData()->AddArray(warp);
}
}
