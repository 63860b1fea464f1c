// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LeafConversion.h"

#include "Composite/DataLeaves.h"
#include "FacePolygons.h"
#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <map>

namespace relevo
{
namespace
{
// The original ids have these names while PlainGeometry adds its own.
constexpr const char* HeldCellIds = "relevo::HeldCellIds";
constexpr const char* HeldPointIds = "relevo::HeldPointIds";

void MoveArray(vtkDataSetAttributes* data, const char* from, const char* to)
{
  const vtkSmartPointer<vtkAbstractArray> array = data->GetAbstractArray(from);
  if (array)
  {
    data->RemoveArray(from);
    auto renamed = vtk::TakeSmartPointer(array->NewInstance());
    renamed->DeepCopy(array);
    renamed->SetName(to);
    data->AddArray(renamed);
  }
}

vtkSmartPointer<vtkDataObject> Convert(vtkDataObject* input, const LeafConverter& convert)
{
  std::map<unsigned int, vtkSmartPointer<vtkDataObject>> converted; // by flat index
  for (const DataLeaf& leaf : FindDataLeaves(input))
  {
    const vtkSmartPointer<vtkDataObject> made = convert(leaf);
    converted[leaf.FlatIndex] = made;
    auto mesh = made != leaf.Data ? vtkPolyData::SafeDownCast(made) : nullptr;
    if (mesh)
    {
      MoveArray(mesh->GetCellData(), OriginalCellIdsName, HeldCellIds);
      MoveArray(mesh->GetPointData(), OriginalPointIdsName, HeldPointIds);
    }
  }
  auto composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return converted.empty() ? input : converted.begin()->second.Get();
  }
  return ReplaceLeaves(composite,
    [&converted](unsigned int index)
    { return converted.count(index) ? converted[index].Get() : nullptr; });
}
}

int RequestConverted(vtkInformationVector** inputs, vtkInformationVector* outputs,
  const LeafConverter& convert, const std::function<int(vtkInformationVector**)>& request)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  if (!input || input->IsA("vtkUniformGridAMR") || input->IsA("vtkHyperTreeGrid"))
  {
    return request(inputs);
  }
  vtkNew<vtkInformation> info;
  info->Copy(inputs[0]->GetInformationObject(0));
  info->Set(vtkDataObject::DATA_OBJECT(), Convert(input, convert));
  vtkNew<vtkInformationVector> port;
  port->Append(info);
  vtkInformationVector* ports[] = { port };
  const int result = request(ports);
  for (const DataLeaf& leaf : FindDataLeaves(vtkDataObject::GetData(outputs)))
  {
    if (auto mesh = vtkPolyData::SafeDownCast(leaf.Data))
    {
      MoveArray(mesh->GetCellData(), HeldCellIds, OriginalCellIdsName);
      MoveArray(mesh->GetPointData(), HeldPointIds, OriginalPointIdsName);
    }
  }
  return result;
}
}
