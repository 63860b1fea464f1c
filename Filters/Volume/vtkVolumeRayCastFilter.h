// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeRayCastFilter
 * @brief   volume rendering of unstructured meshes to an image, on the CPU in double precision
 *
 * The filter casts one ray through the centre of each pixel. Light is absorbed and emitted along
 * the ray inside of cells. The mesh may be concave, hollow or in separate parts; a ray can leave
 * and enter it any number of times. Where cells overlap, space is counted once. Work is distributed
 * with vtkSMPTools; the number of threads does not change the result.
 *
 * Input: a vtkDataSet, or a composite data set that is treated as one mesh. Only 3D cells are used,
 * without ghost and blanked cells. Tetrahedra, hexahedra, voxels, wedges, pyramids and quadratic
 * tetrahedra use the shape functions of VTK for geometry and scalars, so that quadrilateral faces
 * are bilinear. Quadratic cells of other kinds, and Lagrange and Bézier cells of degrees 1 to 8,
 * use their own basis too, with rational weights. Other cells are split into tetrahedra from their
 * lowest point (in x, then y, then z), so that neighbours split a common face in the same way;
 * convex point sets with vtkCell::Triangulate(). Cell scalars are constant in each cell. To choose
 * the array, of 1 to 4 components, call SetInputArrayToProcess(0, 0, 0, association, name). The
 * default is the active point scalars or, if there are none, the active cell scalars. Cells are
 * transparent if a scalar of them is not finite.
 *
 * Extinction per length is ScalarOpacity / ScalarOpacityUnitDistance, as in VTK's mappers for
 * unstructured grids: with an opacity of 1, a unit distance transmits exp(-1) of the light and is
 * not opaque. Colours come from the RGB function or, with 1 colour channel, from the gray function.
 * Transfer functions are evaluated as VTK does, including colour space, midpoint, sharpness and
 * clamping. Rays are split at the nodes of these functions (R. Espinha, "Visualizacao volumetrica
 * interativa de malhas nao-estruturadas utilizando placas graficas programaveis", PUC-Rio, 2005),
 * and each piece is integrated analytically (K. Moreland, E. Angel, "A Fast High Accuracy Volume
 * Renderer for Unstructured Data", 2004). The interpolation type and the label maps of the property
 * are ignored.
 *
 * Gradients are in scalar units per world length, and 0 for cell scalars. Gradient opacity
 * multiplies the extinction by its value at the gradient magnitude of the cell. A tetrahedron has
 * one gradient. In other cells, the gradient in the middle of each linear piece of the ray is used.
 * With TransferFunctionMode TF_2D, the image of GetTransferFunction2D() gives colour and opacity: x
 * is the scalar and y the gradient magnitude, according to origin and spacing, with bilinear
 * interpolation and clamping. Gradient opacities are ignored then. Blend modes that look up the
 * opacity of one scalar use the gradient at that position; on a face, that of the cell in front of
 * it. Average blending uses the mean gradient.
 *
 * With ShadeOn, a white headlight along the viewing direction lights composite blending and
 * isosurfaces, like the headlight of a renderer without other lights. A colour becomes colour *
 * (Ambient + Diffuse * d) + Specular * s, at most 1, where d and s are the diffuse and specular
 * factors of Phong's model, the same on both sides. The normal is the gradient. Point gradients are
 * the volume-weighted means of the gradients of the adjacent cells and are interpolated like
 * scalars. The factors are linear along each piece of a ray. Colours are not shaded where the
 * gradient is 0.
 *
 * Independent components add their extinctions, and their colours are mixed by extinction. Two
 * dependent components give colour and opacity. Four dependent components are red, green, blue and
 * opacity, in [0, 1] or, for unsigned char, in [0, 255]. Each independent component has its
 * gradient, gradient opacity, 2D function and material. Dependent components use the gradient of
 * the last component, the opacity, with the functions and the material of component 0. A 2D
 * function of dependent components takes the last component only.
 *
 * Output: a vtkImageData with one point per pixel (ViewportSize), row 0 at the bottom. The point
 * scalars "RGBA" are 4 doubles: premultiplied colours and alpha, without a background.
 *
 * The filter reports an error and produces an empty output if
 *
 * - the camera or the property is missing;
 * - the array is missing, or has a wrong number of components or tuples;
 * - the mesh has cells, but no 3D cells, or a cell refers to a point that does not exist;
 * - a transfer function has no nodes or values that are not finite, or a 2D function is missing or
 *   not an image of 4 finite components.
 *
 * It issues a warning if
 *
 * - blocks without the array or without 3D cells are skipped;
 * - cells without volume or with points that are not finite are skipped, or cells have scalars that
 *   are not finite (the warning gives the number, the blocks and the array);
 * - the unit distance is not greater than 0, and 1 is used instead;
 * - isosurfaces are requested of cell data, or of values out of the range of the array.
 *
 * An empty mesh produces a transparent image.
 */
#ifndef vtkVolumeRayCastFilter_h
#define vtkVolumeRayCastFilter_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <vector> // for messages

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
struct MeshScalars;
}

class RELEVOFILTERSVOLUME_EXPORT vtkVolumeRayCastFilter : public vtkImageAlgorithm
{
public:
  static vtkVolumeRayCastFilter* New();
  vtkTypeMacro(vtkVolumeRayCastFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the camera. Required. Rays start at its near plane and end at its far plane, as in a
   * renderer, whose ResetCameraClippingRange() sets both.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  //@}

  //@{
  /**
   * Set width and height of the image in pixels, at least 1, default 300 x 300.
   */
  void SetViewportSize(int width, int height);
  void SetViewportSize(const int size[2]) { this->SetViewportSize(size[0], size[1]); }
  vtkGetVector2Macro(ViewportSize, int);
  //@}

  //@{
  /**
   * Set the property with the transfer functions. Required.
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
   * Set which component of an array with several components is drawn: MAGNITUDE (0) draws the
   * length of each tuple and COMPONENT (1) draws VectorComponent, both with the functions of
   * component 0 of the property. DISABLED (-1, default) draws all components, or the length if they
   * are independent and the property has a colour function in MAGNITUDE mode. The values of an
   * array with one component keep their sign.
   */
  void SetVectorMode(int mode);
  vtkGetMacro(VectorMode, int);
  //@}

  //@{
  /**
   * Set the component to draw if VectorMode is COMPONENT: 0 to 3, default 0.
   */
  void SetVectorComponent(int component);
  vtkGetMacro(VectorComponent, int);
  //@}

  /// The values are those of vtkVolumeMapper.
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
   * Set how the values along a ray are combined:
   *
   * - Composite (0, default): absorption and emission, see above.
   * - Maximum (1) and minimum (2): the exact highest or lowest scalar along the ray, also within
   *   cells. Alpha is the opacity of this scalar, at most 1. It does not depend on the length of
   *   the ray. Each independent component has its extreme value, and the components are mixed by
   *   opacity. Dependent components are taken at the position where the last component, the
   *   opacity, is extreme.
   * - Average (3): the mean scalar by length, with alpha as above.
   * - Additive (4): the integral of colour times extinction, and the integral of extinction as
   *   alpha, each at most 1.
   * - Isosurface (5): the IsoSurfaceValues of the property, front to back; see SetIsoSurfaces().
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
   * Set whether composite blending also draws the IsoSurfaceValues of the property (by VTK's
   * default one value, 0) inside of the volume; off by default. The alpha of a surface is the
   * opacity of its value, at most 1. If a face between two cells has the value, it is drawn once.
   * There is no surface in cells of constant value. A cell array is averaged at the points, with a
   * warning, and the volume is drawn with these values. For independent components,
   * surfaces are those of the first component with the largest ComponentWeight. For 2 dependent
   * components they are those of the first, which also gives the opacity; for 4, those of the last.
   */
  vtkSetMacro(IsoSurfaces, bool);
  vtkGetMacro(IsoSurfaces, bool);
  vtkBooleanMacro(IsoSurfaces, bool);
  //@}

  //@{
  /**
   * Set the clipping planes, in world coordinates, as in vtkAbstractMapper. Only space on the
   * positive side of all planes is drawn. The filter detects modified planes. Setting a vtkPlanes
   * copies up to 6 of its planes in their current state.
   */
  void AddClippingPlane(vtkPlane* plane);
  void RemoveClippingPlane(vtkPlane* plane);
  void RemoveAllClippingPlanes();
  void SetClippingPlanes(vtkPlaneCollection* planes);
  void SetClippingPlanes(vtkPlanes* planes);
  vtkPlaneCollection* GetClippingPlanes();
  //@}

  /// Include the modification times of camera, property and clipping planes.
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
  void ReportBadCells(
    const relevo::VolumeCells& cells, const std::vector<relevo::MeshScalars>& meshes);
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
