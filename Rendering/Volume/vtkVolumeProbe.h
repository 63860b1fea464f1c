// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeProbe
 * @brief   the position, cell and value at which a volume becomes opaque under a pixel
 *
 * Probe() follows the ray through a pixel into the volumes of a renderer that are drawn by
 * vtkGPUUnstructuredGridVolumeMapper. It returns the position at which the opacity from the front
 * reaches OpacityThreshold, with the cell there and the value of the array. Isosurfaces, clipping
 * planes, blend modes and the matrices of volumes count as in the picture. With several volumes,
 * each one is followed by itself, and the nearest position is returned. Invisible volumes and those
 * with PickableOff() are skipped.
 *
 * Opaque actors in front hide a volume. They count by the data sets of their mappers, without the
 * refinement and displacement of Relevo's mappers, and only if they are drawn as surfaces.
 *
 * The probe works on the CPU in double precision, with the integrals of vtkVolumeRayCastFilter. It
 * does not read the picture and does not need a render, but the renderer needs a window with a
 * size. Curved cells are evaluated by their own basis. The first call reads the mesh and sorts its
 * cells into a tree, which takes memory of about three times the mesh. Following calls take
 * milliseconds until the mesh changes.
 *
 * @sa vtkVolumeCellPicker
 */
#ifndef vtkVolumeProbe_h
#define vtkVolumeProbe_h

#include "RelevoRenderingVolumeModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for members

#include <array>  // for values
#include <memory> // for members

class vtkDataSet;
class vtkRenderer;
class vtkVolume;

class RELEVORENDERINGVOLUME_EXPORT vtkVolumeProbe : public vtkObject
{
public:
  static vtkVolumeProbe* New();
  vtkTypeMacro(vtkVolumeProbe, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the renderer with the volumes and the camera. Required.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  //@}

  //@{
  /**
   * Set the opacity from the front at which the ray stops, 1e-6 to 1, default 0.5. With
   * maximum and minimum blending, the position is that of the extreme value if its opacity reaches
   * the threshold. A value out of range is an error and changes nothing.
   */
  void SetOpacityThreshold(double opacity);
  vtkGetMacro(OpacityThreshold, double);
  //@}

  /**
   * Follow the ray through a pixel of the window, counted from the lower left corner. Whole numbers
   * are pixel centres, as in mouse events. Return whether the opacity reaches the threshold.
   * Otherwise, and for average blending, the cell is -1 and the value NaN. An error is reported if
   * there is no renderer, or if a volume has average blending. Errors of the mesh or the volume
   * property are reported once.
   */
  bool Probe(double x, double y);

  /// Return the position in world coordinates. 0 before the first result.
  vtkGetVector3Macro(Position, double);

  /// Return the cell of the input, or of its block, or -1 without a result.
  vtkGetMacro(CellId, vtkIdType);

  /// Return the position in parametric coordinates of the cell, as defined by vtkCell.
  vtkGetVector3Macro(ParametricCoordinates, double);

  //@{
  /**
   * Return the value of the array at the position: one number, the length of a vector with
   * VectorMode MAGNITUDE, or the component that is drawn. NaN without a result. If all components
   * are drawn, GetValue(component) returns each, from 0 to GetNumberOfComponents() - 1. Cell values
   * are those of the cell. Cells that are split, such as polyhedra, are interpolated as drawn.
   */
  double GetValue() { return this->GetValue(0); }
  double GetValue(int component);
  vtkGetMacro(NumberOfComponents, int);
  //@}

  /// Return the volume, or nullptr without a result.
  vtkVolume* GetVolume();

  /// Return the data set of the cell: the input or the block of a composite input. nullptr without
  /// a result.
  vtkDataSet* GetDataSet();

  /// Return the flat index of the block, or -1 if the input is not composite.
  vtkGetMacro(FlatBlockIndex, vtkIdType);

protected:
  vtkVolumeProbe();
  ~vtkVolumeProbe() override;

private:
  vtkVolumeProbe(const vtkVolumeProbe&) = delete;
  void operator=(const vtkVolumeProbe&) = delete;

  void Clear();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkVolume> Volume;
  vtkSmartPointer<vtkDataSet> DataSet;
  double OpacityThreshold = 0.5;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double ParametricCoordinates[3] = { 0.0, 0.0, 0.0 };
  vtkIdType CellId = -1;
  vtkIdType FlatBlockIndex = -1;
  int NumberOfComponents = 1;
  std::array<double, 4> Values;
};

#endif
