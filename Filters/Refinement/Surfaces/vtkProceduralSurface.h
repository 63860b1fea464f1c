// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkProceduralSurface
 * @brief   a surface moved along its normals by a function: fur, or one of your own
 *
 * The point is V = B + Amplitude h N: B is the base surface's point, N the sum of the corners' unit
 * normals by the barycentric weights, not made unit, and h a height in [-1, 1]. By default h is the
 * fur of Lenz 2009 (fig. 5.14): g sin(u f pi) sin(v f pi) sin(w f pi), f the Frequency, u, v, w the
 * weights and g the mean cosine between the corners' normals. Shading normals follow the heights.
 *
 * SetShaderFunction() takes GLSL for another h:
 *
 *   surface.SetShaderFunction("""
 *     uniform float time;
 *     float proceduralHeight(vec3 position, vec3 normal, vec3 weights)
 *     {
 *       return sin(relevoFrequency * position.x + time);
 *     }
 *   """)
 *   surface.SetUniform("time", 0.5)
 *
 * `position` is the base surface's point in the mesh's own coordinates, `normal` the unit normal,
 * `weights` the barycentric weights of the corners in an order of Relevo's own. On the border of a
 * coarse triangle all weights are passed as zeros: two triangles then compute the same height for
 * their common edge, whatever the function, and the surface stays closed. A function of the weights
 * must go to zero there, or it jumps. Heights beyond [-1, 1] are clamped; one that is not a number
 * is 0.
 *
 * vtkAdaptiveRefinementMapper draws any function. vtkAdaptiveRefinementFilter cannot run GLSL: it
 * gives an error, unless a C++ subclass overrides HasHeightFunction() and EvaluateHeight().
 *
 * @sa vtkAdaptiveRefinement vtkDisplacement
 */
#ifndef vtkProceduralSurface_h
#define vtkProceduralSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkNew.h"                        // for Linear
#include "vtkRefinementSurface.h"
#include "vtkSmartPointer.h" // for BaseSurface
#include "vtkTimeStamp.h"    // for PreparationTime

#include <map> // for uniforms

class vtkLinearSurface;

class RELEVOFILTERSREFINEMENT_EXPORT vtkProceduralSurface : public vtkRefinementSurface
{
public:
  static vtkProceduralSurface* New();
  vtkTypeMacro(vtkProceduralSurface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The height of h = 1, in the mesh's length units, default 0.05. Changes live. What is not
   * finite as a float is an error and changes nothing.
   */
  void SetAmplitude(double amplitude);
  vtkGetMacro(Amplitude, double);
  //@}

  //@{
  /**
   * Half waves of the fur along a coarse edge, default 1; relevoFrequency in GLSL. Changes live.
   * More than 1e30 in absolute value is an error and changes nothing.
   */
  void SetFrequency(double frequency);
  vtkGetMacro(Frequency, double);
  //@}

  //@{
  /**
   * The surface that is moved; none (the default) means linear. A vtkProceduralSurface is an error
   * and changes nothing.
   */
  void SetBaseSurface(vtkRefinementSurface* surface);
  vtkRefinementSurface* GetBaseSurface();
  //@}

  //@{
  /**
   * GLSL that defines float proceduralHeight(vec3 position, vec3 normal, vec3 weights), its
   * uniforms and whatever else it needs; it may use the uniforms relevoAmplitude and
   * relevoFrequency. Empty or None (the default) for fur.
   */
  void SetShaderFunction(const char* source);
  const char* GetShaderFunction();
  //@}

  //@{
  /**
   * Value of a uniform, float or vec3, that the shader function declares. Changes live. What is
   * not finite as a float is an error and changes nothing.
   */
  void SetUniform(const char* name, double value);
  void SetUniform(const char* name, double x, double y, double z);
  void RemoveAllUniforms();
  //@}

  bool NeedsNormals() override { return true; }
  int GetNumberOfEdgePositions() override { return this->GetBase()->GetNumberOfEdgePositions(); }
  int GetNumberOfEdgeNormals() override { return this->GetBase()->GetNumberOfEdgeNormals(); }
  int GetNumberOfFacePositions() override { return this->GetBase()->GetNumberOfFacePositions(); }
  int GetNumberOfFaceNormals() override { return this->GetBase()->GetNumberOfFaceNormals(); }
  int GetNumberOfPointValues() override { return this->GetBase()->GetNumberOfPointValues(); }
  int GetNumberOfShaderValues() override { return this->GetBase()->GetNumberOfShaderValues(); }
  double GetReach() override;
  bool InterpolatesCorners() override { return this->ShaderFunction.empty(); }
  bool HasInterpolatedNormals() override { return false; }
  vtkMTimeType GetPreparationMTime() override;
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  /**
   * Whether EvaluateHeight() computes what the shader function does; true for fur.
   */
  virtual bool HasHeightFunction()
  {
    return this->ShaderFunction.empty();
  }

  /**
   * The height for vtkAdaptiveRefinementFilter, which replaces the shader function. May be called
   * from several threads.
   */
  virtual double EvaluateHeight(
    const double position[3], const float normal[3], const float weights[3]);

  bool GetPointValues(vtkPolyData* mesh, float* values, std::string& error) override;
  void ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors) override;
  void ComputeFaceVectors(const Face& face, float* vectors, float* edgeNormals[3]) override;
  bool SplitsNormals(const Face& face) override;
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  std::string GetEvaluationError() override;
  std::string GetShaderSource() override;
  std::vector<Uniform> GetUniforms() override;
#endif

protected:
  vtkProceduralSurface();
  ~vtkProceduralSurface() override;

  double Amplitude = 0.05;
  double Frequency = 1.0;
  std::string ShaderFunction;
  std::map<std::string, std::vector<float>> Uniforms;
  vtkSmartPointer<vtkRefinementSurface> BaseSurface;

private:
  vtkProceduralSurface(const vtkProceduralSurface&) = delete;
  void operator=(const vtkProceduralSurface&) = delete;

  vtkRefinementSurface* GetBase();
  void SetUniformValues(const char* name, const std::vector<double>& values);

  vtkNew<vtkLinearSurface> Linear;
  vtkTimeStamp PreparationTime;
};

#endif
