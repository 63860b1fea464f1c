// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkProceduralSurface
 * @brief   a surface displaced along its normals by a function: fur, or your own function
 *
 * A point of the surface is V = B + Amplitude h N. B is the point of the base surface. N is the sum
 * of the corners' unit normals with the barycentric weights, not normalised. The height h is in
 * [-1, 1]. The default for h is the fur of Lenz 2009 (fig. 5.14): g sin(u f pi) sin(v f pi)
 * sin(w f pi), where f is Frequency, u, v, w are the weights and g is the mean cosine of the angles
 * between the corners' normals. Shading normals follow the heights.
 *
 * Use SetShaderFunction() to set GLSL source for another h:
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
 * `position` is the point of the base surface in the coordinates of the mesh, `normal` is the unit
 * normal, and `weights` are the barycentric weights of the corners, in an order that Relevo
 * chooses. On the border of a coarse triangle, all weights passed are 0, so that both triangles
 * compute the same height for their common edge and the surface is closed. A function of the
 * weights must go to 0 at the border, otherwise it is discontinuous there. Heights are clamped to
 * [-1, 1]. NaN is replaced by 0.
 *
 * vtkAdaptiveRefinementMapper draws any function. vtkAdaptiveRefinementFilter cannot run GLSL. It
 * reports an error unless a C++ subclass overrides HasHeightFunction() and EvaluateHeight().
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
   * Set the displacement for h = 1, in the mesh's length units. The default is 0.05. A change takes
   * effect in the next frame. Values that are not finite as floats are rejected with an error.
   */
  void SetAmplitude(double amplitude);
  vtkGetMacro(Amplitude, double);
  //@}

  //@{
  /**
   * Set the number of half waves of the fur along a coarse edge, relevoFrequency in GLSL. The
   * default is 1. A change takes effect in the next frame. Absolute values above 1e30 are rejected
   * with an error.
   */
  void SetFrequency(double frequency);
  vtkGetMacro(Frequency, double);
  //@}

  //@{
  /**
   * Set the surface that is displaced. None, the default, means linear. A vtkProceduralSurface is
   * rejected with an error.
   */
  void SetBaseSurface(vtkRefinementSurface* surface);
  vtkRefinementSurface* GetBaseSurface();
  //@}

  //@{
  /**
   * Set GLSL source that defines float proceduralHeight(vec3 position, vec3 normal, vec3 weights),
   * its uniforms and helper functions. It can use the uniforms relevoAmplitude and relevoFrequency.
   * An empty string or None, the default, means fur.
   */
  void SetShaderFunction(const char* source);
  const char* GetShaderFunction();
  //@}

  //@{
  /**
   * Set the value of a uniform, float or vec3, that the shader function declares. A change takes
   * effect in the next frame. Values that are not finite as floats are rejected with an error.
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
   * Return whether EvaluateHeight() computes the same heights as the shader function. True for fur.
   */
  virtual bool HasHeightFunction()
  {
    return this->ShaderFunction.empty();
  }

  /**
   * Return the height for vtkAdaptiveRefinementFilter. This replaces the shader function on the CPU
   * and must be thread-safe.
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
