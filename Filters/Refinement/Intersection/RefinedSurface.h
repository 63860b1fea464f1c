// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedSurface
 * @brief   intersects lines with a refined surface without building it
 *
 * A tree of boxes finds the coarse faces that a line can intersect. Only these are refined, with
 * the evaluator and the patterns of the filter. Refined points of an edge have the same bits in
 * both faces. The triangle test (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection,
 * 2013) finds the same side of an edge from both, so that no line passes between two faces.
 */
#ifndef RefinedSurface_h
#define RefinedSurface_h

#include "Boxes/BoundingBox.h"
#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkMTimeType

#include <functional> // for ForEachFace()
#include <memory>     // for members
#include <vector>     // for IntersectAll()

class vtkAdaptiveRefinement;
class vtkDataArray;

namespace relevo
{
class HoleFinder;
class PatternSelection;
class RefinementEvaluator;
class RefinementMesh;

/// A point of the refined surface.
struct SurfaceHit
{
  /// The coarse face, an index into RefinementMesh::Faces; -1 for none.
  int Face = -1;
  /// The parameter on the line, from 0 at its start to 1 at its end.
  double T = 0.0;
  /// In the coordinates of the input.
  double Position[3] = { 0.0, 0.0, 0.0 };
  /// Unit normal, interpolated between refined points if the mesh or the input has normals.
  /// Otherwise, the normal of the refined triangle.
  double Normal[3] = { 0.0, 0.0, 1.0 };
  /// The weights of the face's sorted corners at the point before displacement.
  double Weights[3] = { 0.0, 0.0, 0.0 };
};

class RELEVOFILTERSREFINEMENT_EXPORT RefinedSurface
{
public:
  RefinedSurface();
  ~RefinedSurface();

  /**
   * Set a mesh that was built with the recipe, and its build time. Data that are not out of date
   * are reused. `normals` are the input's point normals, or nullptr. All must outlive the calls
   * below.
   */
  void Update(const RefinementMesh& mesh, vtkMTimeType meshTime, vtkAdaptiveRefinement* recipe,
    vtkDataArray* normals);

  /// The time of the latest change.
  vtkMTimeType GetTime() const;

  //@{
  /// The evaluator of refined points, the holes (nullptr if there are none), and a box of all
  /// points of a face, relative to the mesh's origin.
  const RefinementEvaluator& GetEvaluator() const;
  const HoleFinder* GetHoles() const;
  const BoundingBox<float>& GetBox(int face) const;
  //@}

  //@{
  /**
   * Thread-safe, with the patterns of all faces.
   */
  /// Find the first intersection of a line, or if there is none, the first point within `tolerance`
  /// of the line.
  bool Intersect(const PatternSelection& selection, const double start[3], const double end[3],
    double tolerance, SurfaceHit& hit) const;

  /// Find all intersections of a line with the surface, each once, in order along the line.
  void IntersectAll(const PatternSelection& selection, const double start[3], const double end[3],
    std::vector<SurfaceHit>& hits) const;

  /// Find the nearest point within `radius`. `distance2` is the square of its distance.
  bool FindClosest(const PatternSelection& selection, const double place[3], double radius,
    SurfaceHit& hit, double& distance2) const;

  /// Get the refined point at a corner of a face. Returns false over missing data.
  bool GetCorner(int face, int corner, double position[3]) const;

  /// Visit the coarse faces whose refined points may be in a box or that a line may intersect.
  void ForEachFaceInBounds(const double bounds[6], const std::function<void(int)>& visit) const;
  void ForEachFaceOnLine(const double start[3], const double end[3], double tolerance,
    const std::function<void(int)>& visit) const;
  //@}

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
