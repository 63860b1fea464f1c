// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ErrorMeasure
 * @brief   bounds of the distances between a dense mesh and a micro-mesh, in both directions
 *
 * Bounds stay valid while the surface near them does not change. Each run therefore measures only
 * faces that are not those of the last run, and triangles of the dense mesh that failed or are near
 * faces that are gone.
 *
 * @sa DistanceBound
 */
#ifndef ErrorMeasure_h
#define ErrorMeasure_h

#include "Dense/DenseMesh.h"
#include "Distance/TriangleTree.h"
#include "Encoding/BaseMesh.h"
#include "Encoding/FaceMatch.h"

#include <functional> // for aborts
#include <memory>     // for members
#include <utility>    // for std::pair
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

  /// Measure a mesh on the faces of a base. Returns false after an abort; no further run is
  /// possible then.
  bool Run(const BaseMesh& base, const MicroMesh& mesh, const std::function<bool()>& isAborted);

  /// The largest bounds from the input to the result and back, without those that failed.
  double GetInputToResult() const { return this->InputToResult; }
  double GetResultToInput() const { return this->ResultToInput; }
  /// Faces that are not within the tolerance, and those that are nearest to such triangles of the
  /// dense mesh.
  std::vector<char> FailedFaces;
  /// Triangles of the dense mesh that are not within the tolerance, and the nearest faces.
  std::vector<std::pair<int, int>> FailedTriangles;
  bool HasFailed() const { return this->Failed; }

private:
  // The points of the grids of all faces.
  struct Grids
  {
    explicit Grids(const MicroMesh& mesh);
    bool HasSameFace(std::size_t face, const Grids& other, std::size_t otherFace) const;
    FloatBox GetBox(std::size_t face, double margin) const;

    std::vector<dvec3> Points;
    std::vector<std::size_t> Firsts; // per face, and the total
    std::vector<int> Segments;       // per edge of each face
  };

  void TakeFaceBounds(const BaseMesh& base, const MicroMesh& mesh, const Grids& grids);
  void FindChangedTriangles(const BaseMesh& base, const MicroMesh& mesh);
  FloatBox GetTriangleBox(std::size_t triangle) const;
  void MeasureFaces(
    const MicroMesh& mesh, const Grids& grids, const std::function<bool()>& isAborted);
  std::vector<int> FindFacesNearChanges(const MicroMesh& mesh, const Grids& grids) const;
  void MeasureTriangles(
    const MicroMesh& mesh, const Grids& grids, const std::function<bool()>& isAborted);
  double FindLargest(const std::vector<float>& bounds);

  const DenseMesh& Dense;
  const TriangleTree& Surface;
  double Tolerance;
  std::unique_ptr<Grids> LastGrids;
  std::unique_ptr<FaceMatch> LastFaces;
  // Upper bounds in units of the tolerance; infinite if above it, negative if not measured.
  std::vector<float> FaceBounds;
  std::vector<float> TriangleBounds;
  std::vector<char> AreGone; // per face of the last run
  double InputToResult = 0.0;
  double ResultToInput = 0.0;
  bool Failed = false;
};
}

#endif
