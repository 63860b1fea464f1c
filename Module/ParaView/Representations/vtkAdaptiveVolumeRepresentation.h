// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveVolumeRepresentation
 * @brief   draws the interior of a data set with a vtkGPUUnstructuredGridVolumeMapper
 *
 * This representation works like ParaView's Volume: the array, the transfer functions, transforms
 * and blocks are those of its representations. It accepts any data set with 3D cells and composite
 * data sets of them, which are drawn as one mesh. SetMapper() sets the mapper, which has the
 * settings of the method.
 *
 * If several ranks draw a view, the data stay where they are. The pieces of the ranks may have any
 * shape. Each rank casts rays through its own cells, and the segments of all rays are composited in
 * the order of depth. Ghost cells are not drawn.
 *
 * Messages of the mapper are reported by this class, in ParaView's words.
 *
 * @sa vtkGPUUnstructuredGridVolumeMapper
 */
#ifndef vtkAdaptiveVolumeRepresentation_h
#define vtkAdaptiveVolumeRepresentation_h

#include "RelevoParaViewRepresentationsModule.h" // for export macro
#include "vtkVolumeRepresentation.h"

#include <memory> // for Internals
#include <string> // for messages

class vtkGPUUnstructuredGridVolumeMapper;
class vtkMultiProcessController;
class vtkPVRenderView;
class vtkPlane;

class RELEVOPARAVIEWREPRESENTATIONS_EXPORT vtkAdaptiveVolumeRepresentation
  : public vtkVolumeRepresentation
{
public:
  static vtkAdaptiveVolumeRepresentation* New();
  vtkTypeMacro(vtkAdaptiveVolumeRepresentation, vtkVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the mapper that draws. It must not be shared with other representations. nullptr is an
   * error and changes nothing. The default is a vtkGPUUnstructuredGridVolumeMapper with its
   * defaults.
   */
  void SetMapper(vtkGPUUnstructuredGridVolumeMapper* mapper);
  vtkGPUUnstructuredGridVolumeMapper* GetMapper();
  //@}

  //@{
  /**
   * Set the method: cell projection (101), or ray casting (100). The methods of Adaptive Refinement
   * (0 to 5) stand for ray casting, because both representations share the property. The default is
   * 0. Rays are cast if several ranks draw a view. Another value is an error and changes nothing.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  //@}

  //@{
  /**
   * Set the blend mode of the mapper, 0 to 5, or 6, the slices of ParaView's Volume, which are
   * drawn as composite (0, the default) with a warning. A value out of range is an error and
   * changes nothing.
   */
  void SetBlendMode(int mode);
  vtkGetMacro(BlendMode, int);
  //@}

  //@{
  /**
   * Set which value of an array with several components is drawn: that of the colour function (-1,
   * the default), the magnitude (0) or the component VectorComponent (1). A value out of range is
   * an error and changes nothing.
   */
  void SetVectorMode(int mode);
  vtkGetMacro(VectorMode, int);
  //@}

  //@{
  /**
   * Set the component that is drawn with VectorMode 1: 0 to 3, default 0. A value out of range is
   * an error and changes nothing.
   */
  void SetVectorComponent(int component);
  vtkGetMacro(VectorComponent, int);
  //@}

  //@{
  /**
   * Set the length over which the opacity function applies. If it equals
   * DefaultScalarOpacityUnitDistance, the diagonal of the data's bounds divided by the cube root of
   * the number of cells is used, which follows changes of the data. Both are 1 by default.
   */
  vtkSetMacro(ScalarOpacityUnitDistance, double);
  vtkGetMacro(ScalarOpacityUnitDistance, double);
  vtkSetMacro(DefaultScalarOpacityUnitDistance, double);
  vtkGetMacro(DefaultScalarOpacityUnitDistance, double);
  //@}

  /**
   * Set the colour function. If it has discrete colours, those of its nodes are interpolated
   * instead. The default is nullptr, which leaves the colours of the volume property.
   */
  void SetColor(vtkColorTransferFunction* colorMap);

  /**
   * Set the plane that clips the volume, in world coordinates. Its positive side is drawn. The
   * default is nullptr, no plane.
   */
  void SetClippingPlane(vtkPlane* plane);

  //@{
  /**
   * Set the lighting of the volume property. By default, shading is off. With shading, processes
   * get a layer of ghost cells, because gradients depend on neighbours.
   */
  void SetShade(bool shade);
  void SetAmbient(double value);
  void SetDiffuse(double value);
  void SetSpecular(double value);
  void SetSpecularPower(double value);
  //@}

  //@{
  /**
   * Set the IsoSurfaceValues of the volume property.
   */
  void SetNumberOfIsoSurfaceValues(int number);
  void SetIsoSurfaceValue(int i, double value);
  //@}

  //@{
  /**
   * Select the blocks of a composite data set that are drawn. By default, all are drawn.
   */
  void SetActiveAssembly(const char* name);
  void AddBlockSelector(const char* selector);
  void RemoveAllBlockSelectors();
  //@}

  /**
   * Update the data, collectively over the processes that have them.
   */
  void Update() override;
  using Superclass::Update;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkAdaptiveVolumeRepresentation();
  ~vtkAdaptiveVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkAdaptiveVolumeRepresentation(const vtkAdaptiveVolumeRepresentation&) = delete;
  void operator=(const vtkAdaptiveVolumeRepresentation&) = delete;

  void AddOpacityArray();
  void AddGhostCells(vtkMultiProcessController* controller);
  void GivePiece(vtkInformation* inInfo);
  void ChooseCompositing(vtkInformation* inInfo);
  void StopCompositing(vtkPVRenderView* view);
  void UpdateColors();
  void PrepareFrame(vtkInformation* inInfo);
  void ChooseModes();
  void ChooseVectorMode();
  void Report(bool isError, const std::string& message);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  int Method = 0;
  int BlendMode = 0;
  int VectorMode = -1;
  int VectorComponent = 0;
  double ScalarOpacityUnitDistance = 1.0;
  double DefaultScalarOpacityUnitDistance = 1.0;
};

#endif
