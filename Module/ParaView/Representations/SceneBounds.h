// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   SceneBounds
 * @brief   a prop that draws nothing and has the bounds of the scene of all ranks
 *
 * IceT composites only the pixels inside the bounds of a rank's props. Reliefs of the whole scene,
 * which rank 0 draws, reach beyond its own props. The prop does not change the scene: its redraw
 * time is constant.
 *
 * Private to the module.
 */
#ifndef SceneBounds_h
#define SceneBounds_h

#include "vtkProp.h"

class vtkMultiProcessController;
class vtkRenderer;

namespace relevo
{
class SceneBounds : public vtkProp
{
public:
  static SceneBounds* New();
  vtkTypeMacro(SceneBounds, vtkProp);

  /// Set the bounds of the visible props of all ranks. Collective.
  void Set(vtkRenderer* renderer, vtkMultiProcessController* controller);
  /// Remove the bounds.
  void Clear() { this->HasBounds = false; }

  /// Return nullptr without bounds.
  double* GetBounds() override { return this->HasBounds ? this->Bounds : nullptr; }

  vtkMTimeType GetRedrawMTime() override { return 0; }

protected:
  SceneBounds() = default;
  ~SceneBounds() override = default;

private:
  SceneBounds(const SceneBounds&) = delete;
  void operator=(const SceneBounds&) = delete;

  bool HasBounds = false;
  double Bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};
}

#endif
