// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MicroMeshAppender
 * @brief   joins micro-meshes of blocks to one
 *
 * Blocks match at fixed points. Normals there are those of the faces of all blocks.
 */
#ifndef MicroMeshAppender_h
#define MicroMeshAppender_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkSmartPointer.h" // for members
#include "vtkType.h"         // for vtkIdType

#include <array>  // for keys
#include <map>    // for members
#include <string> // for errors
#include <vector> // for members

class vtkPolyData;

namespace relevo
{
class MicroMeshAppender
{
public:
  MicroMeshAppender();
  ~MicroMeshAppender();

  /// Append a micro-mesh. The point array FixedPointsName marks the fixed points. Returns false and
  /// an error for the user if it does not have the arrays of the others.
  bool Append(vtkPolyData* block, std::string& error);

  /// Move the joined micro-mesh to the output, without FixedPointsName and ids of cells.
  void Finish(vtkPolyData* output);

private:
  struct Border // at a fixed point
  {
    dvec3 Normal = dvec3(0.0);
    std::vector<vtkIdType> Points;
  };

  void AddNormals(vtkPolyData* block);

  vtkSmartPointer<vtkPolyData> Joined;
  std::map<std::array<double, 3>, Border> Borders;
  int NumberOfLevels = 0; // components of the level errors
};
}

#endif
