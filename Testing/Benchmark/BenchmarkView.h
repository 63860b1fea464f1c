// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   BenchmarkView
 * @brief   a window with one renderer, and the clock that frames are timed with
 *
 * 1024 x 768 pixels, unless told otherwise, without multisampling; the context is made, and one
 * empty frame drawn, before anything is measured.
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

  /// A visible actor for the mapper.
  vtkSmartPointer<vtkActor> AddActor(vtkMapper* mapper);

  /// Look at bounds obliquely from above, so that they fill the view.
  void LookAt(const double bounds[6]);
  /// Look the other way, so that nothing is in the picture.
  void LookAway();
  /// Turn the camera a little around what it looks at.
  void MoveCamera(double degrees = 0.5);

  /// Seconds of wall clock from the call to the finished picture.
  double TimeFrame();

  /// The picture of the last frame: RGB, bytes.
  std::vector<unsigned char> GetPicture();
  /// Its depths, 1 where nothing is.
  std::vector<float> GetDepths();

  /// Its name, OpenGL's version, and whether it is hardware or software.
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
