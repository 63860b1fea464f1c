// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ProcessAgreement
 * @brief   the data that mappers of several processes share, each with pieces of the same surfaces
 *
 * Collective: all processes call it in the same order, including those without pieces. Private to
 * the module.
 */
#ifndef ProcessAgreement_h
#define ProcessAgreement_h

#include "Changes/Dependencies.h" // for members
#include "View/RefinementView.h"

#include <functional> // for parts
#include <map>        // for parts

class vtkAdaptiveRefinement;
class vtkMultiProcessController;
class vtkPolyData;

namespace relevo
{
class PieceReduction;
class RefinementState;

/// A piece of this process.
struct ProcessAgreementPart
{
  vtkPolyData* Input;
  RefinementState* State;
  /// Prepares the mesh and returns whether it is valid.
  std::function<bool()> UpdateMesh;
};

class ProcessAgreement
{
public:
  /// Parts by flat index.
  using Parts = std::map<unsigned int, ProcessAgreementPart>;

  /// Set the controller. Return whether there are several processes; without a controller (nullptr)
  /// there is one.
  bool SetController(vtkMultiProcessController* controller);
  bool IsActive() const { return this->Active; }
  /// Return whether no data are shared.
  bool IsEmpty() const { return this->WholeDependencies.IsEmpty(); }

  /// Update the shared data of the surfaces, if something has changed in any process.
  void Update(vtkAdaptiveRefinement* recipe, RefinementView view, const Parts& parts,
    const PieceReduction& pieces);

  /// Treat each part as a whole surface.
  void Clear(const Parts& parts);

private:
  bool Active = false; // as of the last frame's start
  Dependencies WholeDependencies;
};
}

#endif
