// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/WarpSource.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <initializer_list>
#include <numeric>

namespace relevo
{
namespace
{
void CopyArrays(vtkFieldData* from, vtkFieldData* to, std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    if (vtkAbstractArray* array = from->GetAbstractArray(name))
    {
      const auto copy = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
      copy->DeepCopy(array);
      to->AddArray(copy);
    }
  }
}

// Opens sides without a quad, because no surface is drawn between their texels.
void OpenSidesWithoutQuads(std::vector<unsigned char>& sides, int width)
{
  const std::size_t columns = width;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    // There is no quad in the last column, which precedes the first column of the next row.
    const bool isBelow = i >= columns && (sides[i - columns] & Quad);
    const bool isLeft = i > 0 && (sides[i - 1] & Quad);
    const bool isQuad = (sides[i] & Quad) != 0;
    sides[i] = static_cast<unsigned char>(
      sides[i] & (Quad | (isQuad || isBelow ? RightSide : 0) | (isQuad || isLeft ? UpperSide : 0)));
  }
}
}

std::string WarpSource::Read(vtkImageData* image, double maximumStretch)
{
  vtkNew<vtkImageData> kept;
  kept->CopyStructure(image);
  CopyArrays(image->GetPointData(), kept->GetPointData(),
    { Relief::GetColorName(), Relief::GetDepthName(), Relief::GetNormalsName() });
  CopyArrays(image->GetFieldData(), kept->GetFieldData(),
    { Relief::GetProjectionName(), Relief::GetMatrixName(), Relief::GetWarpName() });
  const std::string wrong = this->TheRelief.Read(kept);
  if (!wrong.empty())
  {
    return wrong;
  }
  const int width = this->GetWidth();
  const int height = this->GetHeight();
  this->Sides = FindReliefSides(this->TheRelief, maximumStretch);
  OpenSidesWithoutQuads(this->Sides, width);
  this->Heights.resize(this->TheRelief.GetNumberOfTexels());
  this->Work.resize(height);
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        // Texels without surface only cost a test.
        double work = 0.1 * width;
        for (int column = 0; column < width; ++column)
        {
          const double texel = this->TheRelief.GetTexelHeight(column, row);
          this->Heights[this->GetIndex(column, row)] = texel;
          work += texel == texel;
        }
        this->Work[row] = work;
      }
    });
  std::partial_sum(this->Work.begin(), this->Work.end(), this->Work.begin());
  return "";
}

bool WarpSource::IsInside(int column, int row, bool isAtColumn) const
{
  const int before = isAtColumn ? column - 1 : column;
  return this->HasQuad(column, row) && this->HasQuad(column, row - 1) &&
    this->HasQuad(before, row) && this->HasQuad(before, row - 1);
}

int WarpSource::FindRow(double share) const
{
  const auto found =
    std::lower_bound(this->Work.begin(), this->Work.end(), share * this->Work.back());
  return static_cast<int>(found - this->Work.begin());
}
}
