// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDisplacement
 * @brief   moves the points of a refined surface by a height map
 *
 * The displaced point is point + (Offset + Scale * height) * direction, with the height sampled at
 * the point's texture coordinates and the direction either the surface's unit normal or one fixed
 * vector. Scale and Offset change live: neither buffers nor shaders are rebuilt. Shading normals
 * follow the height gradient.
 *
 * With a height map the mesh must have texture coordinates. Where point normals are needed and
 * missing they are computed. At a texture seam both sides take the height of the corner with the
 * lower point id. Where normals are split, both sides move along their mean; a mesh with such a
 * crease is displaced along linearly interpolated normals throughout, also where the surface's own
 * are quadratic.
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
   * The heights, over texture coordinates [0, 1]^2. None: Offset alone displaces.
   */
  void SetHeightMap(vtkHeightField* heights);
  vtkHeightField* GetHeightMap();
  //@}

  //@{
  /**
   * Factor from the map's height units to the mesh's length units, default 1. A value that is not
   * finite is an error and changes nothing.
   */
  void SetScale(double scale);
  vtkGetMacro(Scale, double);
  //@}

  //@{
  /**
   * Constant added to the scaled height, in the mesh's length units, default 0. A value that is not
   * finite is an error and changes nothing.
   */
  void SetOffset(double offset);
  vtkGetMacro(Offset, double);
  //@}

  //@{
  /**
   * Displace along the surface's unit normal (default) or along a fixed vector, which is
   * normalised. A zero or non-finite vector is an error and changes nothing.
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
   * What becomes of refined triangles over samples without data: left out (HOLE, default) or drawn
   * at heights filled in from around (FILL). Another value is an error and changes nothing.
   */
  void SetNoDataPolicy(int policy);
  vtkGetMacro(NoDataPolicy, int);
  void SetNoDataPolicyToHole() { this->SetNoDataPolicy(HOLE); }
  void SetNoDataPolicyToFill() { this->SetNoDataPolicy(FILL); }
  //@}

  /**
   * Bring the height map up to date; false, after an ErrorEvent of this object, if it has no
   * samples.
   */
  virtual bool Update();

  /**
   * The smallest and largest displacement any point can have, in length units.
   */
  void GetReach(double reach[2]);

  /**
   * Whether refined triangles may have to be left out.
   */
  bool HasHoles();

  /**
   * Latest change of the settings or of the height map.
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
