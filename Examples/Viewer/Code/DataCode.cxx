// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/DataCode.h"

#include "Code/DataChain.h"
#include "Code/SameData.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkArrayQuantityFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkCreaseNormals.h"
#include "vtkDataSet.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <map>
#include <string>
#include <vector>

namespace
{
bool HasArray(vtkDataSet* data, const std::string& name)
{
  return data->GetPointData()->HasArray(name.c_str()) ||
    data->GetCellData()->HasArray(name.c_str());
}

bool ReadData(DataChain& chain, const SceneCode& code, const DataPreparation& preparation)
{
  if (!chain.Read(preparation.Input, code))
  {
    return false;
  }
  auto* read = vtkDataSet::SafeDownCast(chain.GetOutput());
  if (read && !preparation.Quantity.empty() && !HasArray(read, preparation.Quantity))
  {
    vtkNew<vtkArrayQuantityFilter> filter;
    filter->SetQuantity(preparation.Quantity.c_str());
    chain.Add(filter, "quantity", { { "SetQuantity", { preparation.Quantity } } });
  }
  return read != nullptr;
}

void TakeSurfaceOfCells(DataChain& chain, bool hasPatches)
{
  if (hasPatches)
  {
    chain.Add(vtkNew<vtkPatchSurfaceFilter>(), "patches", {});
    return;
  }
  vtkNew<vtkGeometryFilter> filter;
  filter->PassThroughCellIdsOn();
  chain.Add(filter, "outside", { { "PassThroughCellIdsOn", {} } });
}

void SplitCreases(DataChain& chain, const std::optional<double>& angle)
{
  vtkNew<vtkCreaseNormals> filter;
  DataChain::Calls calls;
  if (angle)
  {
    filter->SetFeatureAngle(*angle);
    filter->KeepCoarseFlatOff();
    calls = { { "SetFeatureAngle", { *angle } }, { "KeepCoarseFlatOff", {} } };
  }
  chain.Add(filter, "creases", calls);
}

// Saves the data beside the program.
std::string AddReader(SceneCode& code, vtkDataSet* data, const std::string& name)
{
  static const std::map<std::string, std::string> classes = { { "vti", "ImageData" },
    { "vtp", "PolyData" }, { "vtr", "RectilinearGrid" }, { "vts", "StructuredGrid" },
    { "vtu", "UnstructuredGrid" } };
  const std::string fileName = code.AddData(data, name);
  const auto kind = classes.find(fileName.substr(fileName.size() - 3));
  if (kind == classes.end())
  {
    throw ViewerError(
      "a program cannot have data of the class " + std::string(data->GetClassName()));
  }
  const std::string reader = code.New("vtkXML" + kind->second + "Reader", "reader");
  code.Call(reader, "SetFileName", { CodeValue::File(fileName) });
  return reader;
}
}

//------------------------------------------------------------------------------
void AddSavedDataCode(SceneCode& code, vtkDataObject* data, const std::string& name)
{
  code.Note("Data as relevo-view has prepared them, saved beside this program.");
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    code.Remember(data, CodeValue::Port(AddReader(code, set, name)));
    return;
  }
  std::vector<std::string> readers;
  for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(data))
  {
    readers.push_back(AddReader(code, block, name + std::to_string(readers.size())));
  }
  const std::string group = code.New("vtkMultiBlockDataGroupFilter", "blocks");
  for (const std::string& reader : readers)
  {
    code.Call(group, "AddInputConnection", { CodeValue::Port(reader) });
  }
  code.Remember(data, CodeValue::Port(group));
}

//------------------------------------------------------------------------------
void AddImageCode(SceneCode& code, const std::string& fileName, vtkDataObject* image)
{
  DataChain chain;
  if (chain.Read(fileName, code) && AreSameData(image, chain.GetOutput()))
  {
    code.Note("The picture.");
    code.Remember(image, chain.Write(code).back());
    return;
  }
  AddSavedDataCode(code, image, "picture");
}

//------------------------------------------------------------------------------
void AddDataCode(SceneCode& code, const DataPreparation& preparation, vtkDataObject* data)
{
  DataChain chain;
  if (ReadData(chain, code, preparation) && AreSameData(data, chain.GetOutput()))
  {
    code.Note("The data.");
    code.Remember(data, chain.Write(code).back());
    return;
  }
  AddSavedDataCode(code, data, "data");
}

//------------------------------------------------------------------------------
void AddSurfaceDataCode(
  SceneCode& code, const DataPreparation& preparation, vtkPolyData* surface, vtkDataSet* cells)
{
  DataChain chain;
  bool isSame =
    ReadData(chain, code, preparation) && (!cells || AreSameData(cells, chain.GetOutput()));
  const std::size_t size = chain.GetSize();
  if (isSame)
  {
    if (!vtkPolyData::SafeDownCast(chain.GetOutput()))
    {
      TakeSurfaceOfCells(chain, preparation.HasPatches);
    }
    if (preparation.HasCreases)
    {
      SplitCreases(chain, preparation.FeatureAngle);
    }
    isSame = AreSameData(surface, chain.GetOutput());
  }
  if (!isSame)
  {
    AddSavedDataCode(code, surface, "mesh");
    if (cells)
    {
      AddSavedDataCode(code, cells, "cells");
    }
    return;
  }
  code.Note("The coarse mesh.");
  const std::vector<CodeValue> outputs = chain.Write(code);
  code.Remember(surface, outputs.back());
  if (cells)
  {
    code.Remember(cells, outputs[size - 1]);
  }
}
