// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window in which vtkAdaptiveLICMapper shows its LIC as grey values, and pictures of it.
#ifndef RelevoLICScene_h
#define RelevoLICScene_h

#include "RelevoFlowImages.h"
#include "RelevoScene.h"
#include "RelevoTestMeshes.h"

#include "vtkAdaptiveLICMapper.h"

// A picture of a LIC: grey values, and values above 1 without LIC.
struct RelevoLICPicture
{
  explicit RelevoLICPicture(vtkRenderWindow* window);
  // Masked pixels are red.
  explicit RelevoLICPicture(const RelevoPicture& picture);

  bool HasLIC(int column, int row) const { return this->Grey.At(column, row) <= 1.0; }
  // Whether this pixel and all pixels up to `reach` away have LIC.
  bool HasLIC(int column, int row, int reach) const;
  double GetDepth(int column, int row) const;
  // Fills pixels without LIC with the mean of the noise.
  RelevoGrey GetFilled() const;
  std::size_t CountLIC() const;

  RelevoGrey Grey;
  std::vector<float> Depths;
};

// Similarity of two LIC pictures where both have a LIC.
struct RelevoLikeness
{
  double SSIM = 0.0;           // 1 for equal pictures
  double MeanDifference = 1.0; // mean absolute difference
  std::size_t Count = 0;       // number of pixels
  std::size_t OneSided = 0;    // pixels where only one picture has LIC
  std::size_t Different = 0;   // pixels that differ by more than the rounding of 8 bits
};

std::ostream& operator<<(std::ostream& os, const RelevoLikeness& likeness);

// Mean SSIM of windows of 8 x 8 pixels, 4 pixels apart, that have LIC in both pictures.
RelevoLikeness CompareLIC(const RelevoGrey& a, const RelevoGrey& b);

RelevoLikeness CompareLIC(const RelevoLICPicture& a, const RelevoLICPicture& b);

// Actors are white and unlit and show only the LIC. Masked pixels are red.
class RelevoLICScene
{
public:
  RelevoLICScene(int width, int height);

  // Without a recipe the mesh is drawn unrefined.
  vtkAdaptiveLICMapper* Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);

  // A parallel camera that maps units of the x-y plane to pixels, from (0, 0).
  void LookAtPixels();

  RelevoLICPicture Render();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkActor* Actor = nullptr; // the last one added
};

// A mesh in the x-y plane whose points are `spacing` apart at pixels' centres, with one point
// beyond the image. The field gives the vectors "Flow".
vtkSmartPointer<vtkPolyData> MakePixelMesh(
  int columns, int rows, int spacing, const RelevoField& field);

#endif
