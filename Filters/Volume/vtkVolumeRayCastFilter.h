// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeRayCastFilter
 * @brief   a picture of a volume of unstructured cells, cast on the CPU in double precision
 *
 * A ray goes through the centre of every pixel, and light is absorbed and emitted along it where it
 * is inside a cell. A ray may leave the mesh and enter it again as often as it wants: the mesh may
 * be concave, hollow or in parts. Where cells overlap, space counts once. Runs on all processors
 * that vtkSMPTools uses; their number does not change the result.
 *
 * Input: a vtkDataSet, or a composite data set that is taken as one mesh, of 3D cells. Others are
 * ignored; ghost and blanked cells, too. Places in tetrahedra, hexahedra, voxels, wedges, pyramids
 * and quadratic tetrahedra, and scalars there, are those of VTK's shape functions: quadrilateral
 * faces are bilinear. Other cells are split into tetrahedra, linear ones from their lowest point
 * (in x, then y, then z), so that cells split a common face alike, others by vtkCell::Triangulate.
 * Scalars of cells are constant in each. The array, of 1 to 4 components, is that of
 * SetInputArrayToProcess(0, 0, 0, association, name); by default the active scalars, of points if
 * there are some, else of cells. Where a scalar is NaN, the volume is transparent.
 *
 * Extinction per length is ScalarOpacity / ScalarOpacityUnitDistance, as in VTK's mappers for
 * unstructured grids: an opacity of 1 lets exp(-1) of the light pass through a unit distance, so it
 * is not opaque. Colours are those of the RGB function or, with 1 colour channel, of the gray one.
 * Functions count as they evaluate themselves, with colour space, midpoints, sharpness and
 * clamping; each part of a ray is cut wherever one of them bends (R. Espinha, "Visualizacao
 * volumetrica interativa de malhas nao-estruturadas utilizando placas graficas programaveis",
 * PUC-Rio, 2005) and integrated exactly in between (K. Moreland, E. Angel, "A Fast High Accuracy
 * Volume Renderer for Unstructured Data", 2004). Of the property's other settings the interpolation
 * type and labels have no effect.
 *
 * Gradients are in units of the scalar per world length, 0 for scalars of cells. With a gradient
 * opacity the extinction is multiplied by its value at the length of the gradient of the cell: in a
 * tetrahedron the same everywhere, in cells of other shapes that in the middle of each of the parts
 * that the scalar is linear in. With TransferFunctionMode TF_2D the image of
 * GetTransferFunction2D() gives colour and opacity instead: its x is the scalar, its y the length
 * of the gradient, by its origin and spacing, bilinear and clamped; gradient opacities have no
 * effect. A blend mode that takes the opacity of one scalar takes the gradient where this is, in a
 * face that of the cell before it; an average, their mean.
 *
 * With ShadeOn a white headlight lights composite blending and isosurfaces: it shines along the
 * direction in which the camera looks, as that of a renderer does that has no other lights. A
 * colour becomes colour * (Ambient + Diffuse * d) + Specular * s, at most 1: d and s are the
 * diffuse and specular factors of Phong's model, the same for both sides. The normal is the
 * gradient; gradients at points are the means of the cells' around, by their volumes. They are
 * interpolated as scalars are, factors are linear in between the ends of a part inside a cell.
 * Where the gradient is 0, the colour stays as it is.
 *
 * Independent components add up their extinctions, and their colours mix by extinction at every
 * place. Of two dependent components the first gives the colour, the second the opacity. Four are
 * red, green, blue and opacity, from 0 to 1, or unsigned char from 0 to 255. Independent components
 * have gradients, gradient opacities, 2D functions and materials of their own; dependent ones the
 * gradient of the last component, which is the opacity, and the functions and the material of
 * component 0. A 2D function takes their last component alone.
 *
 * Output: a vtkImageData of ViewportSize points, a point for each pixel, row 0 the lowest, with the
 * point scalars "RGBA" of 4 doubles: colours times alpha, and alpha, without a background.
 *
 * Errors, with an empty output: no camera or property; a missing array, or one with too many or too
 * few components or of a wrong length; no 3D cells in a mesh with cells; cells that refer to points
 * that do not exist; a function without nodes, or with numbers that are not finite; a 2D function
 * that is missing or no image of 4 finite components. One warning each: blocks without the array or
 * without 3D cells, which are left out; cells without volume or with points that are not finite,
 * which are left out, and how many; a unit distance that is not more than 0, for which 1 is taken;
 * isosurfaces of values of cells, or of values that are out of the array's range. Of an empty mesh
 * nothing is seen.
 */
#ifndef vtkVolumeRayCastFilter_h
#define vtkVolumeRayCastFilter_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for members

class vtkCamera;
class vtkPlane;
class vtkPlaneCollection;
class vtkPlanes;
class vtkVolumeProperty;

namespace relevo
{
class Shading;
class TransferFunctions;
class CellCrossing;
class VolumeCells;
}

class RELEVOFILTERSVOLUME_EXPORT vtkVolumeRayCastFilter : public vtkImageAlgorithm
{
public:
  static vtkVolumeRayCastFilter* New();
  vtkTypeMacro(vtkVolumeRayCastFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Where to look from; needed. Rays begin at its near plane and end at its far one, as in a
   * renderer, whose ResetCameraClippingRange() sets both.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Width and height of the picture in pixels, at least 1, default 300 x 300.
   */
  void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  //@{
  /**
   * Functions of colour and opacity; needed.
   */
  void SetVolumeProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVolumeProperty();
  //@}

  enum VectorModeType
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1
  };

  //@{
  /**
   * What of an array of several components is drawn, with the functions of component 0 of the
   * property: MAGNITUDE (0), the length of each tuple; COMPONENT (1), the one that VectorComponent
   * says; DISABLED (-1, the default), all components, or the length if the property has a colour
   * function in MAGNITUDE mode.
   */
  void SetVectorMode(int mode);
  vtkGetMacro(VectorMode, int);
  //@}

  //@{
  /**
   * Which component is drawn, with VectorMode COMPONENT: 0 to 3, default 0.
   */
  void SetVectorComponent(int component);
  vtkGetMacro(VectorComponent, int);
  //@}

  /// As those of vtkVolumeMapper.
  enum BlendModes
  {
    COMPOSITE_BLEND,
    MAXIMUM_INTENSITY_BLEND,
    MINIMUM_INTENSITY_BLEND,
    AVERAGE_INTENSITY_BLEND,
    ADDITIVE_BLEND,
    ISOSURFACE_BLEND
  };

  //@{
  /**
   * What is shown of a ray; default COMPOSITE_BLEND (0), what was said of extinction above.
   *
   * Maximum (1) and minimum (2): the highest or lowest scalar inside the mesh, exactly so, also
   * inside of cells; average (3): the mean by length. Alpha is the opacity of this scalar, whatever
   * the length, at most 1. Independent components have a scalar each, and mix by their opacities;
   * of dependent ones all count as they are where the last, the opacity, is extreme.
   *
   * Additive (4): the integrals of colour times extinction, and of extinction as alpha, at most 1
   * each.
   *
   * Isosurface (5): the property's IsoSurfaceValues front to back, see IsoSurfaces.
   */
  void SetBlendMode(int mode);
  vtkGetMacro(BlendMode, int);
  void SetBlendModeToComposite() { this->SetBlendMode(COMPOSITE_BLEND); }
  void SetBlendModeToMaximumIntensity() { this->SetBlendMode(MAXIMUM_INTENSITY_BLEND); }
  void SetBlendModeToMinimumIntensity() { this->SetBlendMode(MINIMUM_INTENSITY_BLEND); }
  void SetBlendModeToAverageIntensity() { this->SetBlendMode(AVERAGE_INTENSITY_BLEND); }
  void SetBlendModeToAdditive() { this->SetBlendMode(ADDITIVE_BLEND); }
  void SetBlendModeToIsoSurface() { this->SetBlendMode(ISOSURFACE_BLEND); }
  //@}

  //@{
  /**
   * Whether the property's IsoSurfaceValues, by VTK's default one of 0, are drawn inside the
   * volume, with composite blending; default off. Alpha of a surface is the opacity of its value,
   * whatever the length, at most 1. A border of cells that has the value counts once; where the
   * scalar has the value all along, and with scalars of cells, there is no surface. Surfaces are
   * those of the independent component of the largest ComponentWeight, the first of equal ones; of
   * 2 dependent components of the first, whose value also gives the opacity; of 4 of the last.
   */
  vtkSetMacro(IsoSurfaces, bool);
  vtkGetMacro(IsoSurfaces, bool);
  vtkBooleanMacro(IsoSurfaces, bool);
  //@}

  //@{
  /**
   * Planes that clip the volume, of which only what is on the positive side of all is seen, in
   * world coordinates; as those of vtkAbstractMapper. Changes of planes count. Setting a vtkPlanes
   * takes up to 6 of its planes as they are then.
   */
  void AddClippingPlane(vtkPlane* plane);
  void RemoveClippingPlane(vtkPlane* plane);
  void RemoveAllClippingPlanes();
  void SetClippingPlanes(vtkPlaneCollection* planes);
  void SetClippingPlanes(vtkPlanes* planes);
  vtkPlaneCollection* GetClippingPlanes();
  //@}

  /// Includes the modification times of camera, property and clipping planes.
  vtkMTimeType GetMTime() override;

protected:
  vtkVolumeRayCastFilter();
  ~vtkVolumeRayCastFilter() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkVolumeRayCastFilter(const vtkVolumeRayCastFilter&) = delete;
  void operator=(const vtkVolumeRayCastFilter&) = delete;

  bool Read(vtkDataObject* input, relevo::VolumeCells& cells, relevo::TransferFunctions& functions);
  void ReportMissingSurfaces(const relevo::VolumeCells& cells, int component);
  void Cast(const relevo::CellCrossing& crossing, const relevo::TransferFunctions& functions,
    const relevo::Shading& shading, vtkImageData* output);

  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkVolumeProperty> VolumeProperty;
  vtkSmartPointer<vtkPlaneCollection> ClippingPlanes;
  int ViewportSize[2] = { 300, 300 };
  int VectorMode = DISABLED;
  int VectorComponent = 0;
  int BlendMode = COMPOSITE_BLEND;
  bool IsoSurfaces = false;
};

#endif
