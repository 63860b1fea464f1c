// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/DataCode.h"

#include "Code/DataChain.h"
#include "Code/SameData.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkArrayQuantityFilter.h"
#include "vtkCellData.h"
#include "vtkCreaseNormals.h"
#include "vtkDataSet.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

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
void SaveData(SceneCode& code, vtkDataObject* data, const std::string& name)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set)
  {
    throw ViewerError("a program cannot draw a volume of several blocks; save a session");
  }
  code.Note("The data as relevo-view has prepared them, saved beside this program.");
  const std::string fileName = code.AddData(set, name);
  static const std::string kinds[] = { "vti", "vtp", "vtr", "vts", "vtu" };
  static const std::string classes[] = { "ImageData", "PolyData", "RectilinearGrid",
    "StructuredGrid", "UnstructuredGrid" };
  for (int i = 0; i < 5; ++i)
  {
    if (fileName.substr(fileName.size() - 3) == kinds[i])
    {
      const std::string reader = code.New("vtkXML" + classes[i] + "Reader", "reader");
      code.Call(reader, "SetFileName", { CodeValue::File(fileName) });
      code.Remember(data, CodeValue::Port(reader));
      return;
    }
  }
  throw ViewerError("a program cannot have data of the class " + std::string(set->GetClassName()));
}
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
  SaveData(code, data, "data");
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
    SaveData(code, surface, "mesh");
    if (cells)
    {
      SaveData(code, cells, "cells");
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
