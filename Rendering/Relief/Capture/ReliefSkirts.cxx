// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/ReliefSkirts.h"

#include "Data/Relief.h"
#include "Data/ReliefSides.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
namespace
{
// The number of rings next to a silhouette, and where quads share only corners.
constexpr int NumberOfRings = 2;

class Skirts
{
public:
  Skirts(const Relief& relief, const std::vector<unsigned char>& sides)
    : Source(relief)
    , Sides(sides)
    , Nearer(relief.IsPerspective() ? 1.0 : -1.0)
    , Heights(sides.size(), NaN)
    , Origins(sides.size(), -1)
  {
  }

  bool Make()
  {
    for (int row = 0; row < this->Source.GetHeight(); ++row)
    {
      for (int column = 0; column < this->Source.GetWidth(); ++column)
      {
        this->AddOpening(column, row, 1, 0, RightSide);
        this->AddOpening(column, row, 0, 1, UpperSide);
      }
    }
    const bool isAny = !this->Ring.empty();
    for (int i = 1; i < NumberOfRings; ++i)
    {
      this->Grow();
    }
    return isAny;
  }

  double GetHeight(vtkIdType texel) const { return this->Heights[texel]; }
  // Return the texel whose colour is used; -1 for none.
  vtkIdType GetOrigin(vtkIdType texel) const { return this->Origins[texel]; }

private:
  struct Step
  {
    vtkIdType Texel;
    int Right;
    int Up;
  };

  bool Contains(int column, int row) const
  {
    return column >= 0 && row >= 0 && column < this->Source.GetWidth() &&
      row < this->Source.GetHeight();
  }
  vtkIdType GetIndex(int column, int row) const
  {
    return static_cast<vtkIdType>(row) * this->Source.GetWidth() + column;
  }

  // Add the opening between a texel and the next one, if both are valid and not connected.
  void AddOpening(int column, int row, int right, int up, ReliefSide side)
  {
    if (!this->Contains(column + right, row + up) ||
      (this->Sides[this->GetIndex(column, row)] & side))
    {
      return;
    }
    const double first = this->Source.GetTexelHeight(column, row);
    const double second = this->Source.GetTexelHeight(column + right, row + up);
    if (first * this->Nearer < second * this->Nearer)
    {
      this->Continue(column, row, right, up);
    }
    else if (first * this->Nearer > second * this->Nearer)
    {
      this->Continue(column + right, row + up, -right, -up);
    }
  }

  // Extend from a texel on the far side towards the near side.
  void Continue(int column, int row, int right, int up)
  {
    const double height = this->Source.GetTexelHeight(column, row);
    double slope = 0.0;
    if (this->Contains(column - right, row - up))
    {
      const vtkIdType first =
        this->GetIndex(std::min(column, column - right), std::min(row, row - up));
      const bool isJoined = (this->Sides[first] & (right != 0 ? RightSide : UpperSide)) != 0;
      slope = isJoined ? height - this->Source.GetTexelHeight(column - right, row - up) : 0.0;
    }
    const vtkIdType from = this->GetIndex(column, row);
    this->Set(from, height, from);
    this->Set(this->GetIndex(column + right, row + up), height + slope, from);
    this->Ring.push_back({ this->GetIndex(column + right, row + up), right, up });
  }

  // If two extensions meet, use the farther one.
  void Set(vtkIdType texel, double height, vtkIdType origin)
  {
    double& last = this->Heights[texel];
    if (std::isnan(last) || height * this->Nearer < last * this->Nearer)
    {
      last = height;
      this->Origins[texel] = origin;
    }
  }

  // Extend the last ring to all sides.
  void Grow()
  {
    std::vector<Step> next;
    for (const Step& step : this->Ring)
    {
      const int column = static_cast<int>(step.Texel % this->Source.GetWidth());
      const int row = static_cast<int>(step.Texel / this->Source.GetWidth());
      for (const int* way : { Ways[0], Ways[1], Ways[2], Ways[3] })
      {
        const vtkIdType texel = this->Contains(column + way[0], row + way[1])
          ? this->GetIndex(column + way[0], row + way[1])
          : step.Texel;
        if (std::isnan(this->Heights[texel]))
        {
          const double own = this->Source.GetTexelHeight(column + way[0], row + way[1]);
          const double height = this->Heights[step.Texel];
          const bool isBehind = height * this->Nearer < own * this->Nearer;
          this->Set(texel, isBehind ? height : own, isBehind ? this->Origins[step.Texel] : texel);
          next.push_back({ texel, way[0], way[1] });
        }
      }
    }
    this->Ring.swap(next);
  }

  static constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr int Ways[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };

  const Relief& Source;
  const std::vector<unsigned char>& Sides;
  const double Nearer; // the sign of heights that grow towards the viewer
  std::vector<double> Heights;
  std::vector<vtkIdType> Origins;
  std::vector<Step> Ring; // the texels of the last extension
};
}

vtkSmartPointer<vtkImageData> MakeReliefSkirts(
  const Relief& relief, const std::vector<unsigned char>& sides)
{
  Skirts skirts(relief, sides);
  if (!skirts.Make())
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(relief.GetWidth(), relief.GetHeight(), 1);
  const int components = relief.GetNumberOfColorComponents();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(Relief::GetColorName());
  colors->SetNumberOfComponents(components);
  colors->SetNumberOfTuples(relief.GetNumberOfTexels());
  colors->Fill(0.0);
  vtkNew<vtkFloatArray> depths;
  depths->SetName(Relief::GetDepthName());
  depths->SetNumberOfTuples(relief.GetNumberOfTexels());
  for (vtkIdType i = 0; i < relief.GetNumberOfTexels(); ++i)
  {
    const vtkIdType origin = skirts.GetOrigin(i);
    depths->SetValue(i, static_cast<float>(relief.ToDepth(skirts.GetHeight(i))));
    if (origin >= 0)
    {
      std::copy_n(
        relief.GetColors() + components * origin, components, colors->GetPointer(components * i));
    }
  }
  image->GetPointData()->AddArray(colors);
  image->GetPointData()->AddArray(depths);
  image->GetFieldData()->ShallowCopy(relief.GetImage()->GetFieldData());
  return image;
}
}
