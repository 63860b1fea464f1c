// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SampledFaces
 * @brief   measures how far refined faces are from the displaced surface
 *
 * The deviation is the distance between a point of a triangle and the point of the surface with the
 * same weights. Heights are bilinear between texel centres. On a flat face with one direction of
 * displacement, the deviation in a cell of texels has its largest value at a texel centre, where a
 * side of a triangle crosses a line between cells, or on a side between two such crossings. There
 * it is quadratic. These deviations are measured exactly. Other faces are measured at the same
 * points and at the points of a lattice. A bound for the curvature between the points is added: an
 * eighth of the largest second difference, which is measured once per face, times a safety factor.
 *
 * Cells with missing samples are skipped. A removed triangle that contains data deviates by the
 * length of its longest side, unless it is smaller than a texel. At texture seams, heights are
 * those of the face.
 */
#ifndef SampledFaces_h
#define SampledFaces_h

#include "Mesh/RefinementMesh.h"
#include "Metrics/DisplacedFaces.h"
#include "Metrics/MeasuredPatterns.h" // for members
#include "View/PixelScale.h"

#include <memory> // for members
#include <vector> // for members

class vtkAdaptiveRefinement;

namespace relevo
{
class PatternFamily;

class SampledFaces : public DisplacedFaces
{
public:
  SampledFaces();
  ~SampledFaces() override;

  /// Build the mesh, then call Take() once. The recipe must not change afterwards.
  RefinementMesh Mesh;
  void Take(vtkAdaptiveRefinement* recipe, std::shared_ptr<const PatternFamily> patterns);

  int GetNumberOfFaces() const override;
  std::array<int, 3> GetMergedPoints(int face) const override;
  std::vector<int> FindEdges(const SurfaceEdges& edges) const override;
  PointBox GetBox(int face) const override;
  FaceDeviations Measure(int face, const std::array<float, 3>& tags) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
  MeasuredPatterns Patterns;
  std::vector<PointBox> Boxes;
};
}

#endif
