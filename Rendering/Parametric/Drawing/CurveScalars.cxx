// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CurveScalars.h"

#include "Actors/UsableArrays.h"
#include "Buffers/ColorTable.h"
#include "Buffers/CurveColors.h"
#include "Curves/CurveMesh.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

namespace relevo
{
namespace
{
// The opacity of the whole table is not used, as in VTK's mapper.
vtkSmartPointer<vtkUnsignedCharArray> MapColors(vtkMapper* mapper, vtkAbstractArray* scalars)
{
  vtkScalarsToColors* table = mapper->GetLookupTable();
  const double alpha = table->GetAlpha();
  table->SetAlpha(1.0);
  auto colors = vtk::TakeSmartPointer(
    table->MapScalars(scalars, mapper->GetColorMode(), mapper->GetArrayComponent()));
  table->SetAlpha(alpha);
  return colors;
}

bool IsDirect(vtkMapper* mapper, vtkAbstractArray* scalars)
{
  return mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mapper->GetColorMode() == VTK_COLOR_MODE_DEFAULT &&
      vtkUnsignedCharArray::SafeDownCast(scalars));
}

std::string FindError(const ScalarMapping& mapping, vtkMapper* mapper)
{
  const std::string error = FindMappingError(mapping);
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(mapping.Scalars);
  vtkScalarsToColors* table = numbers ? numbers->GetLookupTable() : nullptr;
  table = table ? table : mapper->GetLookupTable();
  const std::string unusable = ColorTable::FindError(
    table, mapper->GetUseLookupTableScalarRange() ? table->GetRange() : mapper->GetScalarRange());
  return error.empty() && !unusable.empty() ? "Cannot map scalars to colours: " + unusable + "."
                                            : error;
}
}

Dependencies GetScalarSettings(vtkMapper* mapper)
{
  Dependencies settings = Dependencies::On(mapper->GetScalarVisibility(), mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayComponent(),
    mapper->GetColorMode(), mapper->GetInterpolateScalarsBeforeMapping(),
    mapper->GetUseLookupTableScalarRange(), mapper->GetScalarRange()[0],
    mapper->GetScalarRange()[1], mapper->GetFieldDataTupleId());
  settings.Add(std::string(mapper->GetArrayName() ? mapper->GetArrayName() : ""));
  settings.AddObject(mapper->GetLookupTable());
  return settings;
}

std::string UploadScalars(vtkOpenGLRenderWindow* window, vtkMapper* mapper, vtkDataSet* input,
  const CurveMesh& curves, CurveColors& colors)
{
  colors.Clear(window);
  int cellFlag = 0;
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(input, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  if (!mapper->GetScalarVisibility() || !scalars || curves.GetNumberOfCurves() == 0)
  {
    return "";
  }
  const vtkIdType fieldTuple =
    mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_FIELD_DATA ? mapper->GetFieldDataTupleId() : -1;
  const std::string error =
    FindError({ input, scalars, cellFlag, mapper->GetColorMode(), fieldTuple }, mapper);
  if (!error.empty())
  {
    return error;
  }
  int flag = 0;
  mapper->ClearColorArrays(); // the arrays may belong to another block
  vtkUnsignedCharArray* mapped = mapper->MapScalars(input, 1.0, flag); // prepares the table
  vtkDataArray* values = vtkDataArray::SafeDownCast(scalars);
  bool valid = true;
  if (cellFlag != 0)
  {
    valid = !mapped || colors.UploadCells(window, curves, mapped);
    return valid ? "" : "Cannot draw the input: " + BufferTexture::GetTooLarge() + ".";
  }
  if (values && !IsDirect(mapper, scalars))
  {
    valid = colors.UploadValues(window, curves, values, mapper->GetLookupTable(),
      mapper->GetArrayComponent(), mapper->GetInterpolateScalarsBeforeMapping() != 0);
  }
  if (valid && colors.GetColoring() == CurveColoring::ACTOR)
  {
    valid = colors.UploadPoints(window, curves, MapColors(mapper, scalars));
  }
  return valid ? "" : "Cannot draw the input: " + BufferTexture::GetTooLarge() + ".";
}
}
