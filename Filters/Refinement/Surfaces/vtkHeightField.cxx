// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeightField.h"

#include "Surfaces/HeightSampler.h"

#include <cmath>
#include <vector>

vtkHeightField::vtkHeightField() = default;
vtkHeightField::~vtkHeightField() = default;

double vtkHeightField::GetHeight(double u, double v)
{
  if (std::isnan(u) || std::isnan(v) || !this->Update())
  {
    return 0.0;
  }
  // This is heightPosition() in doubles. Floats would have an error of a ten-thousandth of a texel.
  relevo::HeightSampler sampler(this);
  const glm::dvec2 size(sampler.heightSize());
  const glm::dvec2 position =
    glm::clamp(glm::dvec2(u, v) * size - 0.5, glm::dvec2(0.0), size - 1.0);
  const glm::dvec2 corner = glm::floor(position);
  return sampler.heightBetween(glm::ivec2(corner), glm::vec2(position - corner));
}

bool vtkHeightField::IsValid(double u, double v)
{
  if (std::isnan(u) || std::isnan(v) || !this->Update())
  {
    return false;
  }
  relevo::HeightSampler sampler(this);
  return sampler.heightValid(glm::vec2(u, v));
}

std::shared_ptr<const unsigned char> vtkHeightField::ShareValidity()
{
  const unsigned char* validity = this->GetValidity();
  if (!validity)
  {
    return nullptr;
  }
  int dimensions[2];
  this->GetDimensions(dimensions);
  const auto copy = std::make_shared<std::vector<unsigned char>>(
    validity, validity + static_cast<std::size_t>(dimensions[0]) * dimensions[1]);
  return { copy, copy->data() };
}

void vtkHeightField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
