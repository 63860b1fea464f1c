// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   FeatureSelector
 * @brief   the stage that finds what shaders have to do, and the planes and lights that they need
 *
 * Private to the module.
 */
#ifndef FeatureSelector_h
#define FeatureSelector_h

#include "Checks/StageReport.h"
#include "Shaders/VolumeShader.h"
#include "View/MeshPlanes.h"
#include "View/VolumeLights.h"

#include <string>

class vtkPlaneCollection;
class vtkRenderer;
class vtkVolumeProperty;

namespace relevo
{
struct VolumeFunctions;
struct VolumeMesh;

struct FeatureRequest
{
  vtkRenderer* Renderer;
  vtkVolumeProperty* Property;
  vtkPlaneCollection* Planes;
  const VolumeMesh& Mesh;
  const VolumeFunctions& Functions;
  const dmat4& MeshToWorld;
  BlendMode Blending;
  bool HasSurfaces;    // isosurfaces inside the volume, with composite blending
  int TableDimensions; // of pre-integration, 0 for none
};

struct VolumeFeatures
{
  VolumeShaderOptions Options;
  MeshPlanes Planes;
  VolumeLights Lights;
};

class FeatureSelector
{
public:
  /// Find the features of this frame. What the request asks for in vain is reported once.
  void Update(const FeatureRequest& request, StageReport& report);

  const VolumeFeatures& GetFeatures() const { return this->Features; }

private:
  void FindSurfaces(const FeatureRequest& request, StageReport& report);
  void FindPlanes(const FeatureRequest& request, StageReport& report);
  void FindTable(const FeatureRequest& request, StageReport& report);

  VolumeFeatures Features;
  // As reported.
  std::string MissingSurfaces;
  std::string PlaneError;
  std::string TableError;
};
}

#endif
