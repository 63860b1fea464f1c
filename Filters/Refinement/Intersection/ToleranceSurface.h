// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::ToleranceSurface
 * @brief   the surface that a recipe creates from a mesh, refined to a tolerance where needed
 *
 * Each coarse face has a box that contains all its refined points, so that your filter can find the
 * relevant faces before anything is refined. These faces are then refined with the recipe's
 * patterns until their triangles are within the tolerance of the surface. Other faces are refined
 * only along edges that they share with them. The recipe's metric is not used.
 */
#ifndef ToleranceSurface_h
#define ToleranceSurface_h

#include "RelevoFiltersRefinementModule.h" // for export macro
#include "vtkSmartPointer.h"               // for members
#include "vtkTimeStamp.h"                  // for members
#include "vtkType.h"                       // for vtkIdType

#include <memory>  // for members
#include <string>  // for errors
#include <utility> // for std::pair
#include <vector>  // for members

class vtkAdaptiveRefinement;
class vtkPolyData;

namespace relevo
{
class RELEVOFILTERSREFINEMENT_EXPORT ToleranceSurface
{
public:
  ToleranceSurface();
  ~ToleranceSurface();
  ToleranceSurface(const ToleranceSurface&) = delete;
  void operator=(const ToleranceSurface&) = delete;

  /// Set the mesh and its recipe. Data that are not out of date are reused. Returns false and an
  /// error for the user if the mesh cannot be refined. A warning may be returned in either case.
  bool Take(
    vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, std::string& error, std::string& warning);

  /// Return the time when the mesh last changed.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

  int GetNumberOfFaces() const;
  /// The box of a face, in the coordinates of the mesh.
  void GetFaceBounds(int face, double low[3], double high[3]) const;

  /// Refine the faces marked in `areWanted`, one byte per face, whose deviation exceeds the
  /// tolerance, a length in the mesh's units. Returns the number of faces that deviate by more than
  /// the tolerance at the highest number of segments, and the largest deviation. A tolerance of 0
  /// refines all edges of these faces to the highest number of segments and returns 0.
  std::pair<vtkIdType, double> Refine(
    const std::vector<unsigned char>& areWanted, double tolerance);

  /// The triangles of all faces, in a new object after each change. Triangles over missing data,
  /// with non-finite points or with coincident points are removed.
  vtkPolyData* GetTriangles() const;
  /// The ids of the coarse cells of the triangles.
  const std::vector<vtkIdType>& GetCells() const { return this->Cells; }

private:
  void BuildTriangles();
  void BuildPoints(const std::vector<vtkIdType>& firstPoints, std::vector<double>& points) const;

  struct Internals;
  std::unique_ptr<Internals> Data;
  vtkTimeStamp BuildTime;
  vtkSmartPointer<vtkPolyData> Triangles;
  std::vector<vtkIdType> Cells;
};
}

#endif
