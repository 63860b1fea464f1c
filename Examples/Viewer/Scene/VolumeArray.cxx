// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeArray.h"

#include "Legend/ArrayUnit.h"
#include "Options/ViewerOptions.h"
#include "Text/ViewerMessages.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{
const std::size_t Parts = 10; // between quantiles

// Arrays of all blocks' points, then those of cells.
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

// Of numbers that say something: no ids, no ghosts.
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

// The name of the active scalars, "" for none; those without a name get one.
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

void GetRange(const std::vector<vtkDataSetAttributes*>& blocks, VolumeArray& array)
{
  array.IsVector = false;
  array.Range[0] = VTK_DOUBLE_MAX;
  array.Range[1] = -VTK_DOUBLE_MAX;
  std::vector<double> sample;
  for (vtkDataSetAttributes* block : blocks)
  {
    if (vtkDataArray* values = block->GetArray(array.Name.c_str()))
    {
      array.IsVector = values->GetNumberOfComponents() > 1;
      array.Unit = array.Unit.empty() ? GetArrayUnit(values) : array.Unit;
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
    // A constant, or nothing finite: a range around it that numbers of its size can have.
    const double middle = array.Range[0] == array.Range[1] ? array.Range[0] : 0.0;
    const double reach = std::max(1e-3 * std::abs(middle), 1e-6);
    array.Range[0] = middle - reach;
    array.Range[1] = middle + reach;
  }
}
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
        GetRange(blocks, array);
        return array;
      }
    }
  }
  const std::string list = ListNames(attributes);
  throw ViewerError(options.Input + " has no array of numbers" +
    (options.VolumeArray.empty() ? "" : " '" + options.VolumeArray + "'") +
    (list.empty() ? " to show" : "; its arrays are " + list));
}
