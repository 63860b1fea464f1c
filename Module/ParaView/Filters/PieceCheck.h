// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PieceCheck
 * @brief   finds arrays that some processes lack, and faces without finite points
 *
 * Not wrapped: for the sources of the plugin.
 */
#ifndef PieceCheck_h
#define PieceCheck_h

#include "RelevoParaViewFiltersModule.h" // for export macro
#include "vtkType.h"                     // for members

#include <map>     // for members
#include <set>     // for members
#include <string>  // for members
#include <utility> // for members
#include <vector>  // for members

class vtkDataObjectTree;
class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
class RELEVOPARAVIEWFILTERS_EXPORT PieceCheck
{
public:
  /// An array that a representation uses.
  struct Array
  {
    std::string Name;
    bool IsOfCells;
    std::string Property; // that selects it
  };
  using Leaves = std::vector<vtkPolyData*>;

  /**
   * Check the leaves of the surfaces of a tree, which may be nullptr. Collective; without a
   * controller (nullptr), this process has all pieces.
   */
  void Update(vtkDataObjectTree* tree, const std::vector<Leaves>& surfaces,
    vtkMultiProcessController* controller);

  /// Describe which processes lack one of these arrays that others have; "" if there are none.
  std::string DescribeMissing(const std::vector<Array>& used) const;

  /// Describe faces with points that are not finite; "" if there are none.
  std::string DescribeNotFinite() const;

private:
  struct Surface
  {
    std::string Name;
    std::set<int> Processes; // that have faces
    std::map<std::pair<bool, std::string>, std::set<int>> Arrays;
    std::map<int, vtkIdType> NotFinite; // number of faces per process
  };

  void Add(const std::string& facts, int process);

  std::vector<Surface> Surfaces;
  bool HasProcesses = false;
};

/// Whether all points of a face are finite.
bool IsFinite(vtkPolyData* mesh, vtkIdType size, const vtkIdType* points);
}

#endif
