// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/RecipeCode.h"

#include "Code/ObjectCode.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkAdaptiveRefinement.h"
#include "vtkCompositeDepthTagMetric.h"
#include "vtkControlNetDepthTagMetric.h"
#include "vtkCurvatureDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkDistanceDepthTagMetric.h"
#include "vtkFieldVariationDepthTagMetric.h"
#include "vtkG1Surface.h"
#include "vtkHeightErrorDepthTagMetric.h"
#include "vtkHeightMap.h"
#include "vtkLinearSurface.h"
#include "vtkMicroMeshErrorDepthTagMetric.h"
#include "vtkMicroMeshSurface.h"
#include "vtkPNTriangleSurface.h"
#include "vtkPatchErrorDepthTagMetric.h"
#include "vtkPatchSurface.h"
#include "vtkPhongSurface.h"
#include "vtkProceduralSurface.h"
#include "vtkRegionDepthTagMetric.h"
#include "vtkScalarTaggedSurface.h"
#include "vtkScreenEdgeDepthTagMetric.h"
#include "vtkSilhouetteDepthTagMetric.h"
#include "vtkSphere.h"
#include "vtkViewDependentDepthTagMetric.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using Writer = std::function<std::string(SceneCode&, vtkObject*)>;

// Writes objects of a class by a function that gets their variable.
template <typename Object>
Writer MakeWriter(const std::string& name,
  const std::function<void(SceneCode&, const std::string&, Object*)>& write = nullptr)
{
  return [=](SceneCode& code, vtkObject* object)
  {
    auto* known = Object::SafeDownCast(object);
    if (!known || std::string(known->GetClassName()) != vtkNew<Object>()->GetClassName())
    {
      return std::string();
    }
    const std::string variable = code.New(known->GetClassName(), name);
    if (write)
    {
      write(code, variable, known);
    }
    return variable;
  };
}

// The first writer that knows the class writes the object.
std::string WriteObject(SceneCode& code, vtkObject* object, const std::vector<Writer>& writers)
{
  for (const Writer& writer : writers)
  {
    const std::string variable = writer(code, object);
    if (!variable.empty())
    {
      return variable;
    }
  }
  throw ViewerError("a program cannot have a " + std::string(object->GetClassName()));
}

std::string AddMetricCode(SceneCode& code, vtkDepthTagMetric* metric);

void AddRegion(SceneCode& code, const std::string& variable, vtkRegionDepthTagMetric* metric)
{
  vtkImplicitFunction* function = metric->GetImplicitFunction();
  if (auto* sphere = vtkSphere::SafeDownCast(function))
  {
    const std::string region = code.New("vtkSphere", "region");
    const double* centre = sphere->GetCenter();
    code.Call(region, "SetCenter", { centre[0], centre[1], centre[2] });
    code.Call(region, "SetRadius", { sphere->GetRadius() });
    code.Call(variable, "SetImplicitFunction", { CodeValue::Object(region) });
  }
  else
  {
    throw ViewerError("a program can have a sphere as the region only");
  }
  code.Call(variable, "SetFallOff", { metric->GetFallOff() });
}

void AddComposite(SceneCode& code, const std::string& variable, vtkCompositeDepthTagMetric* metric)
{
  AddSetting(code, variable, metric, "Mode", &vtkCompositeDepthTagMetric::GetMode);
  for (int i = 0; i < metric->GetNumberOfMetrics(); ++i)
  {
    const std::string part = AddMetricCode(code, metric->GetMetric(i));
    code.Call(variable, "AddMetric", { CodeValue::Object(part) });
  }
}

template <typename Metric>
void AddFaceError(SceneCode& code, const std::string& variable, Metric* metric)
{
  AddSetting(code, variable, metric, "ScreenSpaceError", &Metric::GetScreenSpaceError);
  AddSetting(code, variable, metric, "MaximumError", &Metric::GetMaximumError);
}

std::string AddMetricCode(SceneCode& code, vtkDepthTagMetric* metric)
{
  using Code = SceneCode;
  using Name = std::string;
  const Name name = "metric";
  return WriteObject(code, metric,
    { MakeWriter<vtkScreenEdgeDepthTagMetric>(name,
        [](Code& to, const Name& variable, vtkScreenEdgeDepthTagMetric* edges)
        {
          to.Call(variable, "SetReferenceLength", { edges->GetReferenceLength() });
          if (edges->GetMeasure() == vtkScreenEdgeDepthTagMetric::SPHERE_DIAMETER)
          {
            to.Call(variable, "SetMeasureToSphereDiameter");
          }
        }),
      MakeWriter<vtkDistanceDepthTagMetric>(name,
        [](Code& to, const Name& variable, vtkDistanceDepthTagMetric* distance)
        { to.Call(variable, "SetMaximumDistance", { distance->GetMaximumDistance() }); }),
      MakeWriter<vtkCurvatureDepthTagMetric>(name,
        [](Code& to, const Name& variable, vtkCurvatureDepthTagMetric*)
        { to.Call(variable, "SetCurvatureTypeToMean"); }),
      MakeWriter<vtkSilhouetteDepthTagMetric>(name,
        [](Code& to, const Name& variable, vtkSilhouetteDepthTagMetric* silhouette)
        {
          to.Call(variable,
            silhouette->GetCriterion() == vtkSilhouetteDepthTagMetric::CONTOUR
              ? "SetCriterionToContour"
              : "SetCriterionToNormalAngle");
        }),
      MakeWriter<vtkFieldVariationDepthTagMetric>(name,
        [](Code& to, const Name& variable, vtkFieldVariationDepthTagMetric* field)
        { to.Call(variable, "SetArrayName", { field->GetArrayName() }); }),
      MakeWriter<vtkHeightErrorDepthTagMetric>(name, AddFaceError<vtkHeightErrorDepthTagMetric>),
      MakeWriter<vtkMicroMeshErrorDepthTagMetric>(
        name, AddFaceError<vtkMicroMeshErrorDepthTagMetric>),
      MakeWriter<vtkPatchErrorDepthTagMetric>(name,
        [](Code& to, const Name& variable, vtkPatchErrorDepthTagMetric* error)
        { to.Call(variable, "SetScreenSpaceError", { error->GetScreenSpaceError() }); }),
      MakeWriter<vtkRegionDepthTagMetric>(name, AddRegion),
      MakeWriter<vtkCompositeDepthTagMetric>(name, AddComposite),
      MakeWriter<vtkControlNetDepthTagMetric>(name),
      MakeWriter<vtkViewDependentDepthTagMetric>(name) });
}

std::string AddSurfaceCode(SceneCode& code, vtkRefinementSurface* surface)
{
  const std::string name = "surface";
  return WriteObject(code, surface,
    { MakeWriter<vtkLinearSurface>(name), MakeWriter<vtkPNTriangleSurface>(name),
      MakeWriter<vtkPhongSurface>(name,
        [](SceneCode& to, const std::string& variable, vtkPhongSurface* phong)
        { to.Call(variable, "SetAlpha", { phong->GetAlpha() }); }),
      MakeWriter<vtkScalarTaggedSurface>(name),
      MakeWriter<vtkProceduralSurface>(name,
        [](SceneCode& to, const std::string& variable, vtkProceduralSurface* fur)
        {
          to.Call(variable, "SetAmplitude", { fur->GetAmplitude() });
          to.Call(variable, "SetFrequency", { fur->GetFrequency() });
        }),
      MakeWriter<vtkG1Surface>(name), MakeWriter<vtkMicroMeshSurface>(name),
      MakeWriter<vtkPatchSurface>(name) });
}

std::string AddDisplacementCode(SceneCode& code, vtkDisplacement* displacement)
{
  auto* heights = vtkHeightMap::SafeDownCast(displacement->GetHeightMap());
  if (!heights || !heights->GetFileName())
  {
    throw ViewerError("a program needs the heights of a displacement as a file");
  }
  const std::string map = code.New("vtkHeightMap", "heights");
  code.Call(map, "SetFileName", { code.GetFile(heights->GetFileName()) });
  AddSetting(code, map, heights, "MaximumDimension", &vtkHeightMap::GetMaximumDimension);
  const double noData = heights->GetNoDataValue(); // that of the file or the option, or NaN
  if (std::isfinite(noData))
  {
    code.Call(map, "SetNoDataValue", { noData });
  }
  code.Call(map, "Update");
  const std::string variable = code.New("vtkDisplacement", "displacement");
  code.Call(variable, "SetHeightMap", { CodeValue::Object(map) });
  code.Call(variable, "SetScale", { displacement->GetScale() });
  code.Call(variable, "SetOffset", { displacement->GetOffset() });
  if (!displacement->IsAlongNormal())
  {
    const double* direction = displacement->GetDirection();
    code.Call(variable, "SetDirection", { direction[0], direction[1], direction[2] });
  }
  if (displacement->GetNoDataPolicy() == vtkDisplacement::FILL)
  {
    code.Call(variable, "SetNoDataPolicyToFill");
  }
  return variable;
}
}

//------------------------------------------------------------------------------
CodeValue AddRecipeCode(SceneCode& code, vtkAdaptiveRefinement* recipe)
{
  if (const auto known = code.Find(recipe))
  {
    return *known;
  }
  code.Note("Which levels edges have, and which surface the refined points are on.");
  const std::string variable = code.New("vtkAdaptiveRefinement", "recipe");
  code.Call(variable, "SetMaximumLevel", { recipe->GetMaximumLevel() });
  if (recipe->GetMetric())
  {
    const std::string metric = AddMetricCode(code, recipe->GetMetric());
    code.Call(variable, "SetMetric", { CodeValue::Object(metric) });
  }
  const vtkNew<vtkAdaptiveRefinement> standard;
  if (recipe->GetLevelRule() != standard->GetLevelRule())
  {
    code.Call(variable, "SetLevelRuleToPerEdge");
  }
  if (recipe->GetSegmentPolicy() != standard->GetSegmentPolicy())
  {
    code.Call(variable, "SetSegmentPolicyToWholeNumbers");
  }
  if (recipe->GetGeomorphing() == vtkAdaptiveRefinement::GEOMORPHING_OFF)
  {
    code.Call(variable, "GeomorphingOff");
  }
  if (recipe->GetSurface())
  {
    const std::string surface = AddSurfaceCode(code, recipe->GetSurface());
    code.Call(variable, "SetSurface", { CodeValue::Object(surface) });
  }
  if (recipe->GetDisplacement())
  {
    const std::string displacement = AddDisplacementCode(code, recipe->GetDisplacement());
    code.Call(variable, "SetDisplacement", { CodeValue::Object(displacement) });
  }
  code.Remember(recipe, CodeValue::Object(variable));
  return CodeValue::Object(variable);
}
