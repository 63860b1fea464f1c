// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ActorPair
 * @brief   the intersection of two actors' surfaces, updated when one of them has moved
 */
#ifndef ActorPair_h
#define ActorPair_h

#include "Changes/Dependencies.h"         // for members
#include "vtkNew.h"                       // for members
#include "vtkPolyData.h"                  // for members
#include "vtkSmartPointer.h"              // for members
#include "vtkSurfaceIntersectionFilter.h" // for members

#include <string> // for members

namespace relevo
{
class SceneActor;

class ActorPair
{
public:
  ActorPair();

  /// Update the intersection of actors that have surfaces, refined by their recipes or not. Return
  /// whether they were intersected.
  bool Update(const SceneActor& first, const SceneActor& second, bool isRefined, double tolerance);

  /// Return the curves, a new object after each intersection; nullptr if the surfaces do not touch.
  const vtkSmartPointer<vtkPolyData>& GetCurves() const { return this->Curves; }
  //@{
  /// Return the messages of the last intersection, if they differ from the previous ones.
  const std::string& GetNewErrors() const { return this->NewErrors; }
  const std::string& GetNewWarnings() const { return this->NewWarnings; }
  //@}

private:
  vtkNew<vtkSurfaceIntersectionFilter> Filter;
  Dependencies Inputs;
  vtkSmartPointer<vtkPolyData> Curves;
  std::string Errors;
  std::string NewErrors;
  std::string Warnings;
  std::string NewWarnings;
  std::string Ignored;
};
}

#endif
