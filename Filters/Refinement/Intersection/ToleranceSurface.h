// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   relevo::ToleranceSurface
 * @brief   the surface that a recipe makes of a mesh, refined to a tolerance where it is wanted
 *
 * Each coarse face has a box that all its refined points are in, so that filters of your own can
 * tell where the surface matters before any of it is refined. Faces that are wanted are then
 * refined by the recipe's patterns until their triangles are as near to the surface as is asked;
 * the others follow where they share an edge. The recipe's metric does not count.
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

  /// Take a mesh and its recipe; what has not changed since the last call is kept. False, with a
  /// sentence to show the user, where it cannot be refined; a warning may be filled either way.
  bool Take(
    vtkPolyData* mesh, vtkAdaptiveRefinement* recipe, std::string& error, std::string& warning);

  /// When a mesh was taken that differed from the one before.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

  int GetNumberOfFaces() const;
  /// The box of a face in the mesh's coordinates.
  void GetFaceBounds(int face, double low[3], double high[3]) const;

  /// Refine those faces, a byte for each, whose deviation is more than the tolerance, a length of
  /// the mesh. Returns how many of them deviate by more than the tolerance though their edges have
  /// as many segments as can be, and the largest deviation. With a tolerance of 0, all edges of
  /// these faces have as many, and the result is 0.
  std::pair<vtkIdType, double> Refine(
    const std::vector<unsigned char>& areWanted, double tolerance);

  /// The triangles of all faces; another object when they have changed. Those over no-data, and
  /// those with a point that is not finite or two that are one, are left out.
  vtkPolyData* GetTriangles() const;
  /// The ids of the cells that they are of.
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
