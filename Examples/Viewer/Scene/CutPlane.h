// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   CutPlane
 * @brief   the plane of --clip, which keys move
 */
#ifndef CutPlane_h
#define CutPlane_h

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkPlane;
class ViewerMessages;
class vtkRenderer;

class CutPlane
{
public:
  /// Takes the six numbers of the option, or nothing for no plane.
  explicit CutPlane(const std::optional<std::vector<double>>& numbers);
  ~CutPlane();

  /// Sets the six numbers of the option.
  void Set(const std::vector<double>& numbers);

  /// nullptr for none. The part on the side of the normal is visible.
  vtkPlane* Get() const;

  /**
   * Handles a key of the window: m moves the plane away from where it started, n back. Returns
   * false for other keys. Without a plane, there is then one on the camera's side of the bounds,
   * across the axis closest to the view direction.
   */
  bool Move(char key, const double bounds[6], vtkRenderer* renderer);

  /// Warns if nothing within the bounds is on the visible side.
  void WarnIfEmpty(const double bounds[6], ViewerMessages& messages) const;

  /// The option that repeats the plane.
  std::string GetOption() const;

private:
  void Start(const double bounds[6], vtkRenderer* renderer);

  vtkSmartPointer<vtkPlane> Plane;
};

#endif
