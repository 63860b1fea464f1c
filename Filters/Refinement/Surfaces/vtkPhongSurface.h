// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPhongSurface
 * @brief   Phong tessellation: a quadratic patch per coarse triangle, cheaper than PN triangles
 *
 * Source: T. Boubekeur, M. Alexa, "Phong Tessellation", SIGGRAPH Asia 2008. A point p of the plane
 * triangle is projected to the tangent planes of the three corners:
 * p_i = p - ((p - P_i) . N_i) N_i. With p* the mean of the projections, weighted by the barycentric
 * weights, the point of the surface is p + Alpha (p* - p). Normals are interpolated linearly. The
 * surface interpolates the coarse points and is closed along creases, where the patches of both
 * sides share one border. It is less smooth than the cubic patches of vtkPNTriangleSurface:
 * silhouettes show the coarse edges.
 *
 * The point normals of the input are used. Missing normals are computed from the faces.
 *
 * Refinement fails with an error if the array AlphaArrayName is missing, does not have one number
 * per point, or has non-finite numbers.
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
   * Set how far points move from the plane triangle (0) to the mean of their projections (1). The
   * default is 1; the paper's images use 0.75. A change takes effect in the next frame. Values
   * outside [0, 1] are rejected with an error.
   */
  void SetAlpha(double alpha);
  vtkGetMacro(Alpha, double);
  //@}

  //@{
  /**
   * Set the name of a point array with one component that replaces Alpha and is interpolated
   * linearly. Its values are clamped to [0, 1]. Coincident points use the mean of their values. An
   * empty name, the default, means none.
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
