// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window in which vtkAdaptiveLICMapper shows its LIC as greys, and what is to be seen there.
#ifndef RelevoLICScene_h
#define RelevoLICScene_h

#include "RelevoFlowImages.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveLICMapper.h"

// A picture of LIC: greys, and more than 1 where there is none.
struct RelevoLICPicture
{
  explicit RelevoLICPicture(vtkRenderWindow* window);
  // Masked places are red.
  explicit RelevoLICPicture(const RelevoPicture& picture);

  bool HasLIC(int column, int row) const { return this->Grey.At(column, row) <= 1.0; }
  // At the pixel and all up to `reach` pixels away.
  bool HasLIC(int column, int row, int reach) const;
  double GetDepth(int column, int row) const;
  // With the mean of noise where there is no LIC.
  RelevoGrey GetFilled() const;
  std::size_t CountLIC() const;

  RelevoGrey Grey;
  std::vector<float> Depths;
};

// How alike two pictures of LIC are where both have one.
struct RelevoLikeness
{
  double SSIM = 0.0;           // 1 for equal ones
  double MeanDifference = 1.0; // of absolute values
  std::size_t Count = 0;       // of pixels
  std::size_t OneSided = 0;    // of pixels where only one of them has LIC
  std::size_t Different = 0;   // of pixels further apart than roundings of 8 bits
};

std::ostream& operator<<(std::ostream& os, const RelevoLikeness& likeness);

// The mean SSIM of windows of 8 x 8 pixels that are LIC in both, 4 pixels apart.
RelevoLikeness CompareLIC(const RelevoGrey& a, const RelevoGrey& b);

RelevoLikeness CompareLIC(const RelevoLICPicture& a, const RelevoLICPicture& b);

// Actors are white without lights, and show nothing but the LIC; they are red where they are
// masked.
class RelevoLICScene
{
public:
  RelevoLICScene(int width, int height);

  // Without a recipe the mesh is drawn as it is.
  vtkAdaptiveLICMapper* Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);

  // A parallel camera for which pixels are units of the x-y plane, from (0, 0).
  void LookAtPixels();

  RelevoLICPicture Render();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkActor* Actor = nullptr; // added last
};

// A mesh on the x-y plane whose points lie `spacing` apart, one beyond the image with pixels of
// size 1, at pixels' centres; vectors "Flow" by the field.
vtkSmartPointer<vtkPolyData> MakePixelMesh(
  int columns, int rows, int spacing, const RelevoField& field);

#endif
