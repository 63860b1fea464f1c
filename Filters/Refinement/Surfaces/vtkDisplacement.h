// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDisplacement
 * @brief   move the points of a refined surface by a height map
 *
 * A displaced point is point + (Offset + Scale * height) * direction. The height is sampled at the
 * point's texture coordinates. The direction is the unit normal of the surface or a fixed vector. A
 * change of Scale or Offset takes effect in the next frame: neither buffers nor shaders are
 * rebuilt. Shading normals follow the height gradient.
 *
 * If there is a height map, the mesh must have texture coordinates. Missing point normals are
 * computed if they are needed. At a texture seam, both sides use the height of the corner with the
 * lower point id. At split normals, both sides move along the mean normal. A mesh with split
 * normals is displaced along linearly interpolated normals everywhere, even if the surface has
 * quadratic normals.
 *
 * @sa vtkHeightField vtkHeightMap vtkAdaptiveRefinement
 */
#ifndef vtkDisplacement_h
#define vtkDisplacement_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for HeightMap

class vtkHeightField;

class RELEVOFILTERSREFINEMENT_EXPORT vtkDisplacement : public vtkObject
{
public:
  static vtkDisplacement* New();
  vtkTypeMacro(vtkDisplacement, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the height map, over texture coordinates [0, 1]^2. None, the default, means that only
   * Offset displaces.
   */
  void SetHeightMap(vtkHeightField* heights);
  vtkHeightField* GetHeightMap();
  //@}

  //@{
  /**
   * Set the factor from the height map's units to the mesh's length units. The default is 1.
   * Non-finite values are rejected with an error.
   */
  void SetScale(double scale);
  vtkGetMacro(Scale, double);
  //@}

  //@{
  /**
   * Set the constant that is added to the scaled height, in the mesh's length units. The default is
   * 0. Non-finite values are rejected with an error.
   */
  void SetOffset(double offset);
  vtkGetMacro(Offset, double);
  //@}

  //@{
  /**
   * Displace along the surface's unit normal (default) or along a fixed vector, which is
   * normalised. Zero and non-finite vectors are rejected with an error.
   */
  void SetDirectionToNormal();
  void SetDirection(double x, double y, double z);
  void SetDirection(const double direction[3])
  {
    this->SetDirection(direction[0], direction[1], direction[2]);
  }
  vtkGetVector3Macro(Direction, double);
  bool IsAlongNormal() { return this->AlongNormal; }
  //@}

  enum NoDataPolicyType
  {
    HOLE = 0,
    FILL = 1
  };
  //@{
  /**
   * Set how refined triangles over missing samples are drawn: not at all (HOLE, the default), or at
   * heights interpolated from neighbouring samples (FILL). Other values are rejected with an error.
   */
  void SetNoDataPolicy(int policy);
  vtkGetMacro(NoDataPolicy, int);
  void SetNoDataPolicyToHole() { this->SetNoDataPolicy(HOLE); }
  void SetNoDataPolicyToFill() { this->SetNoDataPolicy(FILL); }
  //@}

  /**
   * Update the height map. Returns false after reporting an error if it has no samples.
   */
  virtual bool Update();

  /**
   * Get the smallest and largest possible displacement, in length units.
   */
  void GetReach(double reach[2]);

  /**
   * Return whether the displacement can have holes: NoDataPolicy is HOLE and the height map has
   * missing samples.
   */
  bool HasHoles();

  /**
   * Return the time of the latest change of the settings or the height map.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkDisplacement();
  ~vtkDisplacement() override;

  vtkSmartPointer<vtkHeightField> HeightMap;
  double Scale = 1.0;
  double Offset = 0.0;
  double Direction[3] = { 0.0, 0.0, 1.0 };
  bool AlongNormal = true;
  int NoDataPolicy = HOLE;

private:
  vtkDisplacement(const vtkDisplacement&) = delete;
  void operator=(const vtkDisplacement&) = delete;
};

#endif
