// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGPUUnstructuredGridVolumeMapper
 * @brief   volume rendering of unstructured meshes on the GPU
 *
 * Shows the inside of a mesh by its scalars, as vtkVolume and vtkVolumeProperty describe it. Each
 * pixel's ray walks from cell to cell, in as many entries as the mesh has there (M. Weiler et al.,
 * "Hardware-Based Ray Casting for Tetrahedral Meshes", 2003), and the volume rendering integral is
 * exact: parts of the ray are cut wherever a transfer function bends (R. Espinha, PUC-Rio, 2005),
 * and in between colour and extinction are linear (K. Moreland, E. Angel, 2004). No table depends
 * on the transfer functions: they can be edited while the volume is shown.
 *
 * What is drawn is what vtkVolumeRayCastFilter computes on the CPU, whose doc comment says which
 * meshes, arrays and functions are taken, how extinction follows from ScalarOpacity and
 * ScalarOpacityUnitDistance (an opacity of 1 is not opaque), and what is an error. Scalars are
 * chosen as in VTK's mappers: SetScalarMode...(), SelectScalarArray(). InterpolationType has no
 * effect: scalars of points are always interpolated.
 *
 * With ShadeOn all lights of the renderer that are on shine: directional ones along their
 * direction, positional ones from their place, in their diffuse and specular colours times their
 * intensity. Cones and attenuation have no effect, and nothing throws a shadow. With a renderer's
 * own headlight this is what vtkVolumeRayCastFilter shows. The first shaded picture of a mesh
 * uploads gradients at its points, 16 bytes for each and each component.
 *
 * AddClippingPlane() and the like: planes in world coordinates, whose positive side stays; at most
 * 32, more are an error.
 *
 * Opaque props hide what is behind them. Translucent ones mix with the volume if the renderer has
 * UseDepthPeeling and UseDepthPeelingForVolumes on.
 *
 * Needs OpenGL 3.2. Where the mesh does not fit into the buffer textures of the graphics card there
 * is an error, and nothing is drawn.
 *
 * @sa vtkVolumeRayCastFilter, vtkVolumeProperty
 */
#ifndef vtkGPUUnstructuredGridVolumeMapper_h
#define vtkGPUUnstructuredGridVolumeMapper_h

#include "RelevoRenderingVolumeModule.h" // for export macro
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory> // for Internals
#include <string> // for errors

namespace relevo
{
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
   * The mesh: any vtkDataSet of 3D cells, or by SetInputDataObject() a vtkMultiBlockDataSet or
   * vtkPartitionedDataSet(Collection), whose blocks are one mesh.
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

  /// As those of vtkVolumeMapper. COMPOSITE_BLEND and MAXIMUM_INTENSITY_BLEND are inherited.
  enum FurtherBlendModes
  {
    MINIMUM_INTENSITY_BLEND = 2,
    AVERAGE_INTENSITY_BLEND,
    ADDITIVE_BLEND,
    ISOSURFACE_BLEND
  };

  //@{
  /**
   * What is shown of a ray, by vtkVolumeMapper's numbers; default COMPOSITE_BLEND (0). Maximum (1)
   * and minimum (2): the highest or lowest scalar inside the mesh, exactly so; average (3): the
   * mean by length; additive (4): what nothing hides; isosurface (5): the property's
   * IsoSurfaceValues. The doc comment of vtkVolumeRayCastFilter::SetBlendMode() says what they
   * mean. Where translucent props are mixed with the volume by depth peeling, modes 1 to 4 show
   * what is between the props' layers.
   */
  void SetBlendMode(int mode) override;
  void SetBlendModeToMinimumIntensity() { this->SetBlendMode(MINIMUM_INTENSITY_BLEND); }
  void SetBlendModeToAverageIntensity() { this->SetBlendMode(AVERAGE_INTENSITY_BLEND); }
  void SetBlendModeToAdditive() { this->SetBlendMode(ADDITIVE_BLEND); }
  void SetBlendModeToIsoSurface() { this->SetBlendMode(ISOSURFACE_BLEND); }
  //@}

  //@{
  /**
   * Whether the property's IsoSurfaceValues are drawn inside the volume, with composite blending;
   * default off. See vtkVolumeRayCastFilter::SetIsoSurfaces().
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
   * How the volume is drawn; default RAY_CASTING (0). CELL_PROJECTION (1) sorts the cells from back
   * to front, in each frame whose camera has moved, by their common faces (as vtkMeshVisibilitySort
   * does), and draws one after the other what pixels see of it (M. Weiler et al., "Hardware-Based
   * View-Independent Cell Projection", 2003). The picture is the same where such an order exists;
   * where cells hide each other in a cycle, or the mesh has parts or hollows that no common faces
   * order, it may be wrong, and where cells overlap, both count. All cells are split into
   * tetrahedra, as vtkVolumeRayCastFilter says, common faces alike. It takes 20 bytes a tetrahedron
   * more on the GPU. All features are those of RAY_CASTING but ImageSampleDistance. For render
   * passes (UseDepthPeelingForVolumes) rays are cast.
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
   * How the volume rendering integral of the part of a ray inside a cell is found with composite
   * blending; default EXACT (0). PRE_INTEGRATED (1) looks it up in a 3D table over the scalars at
   * both ends and the length, up to the longest edge of a cell (S. Roettger, M. Kraus, T. Ertl,
   * "Hardware-Accelerated Volume and Isosurface Rendering Based on Cell-Projection", 2000).
   * PRE_INTEGRATED_2D (2) leaves out the length (S. Guthe et al., "High-Quality Unstructured Volume
   * Rendering on the PC Platform", 2002): opacity follows from the mean extinction,
   * 1 - exp(-extinction * length), as it does exactly; colour counts as the mean that is seen of a
   * length of half the longest edge, times opacity.
   *
   * Tables take no cuts and are faster where functions have many nodes, but are blind to what is
   * smaller than their steps, and computed anew when the functions, the range of the scalars or the
   * scale of the volume's matrix change. They are for one component, without gradients and
   * shading: else EXACT stands in, with a warning.
   */
  void SetIntegration(int integration);
  vtkGetMacro(Integration, int);
  void SetIntegrationToExact() { this->SetIntegration(EXACT); }
  void SetIntegrationToPreIntegrated() { this->SetIntegration(PRE_INTEGRATED); }
  void SetIntegrationToPreIntegrated2D() { this->SetIntegration(PRE_INTEGRATED_2D); }
  //@}

  //@{
  /**
   * Texels of pre-integration's tables each way: 2 to 256, default 128. A 3D table takes 16 bytes a
   * texel, 32 MiB for 128.
   */
  void SetTableSize(int size);
  vtkGetMacro(TableSize, int);
  //@}

  //@{
  /**
   * A ray each so many pixels, in both directions, when rays are cast: 0.1 to 100, default 1. Above
   * 1 drawing is faster and colours are interpolated in between; below 1 it is smoother. Has no
   * effect where translucent props mix with the volume.
   */
  void SetImageSampleDistance(double distance);
  vtkGetMacro(ImageSampleDistance, double);
  //@}

  //@{
  /**
   * Whether the distance follows from the time that the volume has (vtkProp::
   * SetAllocatedRenderTime(), of a window's or interactor's DesiredUpdateRate) and the time that
   * the last picture took: from 1 to 10 pixels, whatever ImageSampleDistance says. Default off.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  //@}

  //@{
  /**
   * What the last render had to do with: the input's 3D cells that are not ghost, blanked, empty or
   * without scalars; how often rays enter the mesh, at most of all pixels' (asking for it draws,
   * and waits for the graphics card); bytes of mesh and tables on the GPU; how often, since the
   * mapper was made, the mesh was uploaded, a shader was built and a table was computed. Cameras
   * and edits of the property build none of them, but for the tables of pre-integration.
   */
  vtkIdType GetNumberOfDrawnCells();
  int GetNumberOfLayers();
  vtkTypeInt64 GetGraphicsMemorySize();
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  vtkIdType GetNumberOfTableBuilds();
  //@}

  //@{
  /// Of all blocks.
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->vtkAbstractMapper3D::GetBounds(bounds); }
  //@}

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGPUUnstructuredGridVolumeMapper();
  ~vtkGPUUnstructuredGridVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;

private:
  vtkGPUUnstructuredGridVolumeMapper(const vtkGPUUnstructuredGridVolumeMapper&) = delete;
  void operator=(const vtkGPUUnstructuredGridVolumeMapper&) = delete;

  bool UpdateMesh(vtkVolume* volume);
  bool UpdateFunctions(vtkVolume* volume);
  bool UpdateFeatures(vtkRenderer* renderer, vtkVolume* volume);
  bool UpdateTable();
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
  double ImageSampleDistance = 1.0;
  bool AutoAdjustSampleDistances = false;
};

#endif
