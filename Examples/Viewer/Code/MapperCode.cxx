// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/MapperCode.h"

#include "Code/ColourCode.h"
#include "Code/FilterCode.h"
#include "Code/ObjectCode.h"
#include "Code/RecipeCode.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkAdaptiveCurveMapper.h"
#include "vtkAdaptiveLICMapper.h"
#include "vtkAdaptivePatchMapper.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkLICSettings.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyDataMapper.h"
#include "vtkReliefMapper.h"
#include "vtkScalarsToColors.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <array>

namespace
{
void AddScalarCode(SceneCode& code, const std::string& variable, vtkMapper* mapper)
{
  if (!mapper->GetScalarVisibility())
  {
    code.Call(variable, "ScalarVisibilityOff");
    return;
  }
  if (mapper->GetArrayName() && *mapper->GetArrayName())
  {
    code.Call(variable,
      mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
        ? "SetScalarModeToUsePointFieldData"
        : "SetScalarModeToUseCellFieldData");
    code.Call(variable, "SelectColorArray", { mapper->GetArrayName() });
  }
  if (mapper->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS)
  {
    code.Call(variable, "SetColorModeToMapScalars");
  }
  if (mapper->GetUseLookupTableScalarRange())
  {
    code.Call(variable, "SetLookupTable", { AddColourCode(code, mapper->GetLookupTable()) });
    code.Call(variable, "UseLookupTableScalarRangeOn");
  }
  if (mapper->GetInterpolateScalarsBeforeMapping())
  {
    code.Call(variable, "InterpolateScalarsBeforeMappingOn");
  }
}

void AddStreakCode(SceneCode& code, const std::string& mapper, vtkAdaptiveLICMapper* streaks)
{
  vtkInformation* array = streaks->GetInputArrayInformation(0);
  const bool isOfPoints =
    array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  code.Call(mapper, "SetInputArrayToProcess",
    { 0, 0, 0,
      CodeValue::Constant(
        "vtkDataObject", isOfPoints ? "FIELD_ASSOCIATION_POINTS" : "FIELD_ASSOCIATION_CELLS"),
      array->Get(vtkDataObject::FIELD_NAME()) });
  vtkLICSettings* lic = streaks->GetLICInterface();
  const std::string variable = code.Get("vtkLICSettings", "lic", mapper, "GetLICInterface");
  AddSetting(code, variable, lic, "NumberOfSteps", &vtkLICSettings::GetNumberOfSteps);
  AddSetting(code, variable, lic, "StepSize", &vtkLICSettings::GetStepSize);
  AddSetting(code, variable, lic, "EnhanceContrast", &vtkLICSettings::GetEnhanceContrast);
  AddSetting(code, variable, lic, "ColorMode", &vtkLICSettings::GetColorMode);
  AddSetting(code, variable, lic, "MapModeBias", &vtkLICSettings::GetMapModeBias);
  AddSetting(code, variable, lic, "LICIntensity", &vtkLICSettings::GetLICIntensity);
  AddSetting(code, variable, lic, "Phase", &vtkLICSettings::GetPhase);
}

std::string AddRefinementCode(SceneCode& code, vtkAdaptiveRefinementMapper* mapper)
{
  static const std::array<const char*, 6> methods = { { "ARKFPI", "ARK", "DMR", "SUAPT",
    "HardwareTessellation", "Uniform" } };
  const CodeValue recipe = AddRecipeCode(code, mapper->GetRefinement());
  auto* patches = vtkAdaptivePatchMapper::SafeDownCast(mapper);
  auto* streaks = vtkAdaptiveLICMapper::SafeDownCast(mapper);
  code.Note("The mapper refines the mesh in each frame.");
  const std::string variable = code.New(mapper->GetClassName(), "mapper");
  code.Call(variable, "SetInputConnection", { AddInputCode(code, mapper, "mesh") });
  code.Call(variable, "SetRefinement", { recipe });
  code.Call(
    variable, std::string("SetMethodTo") + methods[static_cast<std::size_t>(mapper->GetMethod())]);
  if (mapper->GetTargetNumberOfTriangles() > 0)
  {
    code.Call(variable, "SetTargetNumberOfTriangles",
      { static_cast<long long>(mapper->GetTargetNumberOfTriangles()) });
  }
  AddScalarCode(code, variable, mapper);
  static const std::array<const char*, 4> modes = { { "Scalars", "Level", "Pattern", "Metric" } };
  if (mapper->GetRefinementColorMode() != 0)
  {
    code.Call(variable,
      std::string("SetColorModeTo") +
        modes[static_cast<std::size_t>(mapper->GetRefinementColorMode())]);
    const std::string table =
      code.Get("vtkScalarsToColors", "levels", variable, "GetLevelLookupTable");
    code.Remember(mapper->GetLevelLookupTable(), CodeValue::Object(table));
  }
  if (patches)
  {
    AddSetting(
      code, variable, patches, "IsolineSpacing", &vtkAdaptivePatchMapper::GetIsolineSpacing);
    AddFlag(code, variable, patches, "PatchEdges", &vtkAdaptivePatchMapper::GetPatchEdges);
  }
  if (streaks)
  {
    AddStreakCode(code, variable, streaks);
  }
  AddClippingCode(code, variable, mapper);
  return variable;
}

// The variable of the filter that cuts 3D cells.
std::string AddCurveCode(SceneCode& code, vtkAdaptiveCurveMapper* mapper)
{
  const CodeValue curves = AddInputCode(code, mapper, "curves");
  const CodeValue recipe = AddRecipeCode(code, mapper->GetRefinement());
  code.Note("The mapper draws curves.");
  const std::string variable = code.New("vtkAdaptiveCurveMapper", "mapper");
  code.Call(variable, "SetInputConnection", { curves });
  code.Call(variable, "SetRefinement", { recipe });
  AddScalarCode(code, variable, mapper);
  AddClippingCode(code, variable, mapper);
  return variable;
}

std::string AddReliefCode(SceneCode& code, vtkReliefMapper* mapper)
{
  const CodeValue reliefs = AddInputCode(code, mapper, "relief");
  code.Note("The mapper draws reliefs.");
  const std::string variable = code.New("vtkReliefMapper", "mapper");
  code.Call(variable, "SetInputConnection", { reliefs });
  AddSetting(code, variable, mapper, "Method", &vtkReliefMapper::GetMethod);
  AddSetting(code, variable, mapper, "Search", &vtkReliefMapper::GetSearch);
  return variable;
}

std::string AddPlainCode(SceneCode& code, vtkPolyDataMapper* mapper)
{
  const CodeValue input = AddInputCode(code, mapper, "surface");
  const std::string variable = code.New("vtkPolyDataMapper", "mapper");
  code.Call(variable, "SetInputConnection", { input });
  AddScalarCode(code, variable, mapper);
  AddClippingCode(code, variable, mapper);
  return variable;
}

void AddTerrainColourCode(SceneCode& code, const std::string& variable, vtkTerrainMapper* mapper)
{
  using Mapper = vtkTerrainMapper;
  switch (mapper->GetTerrainColorMode())
  {
    case Mapper::COLOR_BY_IMAGERY:
      code.Call(variable, "SetImageryFileName", { code.GetFile(mapper->GetImageryFileName()) });
      return;
    case Mapper::COLOR_BY_HILLSHADE:
      code.Call(variable, "SetColorModeToHillshade");
      return;
    case Mapper::COLOR_BY_ELEVATION:
      code.Call(variable, "SetColorModeToElevation");
      break;
    case Mapper::COLOR_BY_SLOPE:
      code.Call(variable, "SetColorModeToSlope");
      break;
    case Mapper::COLOR_BY_ASPECT:
      code.Call(variable, "SetColorModeToAspect");
      break;
    default:
      throw ViewerError("a program cannot have the colours of this terrain");
  }
  code.Call(variable, "SetLookupTable", { AddColourCode(code, mapper->GetLookupTable()) });
  if (mapper->GetUseSeaLevel())
  {
    const CodeValue water = AddColourCode(code, mapper->GetWaterLookupTable(), "water");
    code.Call(variable, "UseSeaLevelOn");
    code.Call(variable, "SetSeaLevel", { mapper->GetSeaLevel() });
    code.Call(variable, "SetWaterLookupTable", { water });
  }
  const std::string legend =
    code.Get("vtkScalarsToColors", "heights", variable, "GetLegendLookupTable");
  code.Remember(mapper->GetLegendLookupTable(), CodeValue::Object(legend));
}

std::string AddTerrainCode(SceneCode& code, vtkTerrainMapper* mapper)
{
  vtkTerrainPyramid* heights = mapper->GetPyramid();
  code.Note("The raster of heights. Its index must be complete before the error is known.");
  const std::string pyramid = code.New("vtkTerrainPyramid", "pyramid");
  code.Call(pyramid, "SetFileName", { code.GetFile(heights->GetFileName()) });
  AddSetting(code, pyramid, heights, "MemoryLimit", &vtkTerrainPyramid::GetMemoryLimit);
  code.Call(pyramid, "Update");
  code.Call(pyramid, "WaitForIndex");
  code.Note("The mapper reads the tiles that the view needs.");
  const std::string variable = code.New("vtkTerrainMapper", "mapper");
  code.Call(variable, "SetPyramid", { CodeValue::Object(pyramid) });
  code.Call(variable, "SetLoadingModeToComplete");
  code.Call(variable, "SetScreenSpaceError", { mapper->GetScreenSpaceError() });
  AddSetting(code, variable, mapper, "Exaggeration", &vtkTerrainMapper::GetExaggeration);
  AddSetting(code, variable, mapper, "MemoryLimit", &vtkTerrainMapper::GetMemoryLimit);
  if (mapper->GetFrame() == vtkTerrainMapper::GEOCENTRIC)
  {
    code.Call(variable, "SetFrameToGeocentric");
  }
  AddTerrainColourCode(code, variable, mapper);
  AddSetting(code, variable, mapper, "ContourInterval", &vtkTerrainMapper::GetContourInterval);
  if (mapper->GetUseBase())
  {
    code.Call(variable, "SetBaseHeight", { mapper->GetBaseHeight() });
    code.Call(variable, "UseBaseOn");
  }
  return variable;
}
}

//------------------------------------------------------------------------------
std::string AddMapperCode(SceneCode& code, vtkMapper* mapper)
{
  if (auto* refined = vtkAdaptiveRefinementMapper::SafeDownCast(mapper))
  {
    return AddRefinementCode(code, refined);
  }
  if (auto* terrain = vtkTerrainMapper::SafeDownCast(mapper))
  {
    return AddTerrainCode(code, terrain);
  }
  if (auto* curves = vtkAdaptiveCurveMapper::SafeDownCast(mapper))
  {
    return AddCurveCode(code, curves);
  }
  if (auto* reliefs = vtkReliefMapper::SafeDownCast(mapper))
  {
    return AddReliefCode(code, reliefs);
  }
  if (auto* plain = vtkPolyDataMapper::SafeDownCast(mapper))
  {
    return AddPlainCode(code, plain);
  }
  throw ViewerError("a program cannot have a " + std::string(mapper->GetClassName()));
}

//------------------------------------------------------------------------------
void AddClippingCode(SceneCode& code, const std::string& variable, vtkAbstractMapper* mapper)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    code.Call(variable, "AddClippingPlane", { AddPlaneCode(code, planes->GetItem(i)) });
  }
}
