// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGPUUnstructuredGridVolumeMapper
 * @brief   volume rendering of unstructured meshes on the GPU
 *
 * Draws the interior of a mesh by its scalars, using vtkVolume and vtkVolumeProperty. A ray per
 * pixel traverses the mesh from cell to cell and can enter the mesh several times (M. Weiler et
 * al., "Hardware-Based Ray Casting for Tetrahedral Meshes", 2003). The volume rendering integral is
 * exact: rays are split at every node of a transfer function (R. Espinha, PUC-Rio, 2005), and
 * colour and extinction are linear in between (K. Moreland, E. Angel, 2004). Without
 * pre-integration, no table depends on the transfer functions, so you can edit them interactively.
 *
 * The image is the one that vtkVolumeRayCastFilter computes on the CPU. The doc comment of that
 * class lists supported meshes, arrays and transfer functions, explains how extinction follows from
 * ScalarOpacity and ScalarOpacityUnitDistance (an opacity of 1 is not opaque), and lists the
 * errors. Select scalars as in VTK's mappers, with SetScalarMode...() and SelectScalarArray().
 * InterpolationType has no effect: point scalars are always interpolated.
 *
 * With ShadeOn, all lights of the renderer that are on are used: directional lights along their
 * direction and positional lights from their position, in their diffuse and specular colours times
 * their intensity. Cones and attenuation have no effect, and there are no shadows. With a
 * renderer's default headlight, the image is that of vtkVolumeRayCastFilter. The first shaded frame
 * of a mesh uploads gradients at its points, 16 bytes per point and component.
 *
 * AddClippingPlane() and related methods set clipping planes in world coordinates. The positive
 * side of each plane is kept. More than 32 planes are an error.
 *
 * Opaque props hide the volume behind them. Translucent props are blended with the volume if the
 * renderer has UseDepthPeeling and UseDepthPeelingForVolumes on.
 *
 * Requires OpenGL 3.2. If the mesh does not fit into the buffer textures of the GPU, an error is
 * reported and nothing is drawn.
 *
 * @sa vtkVolumeRayCastFilter, vtkVolumeProperty
 */
#ifndef vtkGPUUnstructuredGridVolumeMapper_h
#define vtkGPUUnstructuredGridVolumeMapper_h

#include "RelevoRenderingVolumeModule.h" // for export macro
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory> // for Internals
#include <string> // for errors

class vtkVolumeProperty;

namespace relevo
{
class RaySegments;
enum class SegmentOutput;
struct MeshExtent;
struct MeshRequest;
struct ProbeRequest;
struct SegmentRequest;
struct VolumeFrame;
}

class RELEVORENDERINGVOLUME_EXPORT vtkGPUUnstructuredGridVolumeMapper
  : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkGPUUnstructuredGridVolumeMapper* New();
  vtkTypeMacro(vtkGPUUnstructuredGridVolumeMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the mesh: a vtkDataSet of 3D cells. To set a vtkMultiBlockDataSet or
   * vtkPartitionedDataSet(Collection), use SetInputDataObject(). Its blocks form one mesh.
   */
  void SetInputData(vtkUnstructuredGridBase* mesh) override;
  void SetInputData(vtkDataSet* mesh) override;
  //@}

  enum VectorModeType
  {
    DISABLED = -1,
    MAGNITUDE = 0,
    COMPONENT = 1
  };

  //@{
  /**
   * Set which value of an array with several components is drawn, with the functions of component 0
   * of the property. MAGNITUDE (0): the length of each tuple; the values of an array with one
   * component keep their sign. COMPONENT (1): the component VectorComponent. DISABLED (-1, the
   * default): all components, or the magnitude if they are independent and the property has a
   * colour function in MAGNITUDE mode. A value out of range is an error and changes nothing.
   */
  void SetVectorMode(int mode);
  vtkGetMacro(VectorMode, int);
  //@}

  //@{
  /**
   * Set the component that is drawn with VectorMode COMPONENT: 0 to 3, default 0. A value out of
   * range is an error and changes nothing.
   */
  void SetVectorComponent(int component);
  vtkGetMacro(VectorComponent, int);
  //@}

  /// The further blend modes of vtkVolumeMapper. COMPOSITE_BLEND and MAXIMUM_INTENSITY_BLEND are
  /// inherited.
  enum FurtherBlendModes
  {
    MINIMUM_INTENSITY_BLEND = 2,
    AVERAGE_INTENSITY_BLEND,
    ADDITIVE_BLEND,
    ISOSURFACE_BLEND
  };

  //@{
  /**
   * Set how the values along a ray are combined, with the numbers of vtkVolumeMapper. The default
   * is composite (0). Maximum (1) and minimum (2) show the exact highest or lowest scalar inside
   * the mesh. Average (3) shows the mean scalar along the ray. Additive (4) adds without occlusion.
   * Isosurface (5) shows the property's IsoSurfaceValues. See
   * vtkVolumeRayCastFilter::SetBlendMode() for definitions. If depth peeling blends translucent
   * props with the volume, modes 1 to 4 show each interval between the props' layers. A value out
   * of range is an error and changes nothing.
   */
  void SetBlendMode(int mode) override;
  void SetBlendModeToMinimumIntensity() { this->SetBlendMode(MINIMUM_INTENSITY_BLEND); }
  void SetBlendModeToAverageIntensity() { this->SetBlendMode(AVERAGE_INTENSITY_BLEND); }
  void SetBlendModeToAdditive() { this->SetBlendMode(ADDITIVE_BLEND); }
  void SetBlendModeToIsoSurface() { this->SetBlendMode(ISOSURFACE_BLEND); }
  //@}

  //@{
  /**
   * Set whether the property's IsoSurfaceValues are drawn inside the volume, with composite
   * blending. Off by default. See vtkVolumeRayCastFilter::SetIsoSurfaces().
   */
  vtkSetMacro(IsoSurfaces, bool);
  vtkGetMacro(IsoSurfaces, bool);
  vtkBooleanMacro(IsoSurfaces, bool);
  //@}

  enum MethodType
  {
    RAY_CASTING,
    CELL_PROJECTION
  };

  //@{
  /**
   * Set how the volume is drawn. The default is RAY_CASTING (0). A value out of range is an error
   * and changes nothing.
   *
   * CELL_PROJECTION (1) sorts the cells from back to front by their common faces (as
   * vtkMeshVisibilitySort does) in each frame whose camera has moved, and draws one after the other
   * (M. Weiler et al., "Hardware-Based View-Independent Cell Projection", 2003). The image is the
   * same as with ray casting if a visibility order exists. It may be wrong if cells hide each other
   * in a cycle, or if the mesh has separate parts or cavities that no common faces order. Where
   * cells overlap, both are drawn. All cells are split into tetrahedra, as described in
   * vtkVolumeRayCastFilter, with matching splits of common faces. This takes 20 further bytes per
   * tetrahedron on the GPU. All features of RAY_CASTING are supported except ImageSampleDistance.
   * With UseDepthPeelingForVolumes, rays are cast instead.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToRayCasting() { this->SetMethod(RAY_CASTING); }
  void SetMethodToCellProjection() { this->SetMethod(CELL_PROJECTION); }
  //@}

  enum IntegrationType
  {
    EXACT,
    PRE_INTEGRATED,
    PRE_INTEGRATED_2D
  };

  //@{
  /**
   * Set how the volume rendering integral of a ray's segment in a cell is computed with composite
   * blending. The default is EXACT (0). A value out of range is an error and changes nothing.
   *
   * PRE_INTEGRATED (1) looks it up in a 3D table over the scalars at both ends and the length, up
   * to the longest edge of a cell (S. Roettger, M. Kraus, T. Ertl, "Hardware-Accelerated Volume and
   * Isosurface Rendering Based on Cell-Projection", 2000). PRE_INTEGRATED_2D (2) uses a table
   * without the length (S. Guthe et al., "High-Quality Unstructured Volume Rendering on the PC
   * Platform", 2002). Its opacity follows from the mean extinction, 1 - exp(-extinction * length),
   * like the exact opacity. Its colour is the mean visible colour of a segment of half the longest
   * edge, times opacity.
   *
   * Tables need no splits at nodes and are faster for functions with many nodes, but they miss
   * features smaller than their steps. They are recomputed when the functions, the range of the
   * scalars or the scale of the volume's matrix change. They support one component, without
   * gradients and shading; otherwise a warning is reported and EXACT is used.
   */
  void SetIntegration(int integration);
  vtkGetMacro(Integration, int);
  void SetIntegrationToExact() { this->SetIntegration(EXACT); }
  void SetIntegrationToPreIntegrated() { this->SetIntegration(PRE_INTEGRATED); }
  void SetIntegrationToPreIntegrated2D() { this->SetIntegration(PRE_INTEGRATED_2D); }
  //@}

  //@{
  /**
   * Set the number of texels of pre-integration tables along each axis: 2 to 256, default 128. A 3D
   * table takes 16 bytes per texel, 32 MiB for 128. A value out of range is an error and changes
   * nothing.
   */
  void SetTableSize(int size);
  vtkGetMacro(TableSize, int);
  //@}

  //@{
  /**
   * Set the largest errors of curved cells: quadratic, Lagrange and Bézier cells, except meshes
   * that have only quadratic tetrahedra as curved cells, which rays traverse directly. Other curved
   * cells are split into hexahedra until their shape and field are closer to the cell's own basis
   * than both tolerances, by bounds from Bézier coefficients. Common edges and faces of curved
   * cells are split alike, so that the pieces of neighbours match. Between a curved and a linear
   * cell, at a triangle of a pyramid, and between cells on different ranks, there can be gaps of up
   * to ShapeTolerance.
   *
   * ShapeTolerance is a share of the diagonal of the mesh's bounding box, 1e-6 to 1, default 5e-4:
   * a half of a pixel if the mesh is 1000 pixels large. FieldTolerance is a share of the range of
   * the scalars, 1e-6 to 1, default 4e-3. Reduce it if the transfer functions have peaks that are
   * narrow compared with the range. A value out of range is an error and changes nothing. Changes
   * rebuild the mesh.
   *
   * An edge is split into at most 64 pieces, and the mesh into about a million, or eight for each
   * cell if it is large. If the tolerances need more, all edges get fewer pieces, and a warning is
   * reported.
   */
  void SetShapeTolerance(double share);
  vtkGetMacro(ShapeTolerance, double);
  void SetFieldTolerance(double share);
  vtkGetMacro(FieldTolerance, double);
  //@}

  //@{
  /**
   * Set whether the sources of the scalars stay in the memory of the process after an upload: 4
   * bytes per point, and 8 bytes per cell if scalars are of cells. With shading, the cells stay
   * too: about 140 bytes per hexahedron. They are needed to upload new values on the same points
   * and cells without building the mesh. On by default. If it is switched on again, it applies to
   * the next mesh that is built.
   */
  vtkSetMacro(KeepHostData, bool);
  vtkGetMacro(KeepHostData, bool);
  vtkBooleanMacro(KeepHostData, bool);
  //@}

  //@{
  /**
   * Set the distance between cast rays in both directions, in pixels: 0.1 to 100, default 1. Above
   * 1, drawing is faster and colours are interpolated in between; below 1, the image is smoother.
   * It has no effect if translucent props are blended with the volume. A value out of range is an
   * error and changes nothing.
   */
  void SetImageSampleDistance(double distance);
  vtkGetMacro(ImageSampleDistance, double);
  //@}

  //@{
  /**
   * Set whether moving views use a larger sample distance than ImageSampleDistance, up to 16
   * pixels, so that a frame fits into the time allotted to the volume
   * (vtkProp::GetAllocatedRenderTime()). The distance follows from the time of the last frame. If
   * the window has an interactor whose events wait for frames, the time is shortened until they no
   * longer wait. A view moves if the window's DesiredUpdateRate is 1 or more, which interactors set
   * as long as the mouse moves the view. Still images have the full resolution. On by default.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  //@}

  //@{
  /**
   * Set the share of the cells that moving views draw: 0 to 1, default 0, which draws all cells. A
   * simplified mesh with this share of the cells is made in the background
   * (vtkUnstructuredGridQuadricDecimation). Moving views, as defined in
   * SetAutoAdjustSampleDistances(), draw it from the first frame after it is ready; still views
   * draw the full mesh. Cells that are not tetrahedra are split into tetrahedra first, and values
   * that jump between cells are averaged, as are cell arrays. It needs a single component. Changes,
   * and new values, build the mesh again. A value out of range is an error and changes nothing.
   */
  void SetLevelOfDetail(double share);
  vtkGetMacro(LevelOfDetail, double);
  //@}

  //@{
  /**
   * Return the largest difference of scalars between the full and the simplified mesh, at the
   * points of the full mesh, in units of the array; and the number of tetrahedra of the simplified
   * mesh. 0 while there is none. Both take the result of the background thread.
   */
  double GetLevelOfDetailError();
  vtkIdType GetNumberOfLevelOfDetailCells();
  //@}

  //@{
  /**
   * Set the maximum number of segments per pixel: 1 to 127, default 64. A segment is an interval of
   * a pixel's ray inside the mesh. This setting has an effect only if segments of several ranks are
   * composited. Then memory per pixel is bounded, and each rank keeps its nearest segments. A value
   * out of range is an error and changes nothing.
   */
  void SetMaximumSegments(int number);
  vtkGetMacro(MaximumSegments, int);
  //@}

  //@{
  /**
   * Return statistics of the last render. GetNumberOfDrawnCells(): the 3D cells of the input,
   * without ghost, blanked and empty cells and cells without scalars. GetNumberOfLayers(): the
   * maximum over all pixels of how often a ray enters the mesh; this call draws and waits for the
   * GPU. GetNumberOfSkippedCells(): the cells, or pieces of split cells, without isosurface if
   * there are only opaque isosurfaces, through which no ray has passed; otherwise the transparent
   * cells, through which rays have passed only between visible ones. It is 0 if rays walk through
   * all cells, as in the first frame with new data or functions. GetGraphicsMemorySize(): the bytes
   * of the mesh and the tables on the GPU. GetNumberOfBufferBuilds(), GetNumberOfShaderBuilds() and
   * GetNumberOfTableBuilds() return how often the mesh or its values have been uploaded, a shader
   * built and a table computed since the mapper was created. Cameras and edits of the property do
   * not increase them, except for the tables of pre-integration, and for shaders when cells become
   * transparent for the first time. GetNumberOfValueUploads(): the uploads of new values on the
   * same points and cells, without building the mesh. GetNumberOfNeighborSearches(): the uploads
   * that did not take the neighbours of cells from the mesh before, as moved points do.
   */
  vtkIdType GetNumberOfDrawnCells();
  int GetNumberOfLayers();
  vtkIdType GetNumberOfSkippedCells();
  vtkTypeInt64 GetGraphicsMemorySize();
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfNeighborSearches();
  vtkIdType GetNumberOfValueUploads();
  vtkIdType GetNumberOfShaderBuilds();
  vtkIdType GetNumberOfTableBuilds();
  //@}

  //@{
  /// Return the bounds of all blocks.
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->vtkAbstractMapper3D::GetBounds(bounds); }
  //@}

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

#ifndef __VTK_WRAP__
  //@{
  /**
   * These methods are for modules of Relevo that composite the pieces of a mesh. MeasurePiece()
   * returns the extent of the input, which is empty without cells. CastSegments() returns the
   * segments of each ray inside the input instead of drawing it. It uses the renderer's camera and
   * the current viewport, and ignores Method and ImageSampleDistance. All pieces need the same
   * settings. Errors are reported as in Render(); then there are no segments, and the result is
   * false.
   */
  relevo::MeshExtent MeasurePiece(vtkRenderer* renderer, vtkVolume* volume);
  bool CastSegments(vtkRenderer* renderer, vtkVolume* volume, const relevo::SegmentRequest& request,
    relevo::RaySegments& segments);
  //@}

  /// This method is for vtkVolumeProbe and pickers. It updates the input.
  relevo::ProbeRequest MakeProbeRequest(vtkVolumeProperty* property);
#endif

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGPUUnstructuredGridVolumeMapper();
  ~vtkGPUUnstructuredGridVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;

private:
  vtkGPUUnstructuredGridVolumeMapper(const vtkGPUUnstructuredGridVolumeMapper&) = delete;
  void operator=(const vtkGPUUnstructuredGridVolumeMapper&) = delete;

  relevo::MeshRequest MakeMeshRequest(
    vtkVolume* volume, const relevo::MeshExtent* whole, bool hasCorners);
  bool UpdateMesh(vtkVolume* volume, const relevo::MeshExtent* whole = nullptr);
  void ChooseLevel(vtkVolume* volume);
  bool UpdateFunctions(vtkVolume* volume);
  bool UpdateFeatures(vtkRenderer* renderer, vtkVolume* volume, relevo::SegmentOutput segments);
  bool UpdateTable();
  bool ReadSegments(const relevo::SegmentRequest& request, relevo::RaySegments& segments);
  void Draw(vtkVolume* volume);
  std::string ProjectCells(const relevo::VolumeFrame& frame);
  std::string CastRays(const relevo::VolumeFrame& frame, vtkVolume* volume);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  int VectorMode = DISABLED;
  int VectorComponent = 0;
  bool IsoSurfaces = false;
  int Method = RAY_CASTING;
  int Integration = EXACT;
  int TableSize = 128;
  double ShapeTolerance = 5e-4;
  double FieldTolerance = 4e-3;
  bool KeepHostData = true;
  double LevelOfDetail = 0.0;
  double ImageSampleDistance = 1.0;
  int MaximumSegments = 64;
  bool AutoAdjustSampleDistances = true;
};

#endif
