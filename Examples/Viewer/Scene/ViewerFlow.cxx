// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerFlow.h"

#include "Options/ViewerOptions.h"
#include "Text/ViewerMessages.h"

#include "vtkAdaptiveLICMapper.h"
#include "vtkAdaptivePatchMapper.h"
#include "vtkCellData.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkDataArray.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkLICSettings.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScreenEdgeDepthTagMetric.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
const double LongestSide = 10.0; // pixels
const double Brightness = 0.3;   // for multiplied streaks, whose mean is at most 0.4

bool HasVectors(vtkDataArray* array)
{
  return array && (array->GetNumberOfComponents() == 2 || array->GetNumberOfComponents() == 3);
}

// Returns false for missing data. A missing third component is 0.
bool GetVector(vtkDataArray* vectors, vtkIdType i, double noData, double vector[3])
{
  vector[2] = 0.0;
  vectors->GetTuple(i, vector);
  return std::all_of(vector, vector + 3, [=](double c) { return std::abs(c) < noData; });
}

// "'a', 'b'"
std::string ListVectors(vtkPolyData* mesh)
{
  std::string list;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      const bool isFlow = HasVectors(array) && array->GetName() && array != data->GetNormals() &&
        array != data->GetTCoords();
      list += isFlow ? (list.empty() ? "'" : ", '") + std::string(array->GetName()) + "'" : "";
    }
  }
  return list;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAdaptiveRefinementMapper> MakeMapper(const ViewerOptions& options)
{
  if (options.Vectors.empty())
  {
    return vtkSmartPointer<vtkAdaptivePatchMapper>::New(); // also draws meshes without patches
  }
  vtkNew<vtkAdaptiveLICMapper> mapper;
  UpdateStreaks(options, mapper);
  return mapper.Get();
}

//------------------------------------------------------------------------------
void UpdateStreaks(const ViewerOptions& options, vtkAdaptiveRefinementMapper* mapper)
{
  vtkLICSettings* lic = vtkAdaptiveLICMapper::SafeDownCast(mapper)->GetLICInterface();
  const vtkNew<vtkAdaptiveLICMapper> other;
  vtkLICSettings* defaults = other->GetLICInterface();
  lic->SetNumberOfSteps(options.LICSteps.value_or(defaults->GetNumberOfSteps()));
  lic->SetStepSize(options.LICStepSize.value_or(defaults->GetStepSize()));
  lic->SetEnhanceContrast(options.LICContrast.value_or(defaults->GetEnhanceContrast()));
  lic->SetColorMode(options.LICMode.value_or(defaults->GetColorMode()));
  lic->SetMapModeBias(Brightness);
  lic->SetLICIntensity(options.LICIntensity.value_or(defaults->GetLICIntensity()));
  lic->SetPhase(options.LICPhase);
}

//------------------------------------------------------------------------------
vtkDataArray* FindVectors(const ViewerOptions& options, vtkPolyData* mesh, bool& isOfPoints)
{
  const char* name = options.Vectors.c_str();
  vtkDataArray* ofPoints = mesh->GetPointData()->GetArray(name);
  vtkDataArray* ofCells = mesh->GetCellData()->GetArray(name);
  isOfPoints = HasVectors(ofPoints);
  if (isOfPoints || HasVectors(ofCells))
  {
    return isOfPoints ? ofPoints : ofCells;
  }
  const std::string list = ListVectors(mesh);
  vtkDataArray* other = ofPoints ? ofPoints : ofCells;
  throw ViewerError(options.Input +
    (other ? ": the array '" + options.Vectors + "' has " +
          std::to_string(other->GetNumberOfComponents()) + " components, not 2 or 3"
           : " has no array '" + options.Vectors + "'") +
    (list.empty() ? "; it has no arrays of 2 or 3 components" : "; its vectors are " + list));
}

//------------------------------------------------------------------------------
void SetVectorArray(vtkAdaptiveRefinementMapper* mapper, vtkDataArray* vectors, bool isOfPoints)
{
  mapper->SetInputArrayToProcess(0, 0, 0,
    isOfPoints ? vtkDataObject::FIELD_ASSOCIATION_POINTS : vtkDataObject::FIELD_ASSOCIATION_CELLS,
    vectors->GetName());
}

//------------------------------------------------------------------------------
void MarkNoData(vtkDataArray* vectors)
{
  if (vectors->GetDataType() != VTK_FLOAT && vectors->GetDataType() != VTK_DOUBLE)
  {
    return;
  }
  const double noData = vtkNew<vtkLICSettings>()->GetNoDataMagnitude();
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double vector[3];
    if (!GetVector(vectors, i, noData, vector))
    {
      for (int c = 0; c < vectors->GetNumberOfComponents(); ++c)
      {
        vectors->SetComponent(i, c, vtkMath::Nan());
      }
    }
  }
}

//------------------------------------------------------------------------------
void GetLengthRange(vtkDataArray* vectors, double range[2])
{
  const double noData = vtkNew<vtkLICSettings>()->GetNoDataMagnitude();
  range[0] = VTK_DOUBLE_MAX;
  range[1] = 0.0;
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double vector[3];
    if (GetVector(vectors, i, noData, vector))
    {
      const double length = std::hypot(vector[0], vector[1], vector[2]);
      range[0] = std::min(range[0], length);
      range[1] = std::max(range[1], length);
    }
  }
  range[0] = std::min(range[0], range[1]);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDepthTagMetric> MakeFlowMetric(const ViewerOptions& options)
{
  vtkNew<vtkFieldVariationDepthTagMetric> variation;
  variation->SetArrayName(options.Vectors.c_str());
  vtkNew<vtkScreenEdgeDepthTagMetric> length;
  length->SetReferenceLength(options.Pixels.value_or(LongestSide));
  length->SetMeasureToSphereDiameter();
  vtkNew<vtkCompositeDepthTagMetric> metric;
  metric->SetModeToMaximum();
  metric->AddMetric(variation);
  metric->AddMetric(length);
  return metric.Get();
}
