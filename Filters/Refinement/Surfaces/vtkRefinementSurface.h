// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementSurface
 * @brief   the surface that the points of a refined triangle lie on
 *
 * A surface maps barycentric weights over a coarse triangle, given by its corners' points and
 * normals, to a position and a normal. It is written once, as GLSL that C++ compiles too
 * (glsl/), and evaluated by vtkAdaptiveRefinementFilter and vtkAdaptiveRefinementMapper alike.
 *
 * Values that do not depend on the weights are computed beforehand: vectors per edge, from the
 * edge's two ends alone, and vectors per face. Positions among the edge vectors are averaged over
 * all faces around an edge whose normals differ, so that a crease stays closed (as PN-AEN triangles
 * do, McDonald and Kilgard 2010) while its shading stays sharp. A surface may also take numbers per
 * point from arrays of the mesh; coincident points share the mean of theirs.
 *
 * A surface has four parts, each described in a header of its own: relevo::SurfaceData (what it
 * takes from the mesh), relevo::SurfaceEvaluation (C++), relevo::SurfaceBounds (what a face can
 * reach) and relevo::SurfaceShading (GLSL). A surface of your own overrides Evaluate() and
 * GetShaderSource(), and of the rest what it needs.
 *
 * Settings that are uniforms of the shader change live: they alter GetMTime() but not
 * GetPreparationMTime().
 *
 * @sa vtkLinearSurface vtkPNTriangleSurface vtkPhongSurface vtkScalarTaggedSurface vtkG1Surface
 * vtkProceduralSurface vtkAdaptiveRefinement
 */
#ifndef vtkRefinementSurface_h
#define vtkRefinementSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "Surfaces/SurfaceBounds.h"        // for superclass
#include "Surfaces/SurfaceData.h"          // for superclass
#include "Surfaces/SurfaceEvaluation.h"    // for superclass
#include "Surfaces/SurfaceShading.h"       // for superclass
#include "vtkObject.h"

#ifdef __VTK_WRAP__
class RELEVOFILTERSREFINEMENT_EXPORT vtkRefinementSurface : public vtkObject
#else
class RELEVOFILTERSREFINEMENT_EXPORT vtkRefinementSurface
  : public vtkObject
  , public relevo::SurfaceData
  , public relevo::SurfaceEvaluation
  , public relevo::SurfaceBounds
  , public relevo::SurfaceShading
#endif
{
public:
  vtkAbstractTypeMacro(vtkRefinementSurface, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether the surface's shape depends on point normals. They are computed where missing.
   */
  virtual bool NeedsNormals() { return false; }

  //@{
  /**
   * Number of precomputed 3-vectors: positions and normals per edge, positions and normals per
   * face.
   */
  virtual int GetNumberOfEdgePositions() { return 0; }
  virtual int GetNumberOfEdgeNormals() { return 0; }
  virtual int GetNumberOfFacePositions() { return 0; }
  virtual int GetNumberOfFaceNormals() { return 0; }
  //@}

  /**
   * How many numbers per point the surface takes from the mesh.
   */
  virtual int GetNumberOfPointValues() { return 0; }

  /**
   * How many of these, from the first on, its shader uses: 0 to 4.
   */
  virtual int GetNumberOfShaderValues() { return 0; }

  /**
   * Whether the surface has tables: shapes that the mesh itself brings along, of which corners tell
   * nothing. See BuildTables().
   */
  virtual bool HasTables() { return false; }

  /**
   * Whether displacement goes along directions of the surface's own, EvaluateDirection(), rather
   * than along its normals or, where these are split, those of the corners.
   */
  virtual bool HasDirections() { return false; }

  /**
   * How far, in length units, points can lie from the convex hull of a face's corners, precomputed
   * positions and the box of ExtendBox().
   */
  virtual double GetReach() { return 0.0; }

  /**
   * Whether the surface goes through the coarse points.
   */
  virtual bool InterpolatesCorners() { return true; }

  /**
   * Whether normals are sums, with weights that are not negative, of the corners' normals and the
   * precomputed ones.
   */
  virtual bool HasInterpolatedNormals() { return true; }

  /**
   * Latest change that affects precomputed vectors, numbers per point or the shader's text.
   */
  virtual vtkMTimeType GetPreparationMTime() { return this->GetMTime(); }

#ifndef __VTK_WRAP__
  using Tables = relevo::SurfaceTables;
  using Corner = relevo::SurfaceCorner;
  using Face = relevo::SurfaceFace;
  using Uniform = relevo::SurfaceUniform;
#endif

protected:
  vtkRefinementSurface();
  ~vtkRefinementSurface() override;

private:
  vtkRefinementSurface(const vtkRefinementSurface&) = delete;
  void operator=(const vtkRefinementSurface&) = delete;
};

#endif
