// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PictureMarks
 * @brief   labelled points and distances over a picture
 *
 * Marks are visible through the data, because they follow the camera as 2D shapes.
 */
#ifndef PictureMarks_h
#define PictureMarks_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkActor2D;
class vtkObject;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

class PictureMarks
{
public:
  /// Must not outlive the renderer.
  explicit PictureMarks(vtkRenderer* renderer);
  ~PictureMarks();
  PictureMarks(const PictureMarks&) = delete;
  void operator=(const PictureMarks&) = delete;

  void Clear();
  /// Adds a cross with a label beside it.
  void AddPoint(const std::array<double, 3>& point, const std::string& text);
  /// Adds a line between two points, with a label at its middle.
  void AddLine(const std::array<double, 3>& first, const std::array<double, 3>& second,
    const std::string& text);

private:
  struct Mark
  {
    std::array<double, 3> Ends[2]; // equal for a point
    bool IsLine;
    vtkSmartPointer<vtkTextActor> Label;
  };
  void Add(const Mark& mark, const std::string& text);
  void OnStart(vtkObject* caller, unsigned long event, void* data);

  vtkRenderer* Renderer;
  std::vector<Mark> Marks;
  vtkNew<vtkPolyData> Shape; // lines, in pixels
  vtkNew<vtkActor2D> Actor;
  unsigned long Tag;
};

#endif
