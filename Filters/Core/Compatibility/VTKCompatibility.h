// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   differences between the VTK releases 9.1 to 9.6
 *
 * Differences in the loader of OpenGL functions are in RelevoOpenGL.h, because filters do not use
 * OpenGL.
 */
#ifndef VTKCompatibility_h
#define VTKCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
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
 * Whether the algorithm must stop. Since VTK 9.3, this includes the abort of an algorithm that it
 * is part of or depends on.
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
 * Whether VTK's mapper draws visible vertices in every representation and in picking. Up to VTK
 * 9.4, it draws them only together with the edges of surfaces.
 */
constexpr bool VerticesNeedNoEdges = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0);

/**
 * Whether VTK's mapper reads the time of its last program if it cannot build a new one. That
 * program must then exist. Since VTK 9.3, the mapper continues with the last program.
 */
constexpr bool AsksLastProgram = VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0);

/**
 * The vertex attribute with the texture coordinates for colours from a lookup table.
 */
constexpr const char* ColorCoordinates =
  VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0) ? "colorTCoord" : "tcoord";

/**
 * Get the points of a cell. Returns false if the offsets are out of range, which VTK does not
 * check. May be called from several threads with separate lists.
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
 * Copy a data object with blocks of its own, which share the arrays. Until VTK 9.2, ShallowCopy()
 * shares the blocks.
 */
inline void CopyWithOwnBlocks(vtkDataObject* from, vtkDataObject* to)
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(to))
  {
    composite->RecursiveShallowCopy(from);
    return;
  }
#endif
  to->ShallowCopy(from);
}

/**
 * Get the points at the corners of a polyhedron's faces. Returns false if the grid's lists of faces
 * are invalid, which VTK does not check. Since VTK 9.4, they are two vtkCellArrays. Each thread
 * needs a separate `scratch`.
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
  // The number of faces, then for each face its number of points and these points.
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
// Since VTK 9.6, the types may have another class, and the function has another name.
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
 * The number of cells that have a type, which is less than the number of cells if the list is too
 * short.
 */
inline vtkIdType GetNumberOfCellTypes(vtkUnstructuredGrid* grid)
{
  return detail::CountCellTypes(grid, 0);
}
}

#endif
