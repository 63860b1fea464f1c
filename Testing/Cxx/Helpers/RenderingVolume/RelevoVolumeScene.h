// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// A window that shows a volume by vtkGPUUnstructuredGridVolumeMapper, to compare with what
// vtkVolumeRayCastFilter makes of the same.
#ifndef RelevoVolumeScene_h
#define RelevoVolumeScene_h

#include "RelevoVolumes.h"

#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

// Nodes here and there between 0 and 1, some of them close to each other.
vtkSmartPointer<vtkVolumeProperty> MakeBusyProperty(double unitDistance);

// A field between 0 and 1.
double GetWaves(const RelevoPoint& at);

// Tetrahedra of points in a ball around low, slivers among them, with that field around 0.
vtkSmartPointer<vtkUnstructuredGrid> MakeBall(int numberOfPoints, double low = 0.0);

class RelevoVolumeScene
{
public:
  // Black behind, no multisampling; an oblique camera that sees all.
  RelevoVolumeScene(
    vtkDataObject* mesh, vtkVolumeProperty* property, int width = 160, int height = 120);

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

private:
  vtkNew<vtkGPUUnstructuredGridVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

#endif
