// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window to capture, and its reliefs, read by their documented format only.
#ifndef RelevoCaptureScene_h
#define RelevoCaptureScene_h

#include "RelevoScene.h"
#include "RelevoVector.h"

#include "vtkReliefCapture.h"

#include <vector>

class vtkImageData;

// A texel with a surface.
struct RelevoTexel
{
  int Column;
  int Row;
  RelevoVectors::Vector Point; // in the world
  double Width;                // the texel's width at this point
  unsigned char Color[3];
  RelevoVectors::Vector Normal; // zero without normals
};

// A window without multisampling and a renderer whose only light is a scene light.
class RelevoCaptureScene
{
public:
  explicit RelevoCaptureScene(int width = 200, int height = 150);

  vtkActor* Add(vtkPolyData* mesh);

  // The renderer's camera, which shows everything from an oblique direction.
  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }
  void ResetCamera();

  // Captures and returns a block of the output, or nullptr.
  vtkImageData* Capture(unsigned int block = 0);

  // The picture of a window of this size from the camera.
  RelevoPicture Draw(vtkCamera* camera, int width, int height);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkReliefCapture> Source; // captures the renderer
};

std::vector<RelevoTexel> RelevoReadTexels(vtkImageData* relief);

// A ball with bumps and flat or smooth triangles.
vtkSmartPointer<vtkPolyData> RelevoBumpyBall(int resolution = 60);

#endif
