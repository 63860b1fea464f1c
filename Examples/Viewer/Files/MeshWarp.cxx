// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/MeshWarp.h"

#include "Files/ResultBlocks.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkWarpVector.h"

#include <algorithm>
#include <cmath>

namespace
{
const double Farthest = 1e30; // that graphics cards can square

bool HasVectors(vtkDataSet* block, const std::string& name)
{
  vtkDataArray* array = block->GetPointData()->GetArray(name.c_str());
  if (array && array->GetNumberOfComponents() != 3)
  {
    throw ViewerError("--warp needs an array of points with 3 components, and '" + name + "' has " +
      std::to_string(array->GetNumberOfComponents()));
  }
  return array != nullptr;
}

vtkSmartPointer<vtkDataSet> Move(vtkDataSet* block, const MeshWarp& warp, ViewerMessages& messages)
{
  vtkNew<vtkWarpVector> filter;
  messages.Observe(filter, "moving points");
  filter->SetInputData(block);
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, warp.Array.c_str());
  filter->SetScaleFactor(warp.Factor);
  filter->Update();
  messages.Check();
  auto* moved = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  double before[6];
  double after[6];
  block->GetBounds(before);
  moved->GetBounds(after);
  const auto isFar = [](double bound) { return !(std::abs(bound) < Farthest); };
  if (std::any_of(after, after + 6, isFar) && std::none_of(before, before + 6, isFar))
  {
    throw ViewerError("--scale " + JoinNumbers({ warp.Factor }) +
      " moves points too far away; use a smaller factor");
  }
  return moved;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> MeshWarp::Apply(vtkDataObject* data, ViewerMessages& messages) const
{
  if (this->Array.empty())
  {
    return data;
  }
  vtkNew<vtkMultiBlockDataSet> moved;
  unsigned int number = 0;
  int missing = 0;
  for (const ResultBlock& block : GetBlocks(data))
  {
    const bool hasVectors = HasVectors(block.Data, this->Array);
    missing += !hasVectors && block.Data->GetNumberOfPoints() > 0 ? 1 : 0;
    moved->SetBlock(number, hasVectors ? Move(block.Data, *this, messages) : block.Data);
    if (!block.Name.empty())
    {
      moved->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), block.Name.c_str());
    }
    ++number;
  }
  if (missing == static_cast<int>(number))
  {
    throw ViewerError("--warp: there is no array of points '" + this->Array + "'");
  }
  if (missing > 0)
  {
    messages.Warn(std::to_string(missing) + " of " + std::to_string(number) +
      " blocks have no array of points '" + this->Array + "', so they are not moved");
  }
  if (number == 1)
  {
    return moved->GetBlock(0);
  }
  return moved.Get();
}
