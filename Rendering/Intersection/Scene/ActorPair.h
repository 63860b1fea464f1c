// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ActorPair
 * @brief   where the surfaces of two actors meet, computed anew when one has moved
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

  /// Look at actors that have surfaces, refined by their recipes or not; whether they were
  /// intersected.
  bool Update(const SceneActor& first, const SceneActor& second, bool isRefined, double tolerance);

  /// Another object whenever they were intersected; nullptr where they do not touch.
  const vtkSmartPointer<vtkPolyData>& GetCurves() const { return this->Curves; }
  //@{
  /// Of the last intersection, when they are others than before.
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
