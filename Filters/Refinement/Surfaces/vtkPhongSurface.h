// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPhongSurface
 * @brief   Phong tessellation: a quadratic patch per coarse triangle, cheaper than PN triangles
 *
 * T. Boubekeur, M. Alexa, "Phong Tessellation", SIGGRAPH Asia 2008. The point p of the plane
 * triangle is projected on the tangent planes of the three corners, p_i = p - ((p - P_i) . N_i)
 * N_i; p* is the mean of the projections by the barycentric weights, and the surface's point p +
 * Alpha (p* - p). Normals are interpolated linearly. The surface goes through the coarse points; it
 * is closed along creases, where the two sides' patches share one border. It is less smooth than
 * vtkPNTriangleSurface, whose patches are cubic: outlines show the coarse edges.
 *
 * Point normals of the input are used; where there are none they are computed from the faces.
 *
 * Errors: an array of AlphaArrayName that is missing, does not have one number per point, or has
 * numbers that are not finite.
 *
 * @sa vtkAdaptiveRefinement vtkPNTriangleSurface
 */
#ifndef vtkPhongSurface_h
#define vtkPhongSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkRefinementSurface.h"
#include "vtkTimeStamp.h" // for PreparationTime

class RELEVOFILTERSREFINEMENT_EXPORT vtkPhongSurface : public vtkRefinementSurface
{
public:
  static vtkPhongSurface* New();
  vtkTypeMacro(vtkPhongSurface, vtkRefinementSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * How far points go from the plane triangle, 0, to the mean of their projections, 1 (the
   * default); the paper's pictures have 0.75. Changes live. A value outside [0, 1] is an
   * error and changes nothing.
   */
  void SetAlpha(double alpha);
  vtkGetMacro(Alpha, double);
  //@}

  //@{
  /**
   * Name of a point array of one component that is used instead of Alpha and interpolated linearly;
   * numbers outside [0, 1] are clamped, coincident points share the mean of theirs. Empty (the
   * default) for none.
   */
  void SetAlphaArrayName(const char* name);
  const char* GetAlphaArrayName();
  //@}

  bool NeedsNormals() override { return true; }
  int GetNumberOfEdgePositions() override { return 1; }
  int GetNumberOfPointValues() override { return this->AlphaArrayName.empty() ? 0 : 1; }
  int GetNumberOfShaderValues() override { return this->GetNumberOfPointValues(); }
  vtkMTimeType GetPreparationMTime() override { return this->PreparationTime; }

#ifndef __VTK_WRAP__
  bool GetPointValues(vtkPolyData* mesh, float* values, std::string& error) override;
  void ComputeEdgeVectors(const Corner& a, const Corner& b, float* vectors) override;
  void Evaluate(
    const Face& face, const float weights[3], float position[3], float normal[3]) override;
  float ComputeNormalCone(const Face& face, float axis[3]) override;
  std::string GetShaderSource() override;
  std::vector<Uniform> GetUniforms() override;
#endif

protected:
  vtkPhongSurface();
  ~vtkPhongSurface() override;

  double Alpha = 1.0;
  std::string AlphaArrayName;
  vtkTimeStamp PreparationTime;

private:
  vtkPhongSurface(const vtkPhongSurface&) = delete;
  void operator=(const vtkPhongSurface&) = delete;
};

#endif
