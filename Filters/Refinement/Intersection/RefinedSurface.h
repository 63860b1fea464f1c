// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinedSurface
 * @brief   where a line meets a refined surface that nobody has built
 *
 * A tree of boxes tells which coarse faces a line can meet; only these are refined, by the
 * evaluator and the patterns that the filter takes. Refined points of an edge have the same bits in
 * both faces, and the test of a triangle (Woop, Benthin and Wald, Watertight Ray/Triangle
 * Intersection, 2013) finds the same side of an edge from both: no line slips through between two
 * faces.
 */
#ifndef RefinedSurface_h
#define RefinedSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkType.h"                       // for vtkMTimeType

#include <functional> // for ForEachFace()
#include <memory>     // for members
#include <vector>     // for IntersectAll()

class vtkAdaptiveRefinement;
class vtkDataArray;

namespace relevo
{
struct FaceBox;
class HoleFinder;
class PatternSelection;
class RefinementEvaluator;
class RefinementMesh;

/// A point of the refined surface.
struct SurfaceHit
{
  /// The coarse face, an index of RefinementMesh::Faces; -1 for none.
  int Face = -1;
  /// Where on the line, from 0 at its start to 1 at its end.
  double T = 0.0;
  /// In the input's coordinates.
  double Position[3] = { 0.0, 0.0, 0.0 };
  /// Unit normal, interpolated between refined points where the mesh or the input has normals;
  /// else that of the refined triangle.
  double Normal[3] = { 0.0, 0.0, 1.0 };
  /// The weights of the face's sorted corners where the point was before it was moved.
  double Weights[3] = { 0.0, 0.0, 0.0 };
};

class RELEVOFILTERSREFINEMENT_EXPORT RefinedSurface
{
public:
  RefinedSurface();
  ~RefinedSurface();

  /**
   * Take a mesh built with the recipe, and when it was built. Whatever has not changed since the
   * last call is kept. `normals` are the input's, of points, or nullptr. All must outlive the
   * calls below.
   */
  void Update(const RefinementMesh& mesh, vtkMTimeType meshTime, vtkAdaptiveRefinement* recipe,
    vtkDataArray* normals);

  /// When something last changed.
  vtkMTimeType GetTime() const;

  //@{
  /// What refined points are evaluated by; what is left out of them, nullptr for nothing; a box,
  /// relative to the mesh's origin, that has all points of a face.
  const RefinementEvaluator& GetEvaluator() const;
  const HoleFinder* GetHoles() const;
  const FaceBox& GetBox(int face) const;
  //@}

  //@{
  /**
   * May be called from several threads, with the patterns of all faces.
   */
  /// The first point of a line; or, where it meets none, the first that it passes within
  /// `tolerance`, a length.
  bool Intersect(const PatternSelection& selection, const double start[3], const double end[3],
    double tolerance, SurfaceHit& hit) const;

  /// All points where a line meets the surface, each once, in the line's order.
  void IntersectAll(const PatternSelection& selection, const double start[3], const double end[3],
    std::vector<SurfaceHit>& hits) const;

  /// The point nearest to a place, if it is within `radius`; `distance2` is the square of its
  /// distance.
  bool FindClosest(const PatternSelection& selection, const double place[3], double radius,
    SurfaceHit& hit, double& distance2) const;

  /// The refined point at a corner of a face; false where there is none, over no-data.
  bool GetCorner(int face, int corner, double position[3]) const;

  /// Coarse faces whose refined points may lie in a box, and those a line may meet.
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
