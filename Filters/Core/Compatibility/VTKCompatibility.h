// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   what differs between the releases of VTK that Relevo builds with: 9.1 to 9.6
 *
 * The loader of OpenGL's functions differs as well: RelevoOpenGL.h, as filters know no OpenGL.
 */
#ifndef VTKCompatibility_h
#define VTKCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <vector> // for faces

namespace relevo
{
/**
 * Whether the algorithm is to stop: by its own flag and, since VTK 9.3, also because an algorithm
 * that it is part of or that it depends on was aborted.
 */
inline bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/**
 * Whether VTK's mapper draws the vertices of every representation, in picking as well, when they
 * are to be visible; up to VTK 9.4 it does so only together with the edges of surfaces.
 */
constexpr bool VerticesNeedNoEdges = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0);

/**
 * Whether VTK's mapper, where it cannot build a program, asks the one before for its time, which
 * must not be missing then; from VTK 9.3 on it goes on with that one.
 */
constexpr bool AsksLastProgram = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0);

/**
 * The vertex attribute that says where a texture of a lookup table has a point's colour.
 */
constexpr const char* ColorCoordinates =
  VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0) ? "colorTCoord" : "tcoord";

/**
 * The points of a cell; false where the offsets leave the list of points. Unlike VTK's own
 * function, which trusts the offsets. May be called from several threads, each with its own list.
 */
inline bool ReadCellPoints(vtkCellArray* cells, vtkIdType cell, vtkIdList* points)
{
  points->Reset();
  vtkDataArray* offsets = cells ? cells->GetOffsetsArray() : nullptr;
  vtkDataArray* ids = cells ? cells->GetConnectivityArray() : nullptr;
  if (!offsets || !ids || offsets->GetNumberOfComponents() != 1 ||
    ids->GetNumberOfComponents() != 1 || cell < 0 || cell + 1 >= offsets->GetNumberOfTuples())
  {
    return false;
  }
  const double begin = offsets->GetComponent(cell, 0);
  const double end = offsets->GetComponent(cell + 1, 0);
  if (begin < 0.0 || end < begin || end > static_cast<double>(ids->GetNumberOfTuples()))
  {
    return false;
  }
  cells->GetCellAtId(cell, points);
  return true;
}

/**
 * The points at the corners of a polyhedron's faces; false where the grid's lists of faces are
 * broken, which VTK trusts. From VTK 9.4 on they are two vtkCellArrays. `scratch` is of the
 * caller's thread.
 */
inline bool ReadPolyhedronFaces(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* scratch,
  std::vector<std::vector<vtkIdType>>& faces)
{
  faces.clear();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  if (!ReadCellPoints(grid->GetPolyhedronFaceLocations(), cell, scratch))
  {
    return false;
  }
  const std::vector<vtkIdType> numbers(scratch->begin(), scratch->end());
  for (vtkIdType number : numbers)
  {
    if (!ReadCellPoints(grid->GetPolyhedronFaces(), number, scratch))
    {
      return false;
    }
    faces.emplace_back(scratch->begin(), scratch->end());
  }
#else
  vtkIdTypeArray* locations = grid->GetFaceLocations();
  vtkIdTypeArray* stream = grid->GetFaces();
  if (!locations || !stream || cell < 0 || cell >= locations->GetNumberOfValues())
  {
    return false;
  }
  // How many faces; of each face, how many points, and these.
  const vtkIdType end = stream->GetNumberOfValues();
  vtkIdType at = locations->GetValue(cell);
  if (at < 0 || at >= end)
  {
    return false;
  }
  for (vtkIdType left = stream->GetValue(at++); left > 0; --left)
  {
    const vtkIdType corners = at < end ? stream->GetValue(at++) : -1;
    if (corners < 0 || corners > end - at)
    {
      return false;
    }
    const vtkIdType* points = stream->GetPointer(0) + at;
    faces.emplace_back(points, points + corners);
    at += corners;
  }
  static_cast<void>(scratch);
#endif
  return true;
}

namespace detail
{
// From VTK 9.6 on the types may be of another class, and the function is called otherwise.
template <typename Grid>
auto CountCellTypes(Grid* grid, int) -> decltype(grid->GetCellTypes()->GetNumberOfTuples())
{
  return grid->GetCellTypes() ? grid->GetCellTypes()->GetNumberOfTuples() : 0;
}

template <typename Grid>
vtkIdType CountCellTypes(Grid* grid, ...)
{
  return grid->GetCellTypesArray() ? grid->GetCellTypesArray()->GetNumberOfTuples() : 0;
}
}

/**
 * How many cells have a type: as many as there are, unless the list is too short.
 */
inline vtkIdType GetNumberOfCellTypes(vtkUnstructuredGrid* grid)
{
  return detail::CountCellTypes(grid, 0);
}
}

#endif
