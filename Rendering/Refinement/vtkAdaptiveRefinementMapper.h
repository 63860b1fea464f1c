// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinementMapper
 * @brief   a polydata mapper that refines a coarse surface on the GPU in each frame
 *
 * Draws a coarse surface refined by a recipe (vtkAdaptiveRefinement) and stores no refined mesh.
 * Each coarse triangle is assigned a refinement pattern. One instanced draw call draws all
 * triangles that share a base pattern, and the vertex shader places the pattern's points on the
 * surface and displaces them. This method is Lenz's adaptive refinement kernel with fewer patterns
 * and instancing (ARKFPI, 2009). SetMethod() offers other methods for comparison, such as dynamic
 * mesh refinement (DMR) and semi-uniform adaptive patch tessellation (SUAPT). Lights, textures,
 * lookup tables, opacity, clipping planes, representations and selection are those of
 * vtkOpenGLPolyDataMapper. At level 0 without displacement the image is the same as VTK's.
 *
 * The input is a vtkPolyData, or a composite data set (vtkMultiBlockDataSet) with vtkPolyData
 * leaves; vtkBlockAttributesPolyDataMapper sets how each block looks. Polygons are split into
 * triangle fans. Vertices and lines are drawn unrefined. Scalars and texture coordinates are
 * interpolated over the refined surface and coloured as InterpolateScalarsBeforeMapping requests.
 * Interpolated integers stay integers; strings and bits take the value of the nearest point. For
 * categorical scalars (vtkScalarsToColors::IndexedLookup) the point colours are interpolated
 * instead, because there is no category between two others. Hardware selection returns the input's
 * cells and points. Translucent faces need depth peeling, because faces are drawn pattern by
 * pattern and not from back to front. Visible vertices (vtkProperty) are drawn once per face, so
 * translucent ones look denser than with vtkPolyDataMapper.
 *
 * SetPiece(), SetNumberOfPieces() and SetGhostLevel() request a piece from the pipeline. Cells that
 * another piece draws (DUPLICATECELL in vtkGhostType) are not drawn, whereas vtkPolyDataMapper
 * draws them. GetBounds() contains all positions that the surface and the displacement can reach.
 *
 * Levels are evaluated again only when the mesh or the recipe changes and, for view-dependent
 * metrics, when the camera, the actor's matrix or the viewport changes. Changes of the
 * displacement's scale, offset and direction and of surface parameters such as
 * vtkPhongSurface::SetAlpha() rebuild neither buffers nor shaders.
 *
 * VTK's pickers pick the refined surface. vtkCellPicker returns the nearest point with its normal,
 * the input's cell and point, the parametric and texture coordinates in that cell, and the block.
 * vtkPointPicker returns the input's points at their position on the surface. vtkPicker uses the
 * bounds. Pickers use the levels of the last frame. Before the first frame they use the levels of
 * the recipe without a view: MaximumLevel if the metric depends on the view. Picking intersects the
 * triangles of ARKFPI; the triangles of DMR, SUAPT and hardware tessellation differ from them
 * inside a face, but not on its edges. The GLSL of a vtkProceduralSurface does not affect picking.
 * The data set that vtkCellPicker returns has the input's cells and arrays, but is not the input
 * itself, and its normals are not an active attribute. Locators added to the picker are ignored;
 * none is needed. Subclasses of VTK's pickers behave the same. Other pickers that call
 * vtkMapper::GetInput() get the input.
 *
 * Requires OpenGL 3.3 with ARB_texture_buffer_object_rgb32. With OpenGL 4.3 the GPU can select the
 * patterns, see SetSelectionDevice(). These are errors (ErrorEvent of this object): no recipe, an
 * older OpenGL, depth-tags or texture coordinates that cannot be used, a metric or height map that
 * fails, and a mesh or height map larger than OpenGL can hold. The surface is then not drawn, and
 * rendering continues.
 *
 * @sa vtkAdaptiveRefinement vtkAdaptiveRefinementFilter
 */
#ifndef vtkAdaptiveRefinementMapper_h
#define vtkAdaptiveRefinementMapper_h

#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkBlockAttributesPolyDataMapper.h"
#include "vtkSmartPointer.h"  // for members
#include "vtkVersionMacros.h" // for FragmentShaderUsesPrimitiveID()

#include <functional> // for ForEachBlock()
#include <map>        // for parts
#include <memory>     // for Internals
#include <string>     // for reasons

class vtkAdaptiveRefinement;
class vtkIdTypeArray;
class vtkMultiProcessController;
class vtkProperty;
class vtkScalarsToColors;

namespace relevo
{
struct CullingView;
struct ShaderExtension;
struct ProcessAgreementPart;
struct StageResult;
class PieceReduction;
}

class RELEVORENDERINGREFINEMENT_EXPORT vtkAdaptiveRefinementMapper
  : public vtkBlockAttributesPolyDataMapper
{
public:
  static vtkAdaptiveRefinementMapper* New();
  vtkTypeMacro(vtkAdaptiveRefinementMapper, vtkBlockAttributesPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the recipe: the levels, the surface and the displacement. Required.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  //@{
  /**
   * Set whether coarse faces are culled whose refined, displaced surface lies outside the camera's
   * frustum. On by default. The image does not change.
   */
  void SetFrustumCulling(bool culling);
  vtkGetMacro(FrustumCulling, bool);
  vtkBooleanMacro(FrustumCulling, bool);
  //@}

  //@{
  /**
   * Set whether coarse faces that face away from the camera are culled. On by default. Back faces
   * are culled only if they cannot be visible: the surface is closed, its faces wind outwards and
   * it is seen from outside; it is linear or made of PN or Phong triangles without displacement; it
   * is opaque and uses VTK's own shaders; and nothing clips it, including the near plane. Requires
   * FrustumCulling. A few pixels of the silhouette may differ where front and back faces have the
   * same depth.
   */
  void SetBackFaceCulling(bool culling);
  vtkGetMacro(BackFaceCulling, bool);
  vtkBooleanMacro(BackFaceCulling, bool);
  //@}

  /**
   * The methods that draw refined faces.
   */
  enum Methods
  {
    METHOD_ARKFPI = 0,
    METHOD_ARK = 1,
    METHOD_DMR = 2,
    METHOD_SUAPT = 3,
    METHOD_HARDWARE_TESSELLATION = 4,
    METHOD_UNIFORM = 5
  };

  //@{
  /**
   * Set the method that draws refined faces. The default is METHOD_ARKFPI.
   *
   * METHOD_ARKFPI (0): one instanced draw call for all faces that share a base pattern (Lenz 2009).
   *
   * METHOD_ARK (1), the adaptive refinement kernel: one draw call per face; the CPU passes the
   * face's index, permutation and tags (Boubekeur and Schlick, A Flexible Kernel for Adaptive Mesh
   * Refinement on GPU, 2008). Vertices, order and image are bit-identical to ARKFPI. Back faces are
   * not culled: there are as many draw calls as coarse faces in the frustum.
   *
   * METHOD_DMR (2), dynamic mesh refinement: in each pass a geometry shader splits the triangles
   * whose edges have levels left, and transform feedback passes the result on to the next pass
   * (Lorenz and Doellner, Dynamic Mesh Refinement on GPU using Geometry Shaders, 2008). An edge is
   * split at its midpoint. A new edge between two midpoints gets the mean of the two edges' levels
   * minus one; a new edge between a midpoint and a corner gets half of the edge's level. A pass
   * splits one triangle into at most four, so level d takes d passes. The refined triangles stay on
   * the GPU, 48 bytes each, until the levels or the visible faces change. The number of segments
   * per edge is a power of two.
   *
   * METHOD_SUAPT (3), semi-uniform adaptive patch tessellation: each face is drawn, instanced, with
   * the uniform pattern of its finest edge. The shader moves the vertices on coarser edges to the
   * points of those edges (as compared in Lenz 2009), which leaves degenerate triangles.
   *
   * METHOD_HARDWARE_TESSELLATION (4): one patch per face, which the tessellator of OpenGL 4.0
   * subdivides. An edge has at most 64 segments, so level 7 is drawn as level 6. A face has about
   * 1.5 n^2 well-shaped triangles, where n is the number of segments of its finest edge. An edge
   * can have any whole number of segments. There is one draw call; software OpenGL needs one per
   * 65535 vertices. A vertex shader that the actor's vtkShaderProperty changes runs in the
   * tessellation evaluation stage. If it cannot run there, an error is reported and ARKFPI draws
   * until that shader or the method changes.
   *
   * METHOD_UNIFORM (5): all faces are drawn, instanced, with the uniform pattern of the finest edge
   * of the mesh (after Boubekeur and Schlick, Generic Mesh Refinement on GPU, 2005).
   *
   * All methods except METHOD_UNIFORM place the same points on edges of the same level, and all
   * draw surfaces without cracks. Only ARKFPI draws faces that the GPU has selected; the others
   * select on the CPU and ignore SetSelectionDevice(). ARKFPI and ARK can morph
   * (vtkAdaptiveRefinement::SetGeomorphing()); the others draw rounded levels. DMR and hardware
   * tessellation fall back to ARKFPI for wireframes, points, visible vertices and picking of
   * points. Faces coloured by level or pattern show the levels that their edges request; with SUAPT
   * and UNIFORM they show the uniform pattern. Targets and time budgets
   * (SetTargetNumberOfTriangles()) count ARKFPI's triangles. If OpenGL does not support a method,
   * lacks memory for it, or cannot draw the levels with it, one error is reported and ARKFPI draws.
   *
   * A change does not upload the mesh again. A value out of range is an error and changes nothing.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToARKFPI() { this->SetMethod(METHOD_ARKFPI); }
  void SetMethodToARK() { this->SetMethod(METHOD_ARK); }
  void SetMethodToDMR() { this->SetMethod(METHOD_DMR); }
  void SetMethodToSUAPT() { this->SetMethod(METHOD_SUAPT); }
  void SetMethodToHardwareTessellation() { this->SetMethod(METHOD_HARDWARE_TESSELLATION); }
  void SetMethodToUniform() { this->SetMethod(METHOD_UNIFORM); }
  //@}

  /// Return the method that the last render used; for a composite data set, the method of its last
  /// block.
  int GetMethodInUse();

  /**
   * The processors that select patterns and sort faces by them.
   */
  enum SelectionDevices
  {
    SELECTION_DEVICE_AUTOMATIC = 0,
    SELECTION_DEVICE_CPU = 1,
    SELECTION_DEVICE_GPU = 2
  };

  //@{
  /**
   * Set the processor that selects the faces' patterns and sorts the faces by pattern. A value out
   * of range is an error and changes nothing.
   *
   * SELECTION_DEVICE_CPU (1): the CPU, with the threads of vtkSMPTools. SELECTION_DEVICE_GPU (2):
   * compute shaders that feed indirect draw calls; only statistics are read back, and only on
   * request. Requires OpenGL 4.3; without it, one error is reported and the CPU selects.
   * SELECTION_DEVICE_AUTOMATIC (0, the default): the GPU if OpenGL 4.3 is available, except if
   * OpenGL itself runs on the CPU (llvmpipe, softpipe, swr), where that is slower.
   *
   * View-dependent metrics with a shader (distance, screen edges, silhouettes by the angle of
   * normals, view-dependent) are evaluated on the GPU, too; the tags of other metrics are uploaded.
   * Equal depth-tags give equal levels on both processors. Depth-tags are equal if the driver
   * rounds divisions and square roots according to IEEE 754. Otherwise, an edge whose tag is
   * halfway between two levels may get the other level. With the GPU, the faces of a pattern are
   * drawn in undefined order, and the first frame uploads all patterns up to MaximumLevel.
   *
   * The CPU always selects for whole numbers of segments
   * (vtkAdaptiveRefinement::SetSegmentPolicy()), for a target or time budget, and for colours of
   * the metric.
   */
  void SetSelectionDevice(int device);
  vtkGetMacro(SelectionDevice, int);
  void SetSelectionDeviceToAutomatic() { this->SetSelectionDevice(SELECTION_DEVICE_AUTOMATIC); }
  void SetSelectionDeviceToCPU() { this->SetSelectionDevice(SELECTION_DEVICE_CPU); }
  void SetSelectionDeviceToGPU() { this->SetSelectionDevice(SELECTION_DEVICE_GPU); }
  //@}

  /**
   * Return the processor that the last render used: SELECTION_DEVICE_CPU or SELECTION_DEVICE_GPU.
   * For a composite data set, return the GPU if any of its blocks used it.
   */
  int GetSelectionDeviceInUse();

  //@{
  /**
   * Set the number of triangles to draw. The default, 0, draws as many as the recipe gives.
   * Otherwise, each selection adds one offset to all levels, chosen so that
   * GetNumberOfDrawnTriangles() is as close to the target as possible, within 5 % where the levels
   * allow it. Culled faces do not count, so close-ups spend the target on visible faces. Triangles
   * over no data count. All blocks of a composite input share the target. Levels depend on the view
   * and the target alone, not on earlier frames, so they do not oscillate.
   *
   * If many edges have the same level before rounding, for example at the ends of a metric's range,
   * their faces change together and the result may stay below the target. In this case, choose a
   * metric that requests about as many triangles. Edges beside and behind the camera have infinite
   * length for vtkScreenEdgeDepthTagMetric and behave the same. A negative value is an error and
   * changes nothing.
   */
  void SetTargetNumberOfTriangles(vtkIdType triangles);
  vtkIdType GetTargetNumberOfTriangles();
  //@}

  //@{
  /**
   * Set whether levels are lowered if a frame would take longer than the time VTK allots to the
   * actor (vtkProp::GetAllocatedRenderTime(), in seconds). On by default. That time is the actor's
   * share of 1 / DesiredUpdateRate of the window, or of the renderer's time if that is less.
   * Interactor styles and ParaView request 15 frames per second while the mouse button is down, and
   * almost no frame rate otherwise. The time of a frame is predicted from the latest frames. Levels
   * are lowered so that a frame takes 85 % of the allotted time, and raised again when there is
   * clearly time to spare. With a still camera they settle within a few frames. The CPU and GPU
   * time to draw this mapper's surface counts.
   */
  void SetUseAllocatedRenderTime(bool use);
  vtkGetMacro(UseAllocatedRenderTime, bool);
  vtkBooleanMacro(UseAllocatedRenderTime, bool);
  //@}

  /**
   * Make the mappers of several processes agree before a frame is drawn. Each process has a piece
   * of every block, with a layer of ghost cells. The processes share one level offset for target
   * and time, the quantiles and ranges of metrics, and the point that coordinates are relative to.
   * This call is collective: all processes make it, including those with no data. Without a
   * controller (nullptr, the default) or with one process, the mapper uses its local data only.
   */
  void AgreeWithProcesses(vtkMultiProcessController* controller, vtkRenderer* ren, vtkActor* act);

  /**
   * Return the offset, in levels, that the target or the allotted time has added to the recipe's
   * LevelOffset in the last render; 0 if there was none. vtkAdaptiveRefinementFilter generates the
   * same mesh from a recipe whose LevelOffset is the sum of both.
   */
  double GetLevelOffset();

  /**
   * The values that colours of refined faces can show.
   */
  enum RefinementColorModes
  {
    COLOR_BY_SCALARS = 0,
    COLOR_BY_LEVEL = 1,
    COLOR_BY_PATTERN = 2,
    COLOR_BY_METRIC = 3
  };

  //@{
  /**
   * Set the values that colour the refined faces. Scalars (the default): scalars or the actor's
   * colour, as in VTK. Level: the highest level of the coarse face's edges (log2 of the segments,
   * rounded up). Pattern: the base pattern of the coarse face. Metric: the tags that determine the
   * levels, in [0, MaximumLevel], interpolated linearly between points or, with levels per edge,
   * blended so that each edge shows its tag. The actor's lighting, textures and opacity still
   * apply.
   *
   * VTK's own modes (SetColorModeToDefault(), SetColorModeToMapScalars(),
   * SetColorModeToDirectScalars()) return to colours of scalars. GetColorMode() always returns
   * VTK's mode.
   */
  void SetColorModeToScalars() { this->SetRefinementColorMode(COLOR_BY_SCALARS); }
  void SetColorModeToLevel() { this->SetRefinementColorMode(COLOR_BY_LEVEL); }
  void SetColorModeToPattern() { this->SetRefinementColorMode(COLOR_BY_PATTERN); }
  void SetColorModeToMetric() { this->SetRefinementColorMode(COLOR_BY_METRIC); }
  int GetRefinementColorMode() { return this->RefinementColorMode; }
  void SetColorMode(int mode) override;
  //@}

  //@{
  /**
   * Set the lookup table for colours of levels, patterns or tags. Levels map the values 0, 1, ...,
   * MaximumLevel. Patterns map vtkRefinementPatternTable::GetPatternIndex() of their levels; with
   * whole numbers of segments, its arguments are the indices of these numbers in the sequence 1, 2,
   * ..., 16, 18, 20, .... The table's opacity is not used. By default, and after nullptr, the
   * mapper uses a table that follows the mode and the recipe: viridis, or distinct colours for
   * patterns. This table is annotated, so a vtkScalarBarActor can show it as a legend.
   */
  void SetLevelLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLevelLookupTable();
  //@}

  //@{
  /**
   * Return the number of triangles of the surface that the last render drew, and that of the culled
   * faces. With ARKFPI and ARK the sum equals the number of triangles that
   * vtkAdaptiveRefinementFilter generates for the same recipe and camera. The other methods return
   * the number that they generate from the same levels, including triangles over no data.
   */
  vtkIdType GetNumberOfDrawnTriangles();
  vtkIdType GetNumberOfCulledTriangles();
  //@}

  //@{
  /**
   * Return the number of coarse triangles in the last render, 0 if nothing could be drawn, and the
   * number of those that were culled.
   */
  vtkIdType GetNumberOfCoarseFaces();
  vtkIdType GetNumberOfCulledFaces();
  //@}

  //@{
  /**
   * Return the number of draw calls of the last render for refined faces (an indirect call counts
   * once), and the number of base patterns that its levels use. ARKFPI and ARK draw these patterns.
   */
  int GetNumberOfDrawCalls();
  int GetNumberOfUsedPatterns();
  //@}

  /**
   * Count the faces that the last render drew by their patterns. The array gets a tuple of five
   * numbers for each pattern: the numbers of segments of its edges in descending order, the number
   * of faces, and the number of their triangles. Patterns are sorted, those with the most segments
   * first. These are the patterns of the requested levels; only ARKFPI and ARK draw exactly these
   * triangles. Triangles over no data count. If the GPU has selected the patterns, this reads them
   * back once per selection.
   */
  void GetPatternCounts(vtkIdTypeArray* counts);

  //@{
  /**
   * Return how often levels have been evaluated, the coarse mesh uploaded and shaders built since
   * the mapper was created. Changes of a displacement's scale, offset and direction and of surface
   * parameters increase neither the number of uploads nor that of shaders.
   */
  vtkIdType GetNumberOfSelections();
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  //@}

  /**
   * Return the time of the last evaluation of levels in seconds, without the upload. On the GPU it
   * is the time to submit the evaluation.
   */
  double GetSelectionTime();

  /// Return the number of bytes on the GPU: coarse buffers (including VTK's), patterns and height
  /// textures.
  virtual vtkTypeInt64 GetGraphicsMemorySize();

  //@{
  /// Return whether there is opaque or translucent geometry. A composite data set can have both;
  /// each block is drawn in its own pass.
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  //@}

  //@{
  /**
   * Return the bounds of all positions that the surface and the displacement can reach.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override;
  //@}

  //@{
  /// Return the input: as vtkPolyData, or of any type. Pickers get the picked surface instead.
  vtkPolyData* GetInput();
  vtkDataSet* GetInputAsDataSet();
  vtkDataObject* GetInputDataObject(int port, int connection);
  //@}

  using vtkOpenGLPolyDataMapper::MapScalars;
  /**
   * Map the scalars to colours like vtkMapper. If VTK cannot map the array (too few tuples, or
   * unmapped with more components than a colour has), an error is reported and the surface is drawn
   * without these colours.
   */
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;

  void RenderPiece(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceStart(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceDraw(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceFinish(vtkRenderer* ren, vtkActor* act) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  /// Includes the modification times of the recipe, of all its parts, and of the lookup table of
  /// levels.
  vtkMTimeType GetMTime() override;
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* sel, std::vector<unsigned int>& pixeloffsets, vtkProp* prop) override;

protected:
  vtkAdaptiveRefinementMapper();
  ~vtkAdaptiveRefinementMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  /// Return the data object to draw instead of an input. Subclasses override it to accept other
  /// types.
  virtual vtkDataObject* ConvertInput(vtkDataObject* input) { return input; }
  void ComputeBounds() override;
  bool GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  void BuildIBO(vtkRenderer* ren, vtkActor* act, vtkPolyData* poly) override;
  std::vector<std::pair<vtkTexture*, std::string>> GetTextures(vtkActor* act) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void BuildShaders(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor* actor) override;

  //@{
  /**
   * These methods let subclasses draw the refined faces again with another shader. AddFaceHelper()
   * creates a helper of this mapper. DrawFaces() draws the faces with it, within RenderPieceDraw()
   * and if IsDrawable() is true. IsFaceHelper() returns whether a helper draws refined faces.
   */
  vtkOpenGLHelper* AddFaceHelper();
  bool IsFaceHelper(const vtkOpenGLHelper* helper) const;
  void DrawFaces(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act);
  bool IsDrawable() const;
  //@}

  /// Fill in the extension of a helper's vertex shader, in subclasses. Shaders are rebuilt when the
  /// extension changes.
  virtual void ExtendShaders(const vtkOpenGLHelper*, relevo::ShaderExtension&);

  /// Draw the input in one pass; of a composite data set, draw the blocks that belong to the pass.
  virtual void RenderRefined(vtkRenderer* ren, vtkActor* act);

  //@{
  /**
   * The mappers of a composite input's blocks have the class of this one. UpdateBlocks() creates
   * one for each block, with the settings that ShallowCopy() copies, before the blocks draw.
   * DrawsAllBlocks() returns whether RenderRefined() draws all visible blocks in every pass; the
   * default is false.
   */
  void UpdateBlocks() override;
  void ForEachBlock(const std::function<void(vtkAdaptiveRefinementMapper*)>& work) const;
  virtual bool DrawsAllBlocks() const { return false; }
  //@}

private:
  vtkAdaptiveRefinementMapper(const vtkAdaptiveRefinementMapper&) = delete;
  void operator=(const vtkAdaptiveRefinementMapper&) = delete;

  struct vtkInternals;

  bool IsComposite();
  /// Return whether a composite input has translucent blocks, or opaque ones.
  bool HasBlocks(bool translucent);
  void RenderBlocks(vtkRenderer* ren, vtkActor* act);
  /// Return whether the mapper supports the type of the input and of its blocks. If not, report an
  /// error once per input.
  bool CheckInputType();
  /// Release the mesh of the previous input if the new one has blocks.
  void ReleaseMesh(vtkRenderer* ren);
  /// Call a function for each mapper that drew in the last render: this mapper, or those of its
  /// blocks.
  void ForEachPart(const std::function<void(vtkAdaptiveRefinementMapper*)>& work);
  vtkIdType CountTrianglesOfPass(bool isSlow);
  vtkIdType SumOverParts(const std::function<vtkIdType(vtkInternals&)>& count);
  /// Continue counting after a removed block.
  void AddCounts(vtkAdaptiveRefinementMapper* block);
  std::map<unsigned int, relevo::ProcessAgreementPart> FindParts();

  //@{
  /// The data that VTK's pickers get instead of the input.
  vtkDataObject* ReplaceInput(vtkDataObject* input);
  bool IsPickable();
  vtkPolyData* GetPickedData(bool isAsked);
  //@}

  //@{
  /// The stages of a frame, in this order.
  bool UpdateMesh();
  void ChooseMethod(vtkRenderer* ren, vtkActor* act);
  void UpdateBudget(
    vtkRenderer* ren, vtkActor* act, const relevo::PieceReduction* pieces = nullptr);
  void UploadSelection();
  void UpdateFaceColors();
  void UpdateShaderOptions(const vtkOpenGLHelper* cellBO);
  void UpdateRefiningShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act);
  bool BuildStages(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act);
  void FallBackToDefaultMethod(vtkActor* act);
  void ReadSelection();
  //@}

  /// Report the errors and warnings of a stage. Return whether the frame can continue.
  bool Report(const relevo::StageResult& result);

  /// Return the view for culling, or nullptr to draw all faces.
  std::unique_ptr<relevo::CullingView> MakeCullingView(vtkRenderer* ren, vtkActor* act);
  /// HidesBackFaces() returns whether back faces of closed surfaces are culled in this pass, and
  /// CanHideBackFaces() whether they are culled in passes that show the surface.
  bool HidesBackFaces(vtkRenderer* ren, vtkActor* act);
  bool CanHideBackFaces(vtkActor* act);

  /// Activate the shaders of this actor and renderer, because several of them can share the mapper.
  void UseShaderVariant(vtkRenderer* ren, vtkActor* act);
  /// Use the shift and scale of the whole data for a piece.
  void BuildBufferObjectsOfPiece(vtkRenderer* ren, vtkActor* act);
  vtkAbstractArray* GetScalarsToInterpolate();
  bool AreDirectColors(vtkAbstractArray* scalars);
  /// Return whether VTK's own mapper would draw the vertices of faces.
  static bool AreVerticesDrawn(vtkProperty* property, vtkHardwareSelector* selector);
  void SetRefinementColorMode(RefinementColorModes mode);
  void CopySettings(vtkAdaptiveRefinementMapper* other);

  vtkSmartPointer<vtkAdaptiveRefinement> Refinement;
  bool UseAllocatedRenderTime = true;
  bool FrustumCulling = true;
  bool BackFaceCulling = true;
  int Method = METHOD_ARKFPI;
  int SelectionDevice = SELECTION_DEVICE_AUTOMATIC;
  RefinementColorModes RefinementColorMode = COLOR_BY_SCALARS;
  vtkSmartPointer<vtkScalarsToColors> LevelLookupTable;
  std::unique_ptr<vtkInternals> Internals;

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 20260726)
  bool FragmentShaderUsesPrimitiveID(vtkRenderer* ren, vtkActor* act) override;
#endif
};

#endif
