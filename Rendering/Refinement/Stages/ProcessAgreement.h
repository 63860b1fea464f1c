// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ProcessAgreement
 * @brief   what the mappers of several processes agree on, each with pieces of the same surfaces
 *
 * Collective: all processes call it in the same order, whatever they have. Private to the module.
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

/// A piece that this process has.
struct ProcessAgreementPart
{
  vtkPolyData* Input;
  RefinementState* State;
  /// Prepares the mesh; whether it is valid.
  std::function<bool()> UpdateMesh;
};

class ProcessAgreement
{
public:
  /// By flat index.
  using Parts = std::map<unsigned int, ProcessAgreementPart>;

  /// Whether there are several processes. Without a controller (nullptr) there are not.
  bool SetController(vtkMultiProcessController* controller);
  bool IsActive() const { return this->Active; }
  /// Whether nothing has been agreed on.
  bool IsEmpty() const { return this->WholeDependencies.IsEmpty(); }

  /// Agree on what the pieces are parts of, if something has changed in any process.
  void Update(vtkAdaptiveRefinement* recipe, RefinementView view, const Parts& parts,
    const PieceReduction& pieces);

  /// Each part is the whole.
  void Clear(const Parts& parts);

private:
  bool Active = false; // before each frame
  Dependencies WholeDependencies;
};
}

#endif
