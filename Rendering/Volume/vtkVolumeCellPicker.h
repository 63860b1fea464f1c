// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeCellPicker
 * @brief   a vtkCellPicker that also picks volumes of cells
 *
 * vtkCellPicker ignores volumes whose data set is not a vtkImageData. This picker returns the cell
 * of volumes that are drawn by vtkGPUUnstructuredGridVolumeMapper, at the position where the
 * opacity from the front reaches OpacityThreshold, as vtkVolumeProbe does. GetCellId(),
 * GetPCoords(), GetSubId(), GetPointId() (the point with the largest weight), GetDataSet(),
 * GetMapper(), GetPickPosition() and, for composite inputs, GetFlatBlockIndex() are those of this
 * cell. GetPickNormal() points along the gradient, or to the camera without one. Everything else is
 * picked as by vtkCellPicker. The nearest pick wins, also if it is a translucent actor.
 *
 * @sa vtkVolumeProbe
 */
#ifndef vtkVolumeCellPicker_h
#define vtkVolumeCellPicker_h

#include "RelevoRenderingVolumeModule.h" // for export macro
#include "vtkCellPicker.h"

#include <memory> // for members

class vtkGPUUnstructuredGridVolumeMapper;
class vtkVolumeProperty;

namespace relevo
{
struct VolumeHit;
}

class RELEVORENDERINGVOLUME_EXPORT vtkVolumeCellPicker : public vtkCellPicker
{
public:
  static vtkVolumeCellPicker* New();
  vtkTypeMacro(vtkVolumeCellPicker, vtkCellPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the opacity from the front at which the ray stops, 1e-6 to 1, default 0.5. It
   * replaces VolumeOpacityIsovalue for volumes of cells. A value out of range is an error and
   * changes nothing.
   */
  void SetOpacityThreshold(double opacity);
  vtkGetMacro(OpacityThreshold, double);
  //@}

protected:
  vtkVolumeCellPicker();
  ~vtkVolumeCellPicker() override;

  double IntersectVolumeWithLine(const double p1[3], const double p2[3], double t1, double t2,
    vtkProp3D* prop, vtkAbstractVolumeMapper* mapper) override;

private:
  vtkVolumeCellPicker(const vtkVolumeCellPicker&) = delete;
  void operator=(const vtkVolumeCellPicker&) = delete;

  void Store(vtkGPUUnstructuredGridVolumeMapper* mapper, const relevo::VolumeHit& hit,
    const double towardsCamera[3]);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
  double OpacityThreshold = 0.5;
};

#endif
