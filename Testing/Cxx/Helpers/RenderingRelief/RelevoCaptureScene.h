// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window that is captured, and what the reliefs say, read by the words of their format alone.
#ifndef RelevoCaptureScene_h
#define RelevoCaptureScene_h

#include "RelevoScene.h"
#include "RelevoVector.h"

#include "vtkReliefCapture.h"

#include <vector>

class vtkImageData;

// A texel that shows something.
struct RelevoTexel
{
  int Column;
  int Row;
  RelevoVectors::Vector Point; // in the world
  double Width;                // of the texel there
  unsigned char Color[3];
  RelevoVectors::Vector Normal; // 0 without normals
};

// A window without multisamples and a renderer whose only light is of the scene.
class RelevoCaptureScene
{
public:
  explicit RelevoCaptureScene(int width = 200, int height = 150);

  vtkActor* Add(vtkPolyData* mesh);

  // The renderer's camera, which sees all from an oblique direction.
  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }
  void ResetCamera();

  // A block of what is captured now; nullptr if there is none.
  vtkImageData* Capture(unsigned int block = 0);

  // What a window of this size shows from the camera.
  RelevoPicture Draw(vtkCamera* camera, int width, int height);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkReliefCapture> Source; // of the renderer
};

std::vector<RelevoTexel> RelevoReadTexels(vtkImageData* relief);

// A ball with bumps, its triangles flat or smooth.
vtkSmartPointer<vtkPolyData> RelevoBumpyBall(int resolution = 60);

#endif
