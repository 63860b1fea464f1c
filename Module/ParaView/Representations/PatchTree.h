// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PatchTree
 * @brief   converts a tree of curved faces to a tree of patches
 *
 * Patches are field data, so they cannot be merged or sent in parts. Views deliver curved faces as
 * polygons instead, see FacePolygons.h.
 *
 * Private to the module.
 */
#ifndef PatchTree_h
#define PatchTree_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace relevo
{
class PatchTree
{
public:
  /**
   * Return the patches of faces, which may be nullptr. They stay the same objects until the faces
   * change.
   */
  vtkDataObject* Make(vtkDataObject* faces);

  /// The warnings of the last call.
  const std::string& GetWarnings() const { return this->Warnings; }

private:
  struct Leaf
  {
    vtkSmartPointer<vtkPolyData> Faces;
    vtkMTimeType Time;
    vtkSmartPointer<vtkPolyData> Patches;
    std::string Warning;
  };

  const Leaf& MakeLeaf(vtkPolyData* faces, std::vector<Leaf>& previous);

  vtkSmartPointer<vtkDataObject> Faces;
  vtkMTimeType Time = 0;
  std::vector<Leaf> Leaves;
  vtkSmartPointer<vtkDataObject> Patches;
  std::string Warnings;
};

/// Return the patches of faces, and for each triangle the cell of `faces`.
vtkSmartPointer<vtkPolyData> MakePatches(vtkPolyData* faces, std::vector<vtkIdType>& cells);
}

#endif
