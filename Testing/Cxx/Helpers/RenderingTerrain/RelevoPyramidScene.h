// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A raster file that vtkTerrainMapper draws completely, in a black window without multisampling.
#ifndef RelevoPyramidScene_h
#define RelevoPyramidScene_h

#include "RelevoScene.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainMapper.h"
#include "vtkTerrainPyramid.h"

#include <string>

class RelevoPyramidScene
{
public:
  explicit RelevoPyramidScene(const std::string& file, int width = 400, int height = 300)
  {
    this->Pyramid->SetFileName(file.c_str());
    this->Mapper->SetPyramid(this->Pyramid);
    this->Mapper->SetLoadingModeToComplete();
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Window->AddRenderer(this->Renderer);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
  }

  RelevoPicture Draw()
  {
    this->Window->Render();
    return RelevoPicture(this->Window);
  }

  // Draws, and counts the pixels of unlit red lines and areas.
  size_t CountRed()
  {
    const RelevoPicture picture = this->Draw();
    size_t red = 0;
    for (size_t i = 0; i < picture.GetNumberOfPixels(); ++i)
    {
      red += picture.Colors[3 * i] == 255 && picture.Colors[3 * i + 2] == 0 ? 1 : 0;
    }
    return red;
  }

  vtkNew<vtkTerrainPyramid> Pyramid;
  vtkNew<vtkTerrainMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

#endif
