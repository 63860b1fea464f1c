// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window that shows a volume by vtkGPUUnstructuredGridVolumeMapper, compared with
// vtkVolumeRayCastFilter.
#ifndef RelevoVolumeScene_h
#define RelevoVolumeScene_h

#include "RelevoBusyVolumes.h"
#include "RelevoVolumes.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

class RelevoVolumeScene
{
public:
  // A black background without multisampling, and an oblique camera that shows everything.
  RelevoVolumeScene(
    vtkDataObject* mesh, vtkVolumeProperty* property, int width = 160, int height = 120);

  // The method of mappers in new scenes. By default rays are cast.
  static void SetMethod(int method) { Method = method; }
  // Runs the test with ray casting and with cell projection.
  static void ForBothMethods(const std::function<void()>& test);

  vtkGPUUnstructuredGridVolumeMapper* GetMapper() { return this->Mapper; }
  vtkVolume* GetVolume() { return this->Volume; }
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }

  // Row after row, premultiplied over black, without alpha.
  std::vector<RelevoColor> Draw();

  // The same picture by the filter, with additional settings.
  std::vector<RelevoColor> Cast(
    const std::function<void(vtkVolumeRayCastFilter*)>& set = [](vtkVolumeRayCastFilter*) {});

  // Largest difference in units of 1/255, without this share of the pixels.
  double Compare(
    double share = 0.0,
    const std::function<void(vtkVolumeRayCastFilter*)>& set = [](vtkVolumeRayCastFilter*) {});

  // The same for two given pictures.
  static double Compare(const std::vector<RelevoColor>& drawn, const std::vector<RelevoColor>& cast,
    double share = 0.0);

private:
  static int Method;
  vtkNew<vtkGPUUnstructuredGridVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

// A parallel view of a cube from 0 to 1 in a window of 97 x 97 pixels. Rays are 1/48 apart: those
// in columns and rows 25 to 71 hit the cube, and some run along edges of cells.
void LookAlongEdges(RelevoVolumeScene& scene);

#endif
