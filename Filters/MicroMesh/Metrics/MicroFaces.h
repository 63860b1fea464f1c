// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MicroFaces
 * @brief   how far refined faces of a micro-mesh are from its surface
 *
 * With the same power of two of segments on all edges, the deviation is the stored error of the
 * level. Other patterns are measured on first use.
 */
#ifndef MicroFaces_h
#define MicroFaces_h

#include "Data/MicroMesh.h"
#include "Metrics/DisplacedFaces.h"
#include "Metrics/MeasuredPatterns.h"
#include "View/PixelScale.h"

#include <string> // for errors

class vtkPolyData;

namespace relevo
{
class MetricMesh;

class MicroFaces : public DisplacedFaces
{
public:
  MicroFaces(std::shared_ptr<const PatternFamily> patterns, int maximumLevel);

  /// Read a micro-mesh. Returns false and an error for the user if it is invalid.
  bool Take(MetricMesh& mesh, std::string& error);

  int GetNumberOfFaces() const override { return static_cast<int>(this->Faces.size()); }
  std::array<int, 3> GetMergedPoints(int face) const override { return this->Faces[face].Merged; }
  std::vector<int> FindEdges(const SurfaceEdges& edges) const override;
  PointBox GetBox(int face) const override { return this->Boxes[face]; }
  FaceDeviations Measure(int face, const std::array<float, 3>& tags) override;

private:
  struct Face
  {
    int Cell; // among the triangles
    int OrderCode;
    std::array<int, 3> Order;  // corners of the cell that the sorted corners are
    std::array<int, 3> Merged; // merged points of the sorted corners
  };

  void FindBoxes();
  void FindErrors(vtkPolyData* mesh);

  std::shared_ptr<const PatternFamily> Family;
  int MaximumLevel;
  MicroMesh Micro;
  std::vector<Face> Faces;
  std::vector<PointBox> Boxes;
  std::vector<std::array<float, LargestMicroLevel + 1>> Errors; // per cell and level
  MeasuredPatterns Patterns;
};
}

#endif
