// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window that shows a volume by vtkGPUUnstructuredGridVolumeMapper, to compare with what
// vtkVolumeRayCastFilter makes of the same.
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
  // Black behind, no multisampling; an oblique camera that sees all.
  RelevoVolumeScene(
    vtkDataObject* mesh, vtkVolumeProperty* property, int width = 160, int height = 120);

  // Of the mappers of scenes to come; rays are cast by default.
  static void SetMethod(int method) { Method = method; }
  // Test twice, with rays and with cell projection.
  static void ForBothMethods(const std::function<void()>& test);

  vtkGPUUnstructuredGridVolumeMapper* GetMapper() { return this->Mapper; }
  vtkVolume* GetVolume() { return this->Volume; }
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkCamera* GetCamera() { return this->Renderer->GetActiveCamera(); }

  // Row after row, premultiplied over black, without alpha.
  std::vector<RelevoColor> Draw();

  // The same by the filter, whose further settings are given.
  std::vector<RelevoColor> Cast(
    const std::function<void(vtkVolumeRayCastFilter*)>& set = [](vtkVolumeRayCastFilter*) {});

  // How far the two are apart, in parts of 255: at all pixels but this share of them.
  double Compare(
    double share = 0.0,
    const std::function<void(vtkVolumeRayCastFilter*)>& set = [](vtkVolumeRayCastFilter*) {});

  // The same of a picture that was drawn and one that was cast.
  static double Compare(const std::vector<RelevoColor>& drawn, const std::vector<RelevoColor>& cast,
    double share = 0.0);

private:
  static int Method;
  vtkNew<vtkGPUUnstructuredGridVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

// In parallel, at a cube from 0 to 1 in a window of 97 x 97 pixels: rays are 1/48 apart, so that
// those in columns and rows 25 to 71 hit the cube, and some run along its cells' edges.
void LookAlongEdges(RelevoVolumeScene& scene);

#endif
