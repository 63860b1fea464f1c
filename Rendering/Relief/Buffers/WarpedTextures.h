// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   WarpedTextures
 * @brief   the images of vtkReliefWarper for the camera, as textures on the relief's plane
 *
 * Private to the module.
 */
#ifndef WarpedTextures_h
#define WarpedTextures_h

#include "Mathematics/RefinementMathematics.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkCamera;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkReliefWarper;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace relevo
{
class ReliefTiles;

class WarpedTextures
{
public:
  WarpedTextures();
  ~WarpedTextures();
  WarpedTextures(const WarpedTextures&) = delete;
  void operator=(const WarpedTextures&) = delete;

  void SetRelief(vtkImageData* image, double maximumStretch);

  /// Warp the relief if the camera has moved. Return false if the camera does not see the plane, or
  /// if OpenGL lacks memory.
  bool Update(vtkRenderer* renderer, vtkActor* actor, const ReliefTiles& tiles);

  void Activate(vtkShaderProgram* program, const ReliefTiles& tiles);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  bool HasNormals() const { return this->Normals != nullptr; }
  int GetNumberOfWarps() const;
  vtkTypeInt64 GetMemorySize() const { return this->MemorySize; }

private:
  void MoveCamera(vtkRenderer* renderer, vtkActor* actor);
  bool Upload(vtkOpenGLRenderWindow* window, const ReliefTiles& tiles);

  vtkNew<vtkReliefWarper> Warper;
  vtkNew<vtkCamera> Eye; // the renderer's camera, in coordinates of the actor
  int UploadedWarp = 0;
  dvec4 Coefficients = dvec4(0.0); // k1, k2, k3 and the height of the plane
  ivec2 Size = ivec2(0);
  vtkSmartPointer<vtkTextureObject> Heights;
  vtkSmartPointer<vtkTextureObject> Colors;
  vtkSmartPointer<vtkTextureObject> Normals;
  vtkTypeInt64 MemorySize = 0;
};
}

#endif
