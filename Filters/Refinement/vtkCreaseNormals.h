// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCreaseNormals
 * @brief   compute point normals that preserve creases, and choose a matching surface
 *
 * A curved surface bends each face towards the normals at its corners. If these normals are
 * averaged across the edges of a solid, a cube becomes a ball. This filter assigns each corner a
 * normal that its face can follow, so that a curved surface keeps the shape of the mesh:
 *
 * - The normals of the mesh are used where they differ from the face normal by at most
 *   FeatureAngle.
 * - Elsewhere, normals are computed as the area-weighted mean of the adjacent faces that meet at
 *   FeatureAngle or less. Edges of more than two faces, and of faces with opposite winding, are
 *   creases too.
 * - The face normal is used where that mean differs from it by more than FeatureAngle, as at the
 *   tip of a cone.
 *
 * GetFittingSurface() returns a surface for the result: PN triangles, or a linear surface for flat
 * meshes. A mesh is flat if all faces that meet at an angle form creases. It is also treated as
 * flat if it is too coarse to distinguish creases from curvature: most of its bent edges bend by
 * 2/3 to 3/2 of FeatureAngle, and most of its normals are not used. For example, a finely divided
 * sphere becomes round. An icosahedron, whose faces meet at 42 degrees, and a sphere of 8 x 8 faces
 * without normals remain flat.
 *
 * Noisy meshes, such as scans, have creases that do not belong to their shape: they are short,
 * ridges run into valleys, and there are bends of all sizes. A mesh is noisy if three conditions
 * are true. At least 2 % of its bends are creases. More than half of the points on creases have
 * only one crease, or both ridges and valleys. The edges that bend by 2/3 of FeatureAngle to
 * FeatureAngle number more than a quarter of the creases. A noisy mesh has no creases and a linear
 * surface with smooth shading: each point has the normal of the mesh, or else the mean normal of
 * all adjacent faces.
 *
 * The input is a vtkPolyData. Coincident points are merged for the computation, even if no face
 * shares them. The output is the same mesh with "Normals" (float, unit vectors) as active normals.
 * Points are split where normals differ. The copies have the same point data and follow the input's
 * points. Strips become triangles, after the polygons. Cells that refer to missing points are an
 * error.
 *
 * @sa vtkPNTriangleSurface vtkAdaptiveRefinement
 */
#ifndef vtkCreaseNormals_h
#define vtkCreaseNormals_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

class vtkRefinementSurface;

class RELEVOFILTERSREFINEMENT_EXPORT vtkCreaseNormals : public vtkPolyDataAlgorithm
{
public:
  static vtkCreaseNormals* New();
  vtkTypeMacro(vtkCreaseNormals, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the angle between faces above which their common edge is a crease, in degrees, 0 to 180.
   * The default is 30, as in vtkPolyDataNormals. Values out of range are rejected with an error.
   */
  void SetFeatureAngle(double angle);
  vtkGetMacro(FeatureAngle, double);
  //@}

  //@{
  /**
   * Set whether coarse meshes remain flat and noisy meshes become smooth, as described above. The
   * default is on. Turn it off if FeatureAngle suits the mesh.
   */
  vtkSetMacro(KeepCoarseFlat, bool);
  vtkGetMacro(KeepCoarseFlat, bool);
  vtkBooleanMacro(KeepCoarseFlat, bool);
  //@}

  /**
   * Get the number of creases of the last input.
   */
  vtkGetMacro(NumberOfCreases, vtkIdType);

  /**
   * Return the surface that fits the last output: a vtkPNTriangleSurface or a vtkLinearSurface.
   * Returns nullptr before the first update.
   */
  vtkRefinementSurface* GetFittingSurface();

protected:
  vtkCreaseNormals();
  ~vtkCreaseNormals() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double FeatureAngle = 30.0;
  bool KeepCoarseFlat = true;
  vtkIdType NumberOfCreases = 0;
  vtkSmartPointer<vtkRefinementSurface> FittingSurface;

private:
  vtkCreaseNormals(const vtkCreaseNormals&) = delete;
  void operator=(const vtkCreaseNormals&) = delete;
};

#endif
