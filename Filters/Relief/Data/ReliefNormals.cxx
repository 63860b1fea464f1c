// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/ReliefNormals.h"

#include "Data/Relief.h"
#include "Data/ReliefSides.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"

namespace relevo
{
namespace
{
class NormalsOfTexels
{
public:
  explicit NormalsOfTexels(const Relief& relief)
    : TheRelief(relief)
    , Sides(FindReliefSides(relief, DefaultMaximumStretch))
    , PlanesToWorld(transpose(relief.GetWorldToTexel()))
  {
  }

  // Returns the normal of the tangent plane, which is transformed by its four coefficients.
  dvec3 GetNormal(int column, int row) const
  {
    const double height = this->TheRelief.GetTexelHeight(column, row);
    if (!(height == height)) // NaN
    {
      return dvec3(0.0);
    }
    const double along = this->GetSlope(column, row, RightSide, 1, 0);
    const double across = this->GetSlope(column, row, UpperSide, 0, 1);
    const dvec4 plane(-along, -across, 1.0, along * column + across * row - height);
    const dvec3 normal = normalize(dvec3(this->PlanesToWorld * plane));
    // Heights increase towards the viewer in perspective, and away from the viewer otherwise. A
    // negative w reverses this.
    const double place = (this->TheRelief.GetTexelToWorld() * dvec4(column, row, height, 1.0)).w;
    return (place > 0.0) == this->TheRelief.IsPerspective() ? normal : -normal;
  }

private:
  bool IsJoined(int column, int row, ReliefSide side) const
  {
    return column >= 0 && row >= 0 &&
      (this->Sides[static_cast<size_t>(row) * this->TheRelief.GetWidth() + column] & side) != 0;
  }

  double GetSlope(int column, int row, ReliefSide side, int right, int up) const
  {
    const int before = this->IsJoined(column - right, row - up, side) ? 1 : 0;
    const int behind = this->IsJoined(column, row, side) ? 1 : 0;
    const auto height = [&](int steps)
    { return this->TheRelief.GetTexelHeight(column + steps * right, row + steps * up); };
    return before + behind > 0 ? (height(behind) - height(-before)) / (before + behind) : 0.0;
  }

  const Relief& TheRelief;
  const std::vector<unsigned char> Sides;
  const dmat4 PlanesToWorld;
};
}

vtkSmartPointer<vtkFloatArray> ComputeReliefNormals(const Relief& relief)
{
  const NormalsOfTexels texels(relief);
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName(Relief::GetNormalsName());
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(relief.GetNumberOfTexels());
  float* all = normals->GetPointer(0);
  vtkSMPTools::For(0, relief.GetHeight(),
    [&](vtkIdType begin, vtkIdType end)
    {
      float* at = all + 3 * begin * relief.GetWidth();
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        for (int column = 0; column < relief.GetWidth(); ++column)
        {
          const dvec3 normal = texels.GetNormal(column, row);
          for (int i = 0; i < 3; ++i)
          {
            *at++ = static_cast<float>(normal[i]);
          }
        }
      }
    });
  return normals;
}
}
