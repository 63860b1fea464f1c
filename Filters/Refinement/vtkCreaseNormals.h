// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCreaseNormals
 * @brief   point normals that keep a mesh's creases, and the surface that fits the mesh with them
 *
 * A curved surface bends every face towards the normals at its corners. Where these are averaged
 * over the edges of a solid, a cube becomes a ball. This filter gives each corner a normal that its
 * face can follow, so that a curved surface keeps the shape that the mesh has:
 *
 * - The mesh's own point normals are used where they are at most FeatureAngle from the face's.
 * - Elsewhere normals are computed: the mean of the faces around that meet at no more than
 *   FeatureAngle, weighted by area. Edges of more than two faces, and of faces that wind against
 *   each other, are creases too.
 * - Where that mean is more than FeatureAngle from the face's normal, as at the tip of a cone, the
 *   face's normal is used.
 *
 * GetFittingSurface() chooses the surface: PN triangles, or a linear surface if there is nothing to
 * curve. That is so where no two faces meet at an angle that is no crease, and where most of the
 * edges that bend do so by 2/3 to 3/2 of FeatureAngle, unless most of the mesh's own normals are
 * used: such a mesh is too coarse to tell its creases from its bends, and keeps its flat faces. A
 * finely divided sphere becomes round. An icosahedron, whose faces meet at 42 degrees, and a sphere
 * of 8 x 8 faces without normals stay as they are.
 *
 * The creases of a noisy mesh, as of a scan, are not those of its shape: they end soon, ridges run
 * into valleys, and there are bends of all sizes. A mesh counts as noisy if at least 2 % of its
 * bends are creases, at more than half of the points with creases there is just one or there are
 * both ridges and valleys, and edges that bend by 2/3 of FeatureAngle up to it are more than a
 * quarter as many as creases. Such a mesh keeps its flat faces, shaded smoothly: no angle is a
 * crease, and each point has the mean normal of all its faces, or its own.
 *
 * Input: a vtkPolyData. Coincident points are one place, whether or not faces share them. Output:
 * the same mesh with "Normals" (float, unit vectors) as active normals; points are split where
 * normals differ, the copies with the same point data after the input's points. Strips become
 * triangles, after the polygons. Cells that refer to missing points are an error.
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
   * Faces that meet at more than this angle have a crease between them. In degrees, 0 to 180;
   * default 30, as in vtkPolyDataNormals. A value outside is an error and changes nothing.
   */
  void SetFeatureAngle(double angle);
  vtkGetMacro(FeatureAngle, double);
  //@}

  //@{
  /**
   * Whether a mesh that is too coarse to tell its creases from its bends keeps its flat faces, and
   * a noisy one becomes smooth, see above. Default on; off if you know FeatureAngle to fit the
   * mesh.
   */
  vtkSetMacro(KeepCoarseFlat, bool);
  vtkGetMacro(KeepCoarseFlat, bool);
  vtkBooleanMacro(KeepCoarseFlat, bool);
  //@}

  /**
   * The number of creases in the last input.
   */
  vtkGetMacro(NumberOfCreases, vtkIdType);

  /**
   * The surface that fits the last output: a vtkPNTriangleSurface or a vtkLinearSurface; nullptr
   * before the first update.
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
