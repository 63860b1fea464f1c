// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SectionIsolines.h"

#include "vtkActor.h"
#include "vtkArrayQuantityFilter.h"
#include "vtkContourFilter.h"
#include "vtkDataObject.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <cmath>

//------------------------------------------------------------------------------
SectionIsolines::SectionIsolines(vtkAlgorithmOutput* section, vtkRenderer* renderer)
{
  this->Lengths->SetInputConnection(section);
  this->Contours->SetInputConnection(this->Lengths->GetOutputPort());
  this->Contours->ComputeScalarsOff();
  this->Mapper->SetInputConnection(this->Contours->GetOutputPort());
  this->Mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  this->Actor->GetProperty()->LightingOff();
  renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
SectionIsolines::~SectionIsolines() = default;

//------------------------------------------------------------------------------
void SectionIsolines::Set(
  const std::string& array, bool isVector, double spacing, const double range[2])
{
  const std::string name = isVector ? "magnitude of " + array : array;
  this->Lengths->SetQuantity(name.c_str());
  this->Contours->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name.c_str());
  this->Contours->SetNumberOfContours(0);
  int number = 0;
  for (double factor = std::ceil(range[0] / spacing); factor * spacing <= range[1]; ++factor)
  {
    this->Contours->SetValue(number++, factor * spacing);
  }
}

//------------------------------------------------------------------------------
void SectionIsolines::SetOffset(double offset[3])
{
  this->Actor->SetPosition(offset);
}
