// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightField.h"

#include "vtkHeightSampler.h"

vtkHeightField::vtkHeightField() = default;
vtkHeightField::~vtkHeightField() = default;

double vtkHeightField::GetHeight(double u, double v)
{
  if (!this->Update())
  {
    return 0.0;
  }
  relevo::HeightSampler sampler(this);
  return sampler.heightAt(glm::vec2(u, v));
}

bool vtkHeightField::IsValid(double u, double v)
{
  if (!this->Update())
  {
    return false;
  }
  relevo::HeightSampler sampler(this);
  return sampler.heightValid(glm::vec2(u, v));
}

void vtkHeightField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
