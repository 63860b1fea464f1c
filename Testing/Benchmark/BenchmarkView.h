// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkView
 * @brief   a window with one renderer, and the clock for its frames
 *
 * By default 1024 x 768 pixels without multisampling. Before measurements, the context is created
 * and an empty frame is drawn.
 */
#ifndef BenchmarkView_h
#define BenchmarkView_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkRenderWindow;
class vtkRenderer;

class BenchmarkView
{
public:
  explicit BenchmarkView(int width = 1024, int height = 768);
  ~BenchmarkView();
  BenchmarkView(const BenchmarkView&) = delete;
  void operator=(const BenchmarkView&) = delete;

  /// Adds a visible actor for the mapper.
  vtkSmartPointer<vtkActor> AddActor(vtkMapper* mapper);

  /// Looks at bounds obliquely from above, so that they fill the view.
  void LookAt(const double bounds[6]);
  /// Looks in the opposite direction, so that nothing is visible.
  void LookAway();
  /// Turns the camera slightly around its focal point.
  void MoveCamera(double degrees = 0.5);

  /// Wall clock seconds from the call to the finished picture.
  double TimeFrame();

  /// The picture of the last frame as RGB bytes.
  std::vector<unsigned char> GetPicture();
  /// The depths of the last frame, 1 for the background.
  std::vector<float> GetDepths();

  /// The renderer's name, OpenGL's version, and whether it is hardware or software.
  std::string GetOpenGLRenderer();
  vtkRenderer* GetRenderer() { return this->Renderer; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

private:
  int Width;
  int Height;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

#endif
