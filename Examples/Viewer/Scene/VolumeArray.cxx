// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeArray.h"

#include "Legend/ArrayUnit.h"
#include "Options/ViewerOptions.h"
#include "Text/ViewerMessages.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace
{
const std::size_t Parts = 10; // between quantiles

// Point data of all blocks, then their cell data.
std::vector<std::vector<vtkDataSetAttributes*>> GetAttributes(vtkDataObject* data)
{
  std::vector<std::vector<vtkDataSetAttributes*>> attributes(2);
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    attributes[0].push_back(block->GetPointData());
    attributes[1].push_back(block->GetCellData());
  }
  return attributes;
}

// Names of numeric arrays, without ids and ghost flags.
std::vector<std::string> GetNames(const std::vector<vtkDataSetAttributes*>& blocks)
{
  std::vector<std::string> names;
  for (vtkDataSetAttributes* block : blocks)
  {
    for (int i = 0; i < block->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = block->GetArray(i);
      const bool isShown = array && array->GetName() && array != block->GetGlobalIds() &&
        array != block->GetPedigreeIds() &&
        array->GetName() != std::string(vtkDataSetAttributes::GhostArrayName());
      if (isShown && std::find(names.begin(), names.end(), array->GetName()) == names.end())
      {
        names.emplace_back(array->GetName());
      }
    }
  }
  return names;
}

// "'a', 'b'"
std::string ListNames(const std::vector<std::vector<vtkDataSetAttributes*>>& attributes)
{
  std::string list;
  for (const auto& blocks : attributes)
  {
    for (const std::string& name : GetNames(blocks))
    {
      list += (list.empty() ? "'" : ", '") + name + "'";
    }
  }
  return list;
}

bool HasArray(const std::vector<vtkDataSetAttributes*>& blocks, const std::string& name)
{
  return std::any_of(blocks.begin(), blocks.end(),
    [&](vtkDataSetAttributes* block) { return block->GetArray(name.c_str()) != nullptr; });
}

// The name of the active scalars, or an empty string. Unnamed scalars get a name.
std::string GetActiveScalars(const std::vector<vtkDataSetAttributes*>& blocks)
{
  for (vtkDataSetAttributes* block : blocks)
  {
    if (vtkDataArray* scalars = block->GetScalars())
    {
      if (!scalars->GetName())
      {
        scalars->SetName("Scalars");
      }
      return scalars->GetName();
    }
  }
  return "";
}

void AddSample(vtkDataArray* array, std::vector<double>& sample)
{
  const vtkIdType most = 20000;
  const vtkIdType number = array->GetNumberOfTuples();
  const vtkIdType step = number / most + 1;
  std::vector<double> tuple(array->GetNumberOfComponents());
  for (vtkIdType i = 0; i < number; i += step)
  {
    array->GetTuple(i, tuple.data());
    const double squares = std::inner_product(tuple.begin(), tuple.end(), tuple.begin(), 0.0);
    const double value = tuple.size() > 1 ? std::sqrt(squares) : tuple[0];
    if (std::isfinite(value))
    {
      sample.push_back(value);
    }
  }
}

// The values that are drawn: all point values, or those of 3D cells.
vtkSmartPointer<vtkDataArray> TakeDrawn(vtkDataSet* block, vtkDataArray* values, bool isOfPoints)
{
  vtkNew<vtkIdList> drawn;
  for (vtkIdType cell = 0; !isOfPoints && cell < block->GetNumberOfCells(); ++cell)
  {
    if (cell < values->GetNumberOfTuples() && IsVolumeCell(block, cell))
    {
      drawn->InsertNextId(cell);
    }
  }
  if (isOfPoints || drawn->GetNumberOfIds() == values->GetNumberOfTuples())
  {
    return values;
  }
  auto taken = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
  taken->SetNumberOfComponents(values->GetNumberOfComponents());
  taken->SetNumberOfTuples(drawn->GetNumberOfIds());
  values->GetTuples(drawn, taken);
  return taken;
}

void GetRange(vtkDataObject* data, VolumeArray& array)
{
  array.IsVector = false;
  array.Range[0] = VTK_DOUBLE_MAX;
  array.Range[1] = -VTK_DOUBLE_MAX;
  std::vector<double> sample;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    vtkDataSetAttributes* attributes =
      block->GetAttributes(array.IsOfPoints ? vtkDataObject::FIELD_ASSOCIATION_POINTS
                                            : vtkDataObject::FIELD_ASSOCIATION_CELLS);
    if (vtkDataArray* all = attributes->GetArray(array.Name.c_str()))
    {
      array.IsVector = all->GetNumberOfComponents() > 1;
      array.Unit = array.Unit.empty() ? GetArrayUnit(all) : array.Unit;
      const auto values = TakeDrawn(block, all, array.IsOfPoints);
      if (values->GetNumberOfTuples() == 0)
      {
        continue;
      }
      double range[2];
      values->GetFiniteRange(range, array.IsVector ? -1 : 0);
      array.Range[0] = std::min(array.Range[0], range[0]);
      array.Range[1] = std::max(array.Range[1], range[1]);
      AddSample(values, sample);
    }
  }
  std::sort(sample.begin(), sample.end());
  for (std::size_t i = 0; i <= Parts && !sample.empty(); ++i)
  {
    array.Quantiles.push_back(sample[i * (sample.size() - 1) / Parts]);
  }
  if (!(array.Range[0] < array.Range[1]))
  {
    // For a constant or without finite values, takes a range of representable numbers around the
    // value.
    const double middle = array.Range[0] == array.Range[1] ? array.Range[0] : 0.0;
    const double reach = std::max(1e-3 * std::abs(middle), 1e-6);
    array.Range[0] = middle - reach;
    array.Range[1] = middle + reach;
  }
}
}

//------------------------------------------------------------------------------
bool IsVolumeCell(vtkDataSet* block, vtkIdType cell)
{
  static std::map<int, bool> ofTypes;
  const int type = block->GetCellType(cell);
  const auto known = ofTypes.find(type);
  if (known != ofTypes.end())
  {
    return known->second;
  }
  const auto instance = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return ofTypes[type] = instance && instance->GetCellDimension() == 3;
}

//------------------------------------------------------------------------------
VolumeArray FindVolumeArray(const ViewerOptions& options, vtkDataObject* data)
{
  const auto attributes = GetAttributes(data);
  for (int pass = 0; pass < 2; ++pass)
  {
    for (const auto& blocks : attributes)
    {
      std::string name = options.VolumeArray;
      if (name.empty())
      {
        const auto names = GetNames(blocks);
        name = pass == 0 ? GetActiveScalars(blocks) : names.empty() ? "" : names.front();
      }
      if (!name.empty() && HasArray(blocks, name))
      {
        VolumeArray array;
        array.Name = name;
        array.IsOfPoints = &blocks == &attributes.front();
        GetRange(data, array);
        return array;
      }
    }
  }
  const std::string list = ListNames(attributes);
  throw ViewerError(options.Input + " has no array of numbers" +
    (options.VolumeArray.empty() ? "" : " '" + options.VolumeArray + "'") +
    (list.empty() ? " to show" : "; its arrays are " + list));
}
