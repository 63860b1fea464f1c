// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementSurface
 * @brief   the surface that the points of a refined triangle lie on
 *
 * A surface maps barycentric weights on a coarse triangle, given by the points and normals of its
 * corners, to a position and a normal. The code is written once, as GLSL that also compiles as C++
 * (glsl/). Both vtkAdaptiveRefinementFilter and vtkAdaptiveRefinementMapper use it.
 *
 * Values that do not depend on the weights are precomputed: vectors per edge, from the two ends of
 * the edge, and vectors per face. Where normals are split, the positions among the edge vectors are
 * averaged over all faces of the edge. A crease then stays closed while its shading stays sharp, as
 * with PN-AEN triangles (McDonald and Kilgard 2010). A surface can also use numbers per point from
 * arrays of the mesh. Coincident points use the mean of their numbers.
 *
 * A surface has four parts, each with a header: relevo::SurfaceData (values taken from the mesh),
 * relevo::SurfaceEvaluation (C++ evaluation), relevo::SurfaceBounds (bounds of a face) and
 * relevo::SurfaceShading (GLSL). To write a surface, override Evaluate(), GetShaderSource() and
 * whatever else it needs.
 *
 * Settings that are shader uniforms change GetMTime() but not GetPreparationMTime(), so that a
 * change takes effect in the next frame without preparation.
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
   * Return whether the surface needs point normals. Missing normals are computed.
   */
  virtual bool NeedsNormals() { return false; }

  //@{
  /**
   * Return the number of precomputed 3-vectors: positions and normals per edge, positions and
   * normals per face.
   */
  virtual int GetNumberOfEdgePositions() { return 0; }
  virtual int GetNumberOfEdgeNormals() { return 0; }
  virtual int GetNumberOfFacePositions() { return 0; }
  virtual int GetNumberOfFaceNormals() { return 0; }
  //@}

  /**
   * Return the number of values per point that the surface uses from the mesh.
   */
  virtual int GetNumberOfPointValues() { return 0; }

  /**
   * Return how many of these values the shader uses, starting with the first, 0 to 4.
   */
  virtual int GetNumberOfShaderValues() { return 0; }

  /**
   * Return whether the surface has tables: shapes stored with the mesh, which cannot be derived
   * from the corners. See BuildTables().
   */
  virtual bool HasTables() { return false; }

  /**
   * Return whether displacement uses EvaluateDirection(). Otherwise it uses the surface's normals
   * or, where these are split, the normals of the corners.
   */
  virtual bool HasDirections() { return false; }

  /**
   * Return how far points can lie from the convex hull of a face's corners, the precomputed
   * positions and the box of ExtendBox(), in length units.
   */
  virtual double GetReach() { return 0.0; }

  /**
   * Return whether the surface interpolates the coarse points.
   */
  virtual bool InterpolatesCorners() { return true; }

  /**
   * Return whether normals are sums of the corners' normals and the precomputed normals with
   * non-negative weights.
   */
  virtual bool HasInterpolatedNormals() { return true; }

  /**
   * Return the time of the latest change of precomputed vectors, values per point or the shader
   * source.
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
