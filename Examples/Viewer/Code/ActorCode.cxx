// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/ActorCode.h"

#include "Code/ColourCode.h"
#include "Code/FilterCode.h"
#include "Code/MapperCode.h"
#include "Code/ObjectCode.h"
#include "Code/SceneCode.h"
#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <vector>

namespace
{
void AddPropertyCode(SceneCode& code, const std::string& actor, vtkProperty* property)
{
  const vtkNew<vtkProperty> standard;
  const std::string variable = code.Get("vtkProperty", "property", actor, "GetProperty");
  const double* color = property->GetDiffuseColor(); // as the others; GetColor() would round it
  code.Call(variable, "SetColor", { color[0], color[1], color[2] });
  AddSetting(code, variable, property, "Ambient", &vtkProperty::GetAmbient);
  AddSetting(code, variable, property, "Diffuse", &vtkProperty::GetDiffuse);
  AddSetting(code, variable, property, "Specular", &vtkProperty::GetSpecular);
  AddSetting(code, variable, property, "SpecularPower", &vtkProperty::GetSpecularPower);
  AddSetting(code, variable, property, "Opacity", &vtkProperty::GetOpacity);
  if (property->GetInterpolation() != standard->GetInterpolation())
  {
    code.Call(variable,
      property->GetInterpolation() == VTK_PHONG ? "SetInterpolationToPhong"
                                                : "SetInterpolationToFlat");
  }
  if (property->GetRepresentation() == VTK_WIREFRAME)
  {
    code.Call(variable, "SetRepresentationToWireframe");
  }
  AddFlag(code, variable, property, "Lighting", &vtkProperty::GetLighting);
}

std::string AddTextureCode(SceneCode& code, vtkTexture* texture)
{
  const CodeValue image = AddInputCode(code, texture, "picture");
  code.Note("The picture on the surface.");
  const std::string variable = code.New("vtkTexture", "texture");
  code.Call(variable, "SetInputConnection", { image });
  code.Call(variable, "SetColorModeToDirectScalars");
  AddFlag(code, variable, texture, "Interpolate", &vtkTexture::GetInterpolate);
  AddFlag(code, variable, texture, "Mipmap", &vtkTexture::GetMipmap);
  AddFlag(code, variable, texture, "Repeat", &vtkTexture::GetRepeat);
  AddFlag(code, variable, texture, "EdgeClamp", &vtkTexture::GetEdgeClamp);
  return variable;
}

std::vector<std::vector<double>> FindOpacities(vtkPiecewiseFunction* function)
{
  std::vector<std::vector<double>> nodes;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // value, opacity, midpoint, sharpness
    function->GetNodeValue(i, node);
    nodes.push_back({ node[0], node[1] });
  }
  return nodes;
}

std::string AddVolumeMapperCode(SceneCode& code, vtkGPUUnstructuredGridVolumeMapper* mapper)
{
  using Mapper = vtkGPUUnstructuredGridVolumeMapper;
  const CodeValue input = AddInputCode(code, mapper, "data");
  code.Note("The mapper of the volume.");
  const std::string variable = code.New("vtkGPUUnstructuredGridVolumeMapper", "mapper");
  code.Call(variable, "SetInputConnection", { input });
  code.Call(variable,
    mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
      ? "SetScalarModeToUsePointFieldData"
      : "SetScalarModeToUseCellFieldData");
  code.Call(variable, "SelectScalarArray", { mapper->GetArrayName() });
  AddSetting(code, variable, mapper, "VectorMode", &Mapper::GetVectorMode);
  AddSetting(code, variable, mapper, "Method", &Mapper::GetMethod);
  AddSetting(code, variable, mapper, "BlendMode", &Mapper::GetBlendMode);
  AddSetting(code, variable, mapper, "Integration", &Mapper::GetIntegration);
  AddSetting(code, variable, mapper, "ShapeTolerance", &Mapper::GetShapeTolerance);
  AddSetting(code, variable, mapper, "FieldTolerance", &Mapper::GetFieldTolerance);
  AddFlag(code, variable, mapper, "IsoSurfaces", &Mapper::GetIsoSurfaces);
  AddClippingCode(code, variable, mapper);
  return variable;
}
}

//------------------------------------------------------------------------------
std::string AddActorCode(SceneCode& code, vtkActor* actor)
{
  const std::string mapper = AddMapperCode(code, actor->GetMapper());
  const std::string variable = code.New("vtkActor", "actor");
  code.Call(variable, "SetMapper", { CodeValue::Object(mapper) });
  AddPropertyCode(code, variable, actor->GetProperty());
  const double* position = actor->GetPosition();
  if (std::any_of(position, position + 3, [](double x) { return x != 0.0; }))
  {
    code.Call(variable, "SetPosition", { position[0], position[1], position[2] });
  }
  if (actor->GetTexture())
  {
    const CodeValue texture = CodeValue::Object(AddTextureCode(code, actor->GetTexture()));
    code.Call(variable, "SetTexture", { texture });
  }
  code.Remember(actor, CodeValue::Object(variable));
  return variable;
}

//------------------------------------------------------------------------------
std::string AddVolumeCode(SceneCode& code, vtkVolume* volume)
{
  auto* known = vtkGPUUnstructuredGridVolumeMapper::SafeDownCast(volume->GetMapper());
  if (!known)
  {
    throw ViewerError("a program cannot have this volume");
  }
  const std::string mapper = AddVolumeMapperCode(code, known);
  vtkVolumeProperty* property = volume->GetProperty();
  code.Note("The transfer function.");
  const CodeValue colours = AddColourCode(code, property->GetRGBTransferFunction());
  const std::string opacities = code.New("vtkPiecewiseFunction", "opacities");
  code.Rows(opacities, "AddPoint", FindOpacities(property->GetScalarOpacity()));
  const std::string look = code.New("vtkVolumeProperty", "property");
  code.Call(look, "SetColor", { colours });
  code.Call(look, "SetScalarOpacity", { CodeValue::Object(opacities) });
  code.Call(look, "SetScalarOpacityUnitDistance", { property->GetScalarOpacityUnitDistance() });
  code.Call(look, "SetAmbient", { property->GetAmbient() });
  if (property->GetShade())
  {
    code.Call(look, "ShadeOn");
  }
  vtkContourValues* values = property->GetIsoSurfaceValues();
  if (values->GetNumberOfContours() > 0)
  {
    const std::string surfaces =
      code.Get("vtkContourValues", "surfaces", look, "GetIsoSurfaceValues");
    for (int i = 0; i < values->GetNumberOfContours(); ++i)
    {
      code.Call(surfaces, "SetValue", { i, values->GetValue(i) });
    }
  }
  const std::string variable = code.New("vtkVolume", "volume");
  code.Call(variable, "SetMapper", { CodeValue::Object(mapper) });
  code.Call(variable, "SetProperty", { CodeValue::Object(look) });
  return variable;
}
