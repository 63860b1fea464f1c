// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VolumeProp
 * @brief   a volume of ParaView's representations without levels of detail
 *
 * The base class draws nothing if the input is composite or lacks the array. This class always
 * calls the mapper, which draws composite inputs and reports missing arrays. If the volume is
 * composited with those of other ranks, VolumeCompositing draws it instead.
 *
 * Private to the module.
 */
#ifndef VolumeProp_h
#define VolumeProp_h

#include "vtkPVLODVolume.h"

namespace relevo
{
class VolumeProp : public vtkPVLODVolume
{
public:
  static VolumeProp* New();
  vtkTypeMacro(VolumeProp, vtkPVLODVolume);

  void SetComposited(bool isComposited) { this->Composited = isComposited; }
  bool IsComposited() const { return this->Composited; }

  void SetMapper(vtkAbstractVolumeMapper* mapper) override;
  vtkAbstractVolumeMapper* GetMapper() override;
  void SetProperty(vtkVolumeProperty* property) override;
  double* GetBounds() override;

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int HasTranslucentPolygonalGeometry() override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  void SetAllocatedRenderTime(double time, vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  VolumeProp() = default;
  ~VolumeProp() override = default;

private:
  VolumeProp(const VolumeProp&) = delete;
  void operator=(const VolumeProp&) = delete;

  bool Composited = false;
};
}

#endif
