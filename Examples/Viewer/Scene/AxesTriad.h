// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   AxesTriad
 * @brief   the directions of the x, y and z axes, in the lower right corner above the scale bar
 */
#ifndef AxesTriad_h
#define AxesTriad_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkActor2D;
class vtkObject;
class vtkPoints;
class vtkRenderer;
class vtkTextActor;

class AxesTriad
{
public:
  /// Must not outlive the renderer.
  explicit AxesTriad(vtkRenderer* renderer);
  ~AxesTriad();
  AxesTriad(const AxesTriad&) = delete;
  void operator=(const AxesTriad&) = delete;

private:
  struct Axis
  {
    vtkNew<vtkPoints> Points; // the ends, in pixels
    vtkNew<vtkActor2D> Line;
    vtkSmartPointer<vtkTextActor> Letter;
  };
  void OnStart(vtkObject* caller, unsigned long event, void* data);

  vtkRenderer* Renderer;
  std::array<Axis, 3> Axes;
  unsigned long Tag;
};

#endif
