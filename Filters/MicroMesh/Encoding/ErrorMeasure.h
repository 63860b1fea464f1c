// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ErrorMeasure
 * @brief   bounds of the distances between a dense mesh and a micro-mesh, in both directions
 *
 * @sa DistanceBound
 */
#ifndef ErrorMeasure_h
#define ErrorMeasure_h

#include "Dense/DenseMesh.h"
#include "Distance/TriangleTree.h"
#include "Encoding/BaseMesh.h"

#include <functional> // for aborts
#include <vector>     // for members

namespace relevo
{
class ErrorMeasure
{
public:
  /// `surface` has the triangles of the dense mesh.
  ErrorMeasure(const DenseMesh& dense, const TriangleTree& surface, double tolerance)
    : Dense(dense)
    , Surface(surface)
    , Tolerance(tolerance)
  {
  }

  /// Measure a mesh on the faces of a base. Faces that are the same as in the last run, of the same
  /// base, are not measured again. Returns false after an abort.
  bool Run(const BaseMesh& base, const MicroMesh& mesh, const std::function<bool()>& isAborted);

  /// The largest bounds from the input to the result and back, without those that failed.
  double GetInputToResult() const { return this->InputToResult; }
  double GetResultToInput() const { return this->ResultToInput; }
  /// Faces and triangles of the dense mesh that are not within the tolerance, and faces near such
  /// triangles.
  std::vector<char> FailedFaces;
  std::vector<char> FailedTriangles;
  bool HasFailed() const { return this->Failed; }

private:
  void BuildGrids(const MicroMesh& mesh);
  bool IsSameFace(const std::vector<dvec3>& lastPoints, const std::vector<std::size_t>& lastFirsts,
    std::size_t face) const;
  void MeasureFaces(const std::function<bool()>& isAborted);
  void MeasureTriangles(const BaseMesh& base, const std::function<bool()>& isAborted);
  void FailNearFaces(const TriangleTree& result);
  double Reduce(const std::vector<double>& bounds2, std::vector<char>& failed);

  const DenseMesh& Dense;
  const TriangleTree& Surface;
  double Tolerance;
  // The grids of all faces.
  std::vector<dvec3> GridPoints;
  std::vector<TriangleTree::Triangle> GridTriangles;
  std::vector<std::size_t> FirstPoints;    // per face, and the total
  std::vector<std::size_t> FirstTriangles; // per face, and the total
  std::vector<double> FaceBounds2;
  double InputToResult = 0.0;
  double ResultToInput = 0.0;
  bool Failed = false;
};
}

#endif
