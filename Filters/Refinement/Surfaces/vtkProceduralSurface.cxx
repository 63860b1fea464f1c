// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProceduralSurface.h"

#include "Checks/SettingChecks.h"
#include "Surfaces/SurfaceCorners.h"
#include "vtkLinearSurface.h"
#include "vtkObjectFactory.h"

#include "relevoFur.h"
#include "relevoHeightDifferences.h"
#include "relevoProcedural.h"
#include "relevoProceduralValues.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relevo
{
#include "glsl/relevoDisplacedNormal.glsl"

// The base surface at one point.
struct ProceduralBase : SurfaceCorners
{
#include "glsl/relevoProceduralValues.glsl"

  vec3 basePosition(vec3) const
  {
    return this->Position;
  }
  vec3 baseNormal(vec3) const
  {
    return this->Normal;
  }
  vec3 modelPosition(vec3 p) const
  {
    const double* origin = this->Face.Origin;
    return p + vec3(origin[0], origin[1], origin[2]);
  }

  vec3 Position;
  vec3 Normal;
  vtkProceduralSurface* Surface;
};

struct FurryFace : ProceduralBase
{
#include "glsl/relevoFur.glsl"

#include "glsl/relevoProcedural.glsl"
};

struct ProceduralFace : ProceduralBase
{
  float proceduralHeight(vec3 position, vec3 normal, vec3 w) const
  {
    const double p[3] = { position.x, position.y, position.z };
    return static_cast<float>(this->Surface->EvaluateHeight(p, &normal.x, &w.x));
  }

#include "glsl/relevoHeightDifferences.glsl"

#include "glsl/relevoProcedural.glsl"
};
}

namespace
{
// Both are floats in shaders. The phases of the highest frequency are in their range too.
constexpr double LargestFloat = std::numeric_limits<float>::max();
constexpr double HighestFrequency = 1e30;
}

vtkStandardNewMacro(vtkProceduralSurface);

vtkProceduralSurface::vtkProceduralSurface()
{
  this->PreparationTime.Modified();
}

vtkProceduralSurface::~vtkProceduralSurface() = default;

void vtkProceduralSurface::SetAmplitude(double amplitude)
{
  relevo::SetInRange(this, "Amplitude", this->Amplitude, amplitude, -LargestFloat, LargestFloat);
}

void vtkProceduralSurface::SetFrequency(double frequency)
{
  relevo::SetInRange(
    this, "Frequency", this->Frequency, frequency, -HighestFrequency, HighestFrequency);
}

void vtkProceduralSurface::SetBaseSurface(vtkRefinementSurface* surface)
{
  if (vtkProceduralSurface::SafeDownCast(surface))
  {
    vtkErrorMacro("BaseSurface must not be a vtkProceduralSurface.");
  }
  else if (this->BaseSurface != surface)
  {
    this->BaseSurface = surface;
    this->Modified();
    this->PreparationTime.Modified();
  }
}

vtkRefinementSurface* vtkProceduralSurface::GetBaseSurface()
{
  return this->BaseSurface;
}

vtkRefinementSurface* vtkProceduralSurface::GetBase()
{
  return this->BaseSurface ? this->BaseSurface.Get() : this->Linear.Get();
}

void vtkProceduralSurface::SetShaderFunction(const char* source)
{
  const std::string value = source ? source : "";
  if (this->ShaderFunction != value)
  {
    this->ShaderFunction = value;
    this->Modified();
    this->PreparationTime.Modified();
  }
}

const char* vtkProceduralSurface::GetShaderFunction()
{
  return this->ShaderFunction.c_str();
}

void vtkProceduralSurface::SetUniform(const char* name, double value)
{
  this->SetUniformValues(name, { value });
}

void vtkProceduralSurface::SetUniform(const char* name, double x, double y, double z)
{
  this->SetUniformValues(name, { x, y, z });
}

void vtkProceduralSurface::SetUniformValues(const char* name, const std::vector<double>& values)
{
  if (!name || !*name)
  {
    vtkErrorMacro("The name of a uniform must not be empty.");
    return;
  }
  if (!std::all_of(values.begin(), values.end(),
        [](double v) { return std::isfinite(static_cast<float>(v)); }))
  {
    vtkErrorMacro("Uniform \"" << name << "\" must be finite and in the range of floats.");
    return;
  }
  const std::vector<float> floats(values.begin(), values.end());
  std::vector<float>& current = this->Uniforms[name];
  if (current != floats)
  {
    current = floats;
    this->Modified();
  }
}

void vtkProceduralSurface::RemoveAllUniforms()
{
  if (!this->Uniforms.empty())
  {
    this->Uniforms.clear();
    this->Modified();
  }
}

double vtkProceduralSurface::EvaluateHeight(const double[3], const float[3], const float[3])
{
  return 0.0;
}

double vtkProceduralSurface::GetReach()
{
  return this->GetBase()->GetReach() + std::abs(this->Amplitude);
}

vtkMTimeType vtkProceduralSurface::GetPreparationMTime()
{
  return std::max(this->PreparationTime.GetMTime(), this->GetBase()->GetPreparationMTime());
}

vtkMTimeType vtkProceduralSurface::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->GetBase()->GetMTime());
}

bool vtkProceduralSurface::GetPointValues(vtkPolyData* mesh, float* values, std::string& error)
{
  return this->GetBase()->GetPointValues(mesh, values, error);
}

void vtkProceduralSurface::ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors)
{
  this->GetBase()->ComputeEdgeVectors(a, b, vectors);
}

void vtkProceduralSurface::ComputeFaceVectors(
  const Face& face, float* vectors, float* edgeNormals[3])
{
  this->GetBase()->ComputeFaceVectors(face, vectors, edgeNormals);
}

bool vtkProceduralSurface::SplitsNormals(const Face& face)
{
  return this->GetBase()->SplitsNormals(face);
}

void vtkProceduralSurface::Evaluate(
  const Face& face, const float weights[3], float position[3], float normal[3])
{
  this->GetBase()->Evaluate(face, weights, position, normal);
  using relevo::SurfaceCorners;
  const relevo::ProceduralBase base{ { face, 0 }, static_cast<float>(this->Amplitude),
    static_cast<float>(this->Frequency), SurfaceCorners::Load(position),
    SurfaceCorners::Load(normal), this };
  const auto evaluate = [&](auto moved)
  {
    const glm::vec3 w = SurfaceCorners::Load(weights);
    relevo::store(moved.surfacePosition(w), position);
    relevo::store(moved.surfaceNormal(w), normal);
  };
  if (this->ShaderFunction.empty())
  {
    evaluate(relevo::FurryFace{ base });
  }
  else
  {
    evaluate(relevo::ProceduralFace{ base });
  }
}

std::string vtkProceduralSurface::GetEvaluationError()
{
  return this->HasHeightFunction() ? this->GetBase()->GetEvaluationError()
                                   : "the procedural surface's ShaderFunction is GLSL, which only "
                                     "vtkAdaptiveRefinementMapper can run; override "
                                     "EvaluateHeight() in C++";
}

std::string vtkProceduralSurface::GetShaderSource()
{
  std::string source = relevoProceduralValues;
  source += "#define surfacePosition basePosition\n#define surfaceNormal baseNormal\n";
  source += this->GetBase()->GetShaderSource();
  source += "#undef surfacePosition\n#undef surfaceNormal\n";
  if (this->ShaderFunction.empty())
  {
    source += relevoFur;
  }
  else
  {
    source += this->ShaderFunction + "\n" + relevoHeightDifferences;
  }
  return source + relevoProcedural;
}

std::vector<vtkRefinementSurface::Uniform> vtkProceduralSurface::GetUniforms()
{
  std::vector<Uniform> uniforms = this->GetBase()->GetUniforms();
  uniforms.push_back({ "relevoAmplitude", { static_cast<float>(this->Amplitude) } });
  uniforms.push_back({ "relevoFrequency", { static_cast<float>(this->Frequency) } });
  for (const auto& entry : this->Uniforms)
  {
    uniforms.push_back({ entry.first, entry.second });
  }
  return uniforms;
}

void vtkProceduralSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Amplitude: " << this->Amplitude << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "BaseSurface: " << this->BaseSurface.Get() << "\n";
  os << indent << "ShaderFunction: " << this->ShaderFunction << "\n";
  for (const auto& entry : this->Uniforms)
  {
    os << indent << "Uniform " << entry.first << ":";
    for (float value : entry.second)
    {
      os << " " << value;
    }
    os << "\n";
  }
}
