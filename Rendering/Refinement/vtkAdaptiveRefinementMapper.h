// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinementMapper
 * @brief   a polydata mapper that refines every frame on the GPU and stores nothing refined
 *
 * Draws a coarse surface as its recipe says: each coarse triangle takes a pattern, the triangles
 * that share a base pattern are drawn by one instanced call, and the vertex shader maps the
 * pattern's points onto the surface and displaces them. This is Lenz's adaptive refinement kernel
 * with fewer patterns and instancing (ARKFPI, 2009). SetMethod() offers others for comparison, such
 * as dynamic mesh refinement (DMR) and semi-uniform adaptive patch tessellation (SUAPT). Everything
 * else is vtkOpenGLPolyDataMapper: lights, textures, lookup tables, opacity, clipping planes,
 * representations, selection. At level 0 without displacement the picture is the same.
 *
 * Input: a vtkPolyData, or a composite data set (vtkMultiBlockDataSet) whose vtkPolyData leaves are
 * drawn, see vtkBlockAttributesPolyDataMapper for how each looks. Polygons are cut into fans;
 * vertices and lines are drawn as they are. Scalars and texture coordinates are interpolated over
 * the refined surface, and coloured as InterpolateScalarsBeforeMapping says. Integers stay
 * integers; strings and bits are those of the nearest point. Where scalars are categories
 * (vtkScalarsToColors::IndexedLookup), colours of points are interpolated instead, because there is
 * no category between two others. Hardware selection returns the input's cells and points.
 * Translucent faces need depth peeling: faces are drawn pattern by pattern, not back to front.
 * Visible vertices (vtkProperty) are drawn once for each face: translucent ones look denser than
 * vtkPolyDataMapper's.
 *
 * SetPiece(), SetNumberOfPieces() and SetGhostLevel() ask the pipeline for a piece. Cells whose
 * vtkGhostType says that another piece draws them (DUPLICATECELL) are not drawn; vtkPolyDataMapper
 * draws them. GetBounds() contains everything that the surface and the displacement can reach.
 *
 * Levels are evaluated again only when the mesh, the recipe or, for view-dependent metrics, the
 * camera, the actor's matrix or the viewport changed. The displacement's scale, offset and
 * direction change live, and so do the surface's own numbers, as vtkPhongSurface::SetAlpha().
 *
 * VTK's pickers find the surface that is drawn: vtkCellPicker its nearest point, with the normal,
 * the input's cell and point, parametric and texture coordinates of that cell, and the block;
 * vtkPointPicker the input's points where the surface has them; vtkPicker its bounds. They use the
 * levels of the last frame. Before the first frame they use what the recipe gives without a view:
 * MaximumLevel where the metric depends on the view. Picked are the triangles of ARKFPI; those of
 * DMR, SUAPT and hardware tessellation differ from them inside a face, but not on its edges. The
 * GLSL of a vtkProceduralSurface does not affect picking. The data set that vtkCellPicker returns
 * has the input's cells and arrays, but is not the input itself, and normals are not an active
 * attribute of it. Locators that are added to the picker are ignored; none is needed. Subclasses of
 * VTK's pickers find the same; any other picker, which calls vtkMapper::GetInput(), gets the input.
 *
 * Needs OpenGL 3.3 with ARB_texture_buffer_object_rgb32; with OpenGL 4.3 faces can choose their
 * patterns on the GPU (see SetSelectionDevice()). Errors (ErrorEvent of this object; the surface is
 * then not drawn, and rendering continues): no recipe, an older OpenGL, depth-tags or texture
 * coordinates that cannot be used, a metric or height map that fails, a mesh or height map larger
 * than OpenGL can hold.
 *
 * @sa vtkAdaptiveRefinement vtkAdaptiveRefinementFilter
 */
#ifndef vtkAdaptiveRefinementMapper_h
#define vtkAdaptiveRefinementMapper_h

#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkBlockAttributesPolyDataMapper.h"
#include "vtkSmartPointer.h" // for members

#include <functional> // for ForEachBlock()
#include <map>        // for parts
#include <memory>     // for Internals
#include <string>     // for reasons

class vtkAdaptiveRefinement;
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
   * What to refine to. Required.
   */
  void SetRefinement(vtkAdaptiveRefinement* refinement);
  vtkAdaptiveRefinement* GetRefinement();
  //@}

  //@{
  /**
   * Whether coarse faces are left out, on by default, if nothing that surface and displacement can
   * make of them lies in the frustum of the pass's camera. The picture stays the same.
   */
  void SetFrustumCulling(bool culling);
  vtkGetMacro(FrustumCulling, bool);
  vtkBooleanMacro(FrustumCulling, bool);
  //@}

  //@{
  /**
   * Whether coarse faces that face away from the camera are left out where they cannot be seen; on
   * by default. This holds for closed surfaces whose faces wind outwards, seen from outside; linear
   * or of PN or Phong triangles, without displacement; opaque, with VTK's own shaders; and not
   * clipped, not even by the near plane. Needs FrustumCulling. At most a few pixels of the outline
   * differ, where front and back have the same depth.
   */
  void SetBackFaceCulling(bool culling);
  vtkGetMacro(BackFaceCulling, bool);
  vtkBooleanMacro(BackFaceCulling, bool);
  //@}

  /**
   * How refined faces are drawn.
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
   * METHOD_ARKFPI (0, the default): one instanced draw call for all faces that share a base pattern
   * (Lenz 2009).
   *
   * METHOD_ARK (1), the adaptive refinement kernel: one draw call per face, with the face's number,
   * permutation and tags from the CPU (Boubekeur and Schlick, A Flexible Kernel for Adaptive Mesh
   * Refinement on GPU, 2008). Same vertices, order and picture as ARKFPI, to the bit. Back faces
   * are not culled: there are as many draw calls as coarse faces in the frustum.
   *
   * METHOD_DMR (2), dynamic mesh refinement: in each pass a geometry shader splits the triangles
   * whose edges have levels left, and transform feedback passes them on to the next pass (Lorenz
   * and Doellner, Dynamic Mesh Refinement on GPU using Geometry Shaders, 2008). An edge is cut at
   * its middle. A new edge between two middles has the mean of the two edges' levels less one; one
   * between a middle and a corner has half of the edge's level. A pass makes at most four triangles
   * of one, so level d takes d passes. The refined triangles stay on the GPU, 48 bytes each, until
   * the levels or the visible faces change. Edges can have powers of two of segments only.
   *
   * METHOD_SUAPT (3), semi-uniform adaptive patch tessellation: each face has the uniform pattern
   * of its highest edge, instanced, and the shader moves the vertices on its coarser edges to the
   * points of these edges (as compared in Lenz 2009), which leaves triangles without area.
   *
   * METHOD_HARDWARE_TESSELLATION (4): one patch per face, which the tessellator of OpenGL 4.0
   * divides. Edges have at most 64 segments: level 7 is drawn as level 6. There are about 1.5 n^2
   * well shaped triangles, n the segments of the finest edge. Edges can have any whole number of
   * segments. One draw call; software OpenGL takes one for each 65535 vertices. A vertex
   * shader that the actor's vtkShaderProperty changes runs in the tessellation evaluation stage; if
   * it cannot run there, that is an error and ARKFPI draws until that shader or the method changes.
   *
   * METHOD_UNIFORM (5): all faces have the uniform pattern of the highest level of any edge of the
   * mesh, instanced (after Boubekeur and Schlick, Generic Mesh Refinement on GPU, 2005).
   *
   * All methods but METHOD_UNIFORM put the same points on edges of the same levels, and all draw
   * surfaces without cracks. Only ARKFPI draws what the GPU has selected; the others select on the
   * CPU whatever SetSelectionDevice() says. ARKFPI and ARK can morph
   * (vtkAdaptiveRefinement::SetGeomorphing()); the others draw rounded levels. What DMR and
   * hardware tessellation cannot draw is drawn by ARKFPI: wireframes, points, visible vertices and
   * picking of points. Faces coloured by level or pattern show what their edges ask for; under
   * SUAPT and UNIFORM they show the uniform pattern. Targets and time budgets
   * (SetTargetNumberOfTriangles()) count ARKFPI's triangles. Where OpenGL lacks what a method
   * needs, or room for it, or it cannot draw such levels, an error says so once and ARKFPI draws.
   *
   * A change does not upload the mesh again. Another value is an error and changes nothing.
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

  /// The method that the last render used; for a composite data set, that of its last part.
  int GetMethodInUse();

  /**
   * Where faces choose their patterns and are sorted by them.
   */
  enum SelectionDevices
  {
    SELECTION_DEVICE_AUTOMATIC = 0,
    SELECTION_DEVICE_CPU = 1,
    SELECTION_DEVICE_GPU = 2
  };

  //@{
  /**
   * SELECTION_DEVICE_CPU (1): on the CPU, with as many threads as vtkSMPTools has.
   * SELECTION_DEVICE_GPU (2): in compute shaders, which feed indirect draws; nothing is read back
   * but statistics when they are asked for. Needs OpenGL 4.3: without it, an error says so once and
   * the CPU does it. SELECTION_DEVICE_AUTOMATIC (0, the default): on the GPU where there is OpenGL
   * 4.3, unless OpenGL itself runs on the CPU (llvmpipe, softpipe, swr), where that is slower.
   * Another value is an error and changes nothing.
   *
   * View-dependent metrics that have a shader (distance, screen edges, silhouettes by the angle of
   * normals, view-dependent) are evaluated on the GPU, too; tags of other metrics are uploaded. For
   * the same depth-tags both devices give the same levels. Depth-tags are the same as far as the
   * driver rounds quotients and square roots as IEEE 754 demands; where it does not, an edge whose
   * tag is halfway between two levels may get the other one. The GPU draws the faces of a pattern
   * in no defined order. It loads all patterns up to MaximumLevel with the first picture.
   *
   * The CPU always selects whole numbers of segments (vtkAdaptiveRefinement::SetSegmentPolicy()),
   * and where tags are needed: for a target or time budget, and colours of the metric.
   */
  void SetSelectionDevice(int device);
  vtkGetMacro(SelectionDevice, int);
  void SetSelectionDeviceToAutomatic() { this->SetSelectionDevice(SELECTION_DEVICE_AUTOMATIC); }
  void SetSelectionDeviceToCPU() { this->SetSelectionDevice(SELECTION_DEVICE_CPU); }
  void SetSelectionDeviceToGPU() { this->SetSelectionDevice(SELECTION_DEVICE_GPU); }
  //@}

  /**
   * What the last render used: SELECTION_DEVICE_CPU or SELECTION_DEVICE_GPU; for a composite data
   * set, the GPU if any of its parts used it.
   */
  int GetSelectionDeviceInUse();

  //@{
  /**
   * How many triangles to draw; 0, the default, for as many as the recipe gives. Otherwise each
   * selection adds the same offset to all levels, the one that brings GetNumberOfDrawnTriangles()
   * nearest to the target: within 5 % where that is possible. Culled faces do not count: close-ups
   * spend the target on what they show. Triangles over no-data count. All blocks of a composite
   * input share the target. Levels depend on the view and the target alone, not on earlier frames,
   * so they do not oscillate. Where many edges have the same
   * level before rounding, as at the ends of a metric's range, their faces change together and the
   * result may stay below the target: choose a metric that asks for about as many triangles. Edges
   * beside and behind the eye, endless to vtkScreenEdgeDepthTagMetric, are such edges too. A
   * negative value is an error and changes nothing.
   */
  void SetTargetNumberOfTriangles(vtkIdType triangles);
  vtkIdType GetTargetNumberOfTriangles();
  //@}

  //@{
  /**
   * Whether a frame may take no longer than the time VTK allots to the actor, on by default:
   * vtkProp::GetAllocatedRenderTime() in seconds, its share of 1 / DesiredUpdateRate of the window,
   * or of its renderer's time where that is less. Interaction styles and ParaView ask for 15 frames
   * a second while the mouse is down, and for almost no frame rate otherwise. If a frame would take
   * longer, judging by the latest ones, levels are lowered so that it takes 85 % of the time, and
   * raised again when there is clearly time: with a still camera they settle within a few frames.
   * Counted is drawing this mapper's surface, on the CPU and the GPU.
   */
  void SetUseAllocatedRenderTime(bool use);
  vtkGetMacro(UseAllocatedRenderTime, bool);
  vtkBooleanMacro(UseAllocatedRenderTime, bool);
  //@}

  /**
   * Collective, before a frame is drawn: the mappers of several processes, each of which has a
   * piece of every block, with a layer of ghost cells, agree on what their levels and points have
   * in common: one offset for target and time, the quantiles and ranges of metrics, and the place
   * that coordinates are taken relative to. All processes call it, whatever they have. Without a
   * controller (nullptr), or with one process, this mapper is on its own, the default.
   */
  void AgreeWithProcesses(vtkMultiProcessController* controller, vtkRenderer* ren, vtkActor* act);

  /**
   * What the target or the allotted time has added to the recipe's LevelOffset in the last render,
   * in levels; 0 for none. vtkAdaptiveRefinementFilter makes the same mesh by a recipe whose
   * LevelOffset is the sum of both.
   */
  double GetLevelOffset();

  /**
   * What the refined faces are coloured by.
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
   * What the refined faces are coloured by: scalars or the actor's colour, as VTK does (the
   * default); the highest level of each coarse face's edges (log2 of segments, rounded up); the
   * base pattern of each coarse face; or the tags that decide on the levels, in [0, MaximumLevel]:
   * linear between points or, where levels are set per edge, blended so that an edge shows its own
   * tag. Lights, textures and opacity of the actor remain.
   *
   * VTK's own modes (SetColorModeToDefault(), SetColorModeToMapScalars(),
   * SetColorModeToDirectScalars()) colour by scalars again; GetColorMode() is always VTK's.
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
   * The colours of levels (mapped from 0, 1, ..., MaximumLevel), of patterns (mapped from
   * vtkRefinementPatternTable::GetPatternIndex(); where edges take any whole number of segments,
   * with the positions of these numbers in the sequence 1, 2, ..., 16, 18, 20, ... for levels) or
   * of tags. The table's opacity is not used. By default, and after nullptr, a table that follows
   * the mode and the recipe: viridis, or distinct colours for patterns. It is annotated, so a
   * vtkScalarBarActor of this table is a legend.
   */
  void SetLevelLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLevelLookupTable();
  //@}

  //@{
  /**
   * Triangles of the surface that the last render has drawn, and those of culled faces. With ARKFPI
   * and ARK both together are as many as vtkAdaptiveRefinementFilter gives for the same recipe and
   * camera; with the other methods, what they make of the same levels, also over no-data.
   */
  vtkIdType GetNumberOfDrawnTriangles();
  vtkIdType GetNumberOfCulledTriangles();
  //@}

  //@{
  /**
   * Coarse triangles of the last render, 0 if nothing could be drawn, and those of them that it
   * left out because they could not be seen.
   */
  vtkIdType GetNumberOfCoarseFaces();
  vtkIdType GetNumberOfCulledFaces();
  //@}

  //@{
  /**
   * Draw calls of the last render for refined faces (an indirect call is one), and base patterns
   * that its levels ask for: those that ARKFPI and ARK draw.
   */
  int GetNumberOfDrawCalls();
  int GetNumberOfUsedPatterns();
  //@}

  //@{
  /**
   * How often levels have been evaluated, the coarse mesh uploaded and shaders written, since the
   * mapper was made. The latter two do not grow with the values that change live: a displacement's
   * scale, offset and direction, and the surface's own numbers.
   */
  vtkIdType GetNumberOfSelections();
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  //@}

  /**
   * Seconds the last evaluation of levels took, without the upload; on the GPU, to submit it.
   */
  double GetSelectionTime();

  /// Bytes on the GPU: coarse buffers (VTK's own included), patterns and height textures.
  virtual vtkTypeInt64 GetGraphicsMemorySize();

  //@{
  /// A composite data set can have both: each block is drawn in its own pass.
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  //@}

  //@{
  /**
   * Bounds of what is drawn: surface and displacement enlarge them by what they can reach.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override;
  //@}

  //@{
  /// The input, if it is a vtkPolyData, and whatever it is: never what pickers get in its place.
  vtkPolyData* GetInput();
  vtkDataSet* GetInputAsDataSet();
  vtkDataObject* GetInputDataObject(int port, int connection);
  //@}

  using vtkOpenGLPolyDataMapper::MapScalars;
  /**
   * As vtkMapper's. An array that VTK cannot map (too few tuples, or unmapped with more components
   * than a colour has) is an error, and there are no colours.
   */
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;

  void RenderPiece(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceStart(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceDraw(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceFinish(vtkRenderer* ren, vtkActor* act) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  /// Includes the times of the recipe with all its parts, and of the table of levels.
  vtkMTimeType GetMTime() override;
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* sel, std::vector<unsigned int>& pixeloffsets, vtkProp* prop) override;

protected:
  vtkAdaptiveRefinementMapper();
  ~vtkAdaptiveRefinementMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  /// What to draw in place of an input that a subclass takes, too, whenever it is asked for.
  virtual vtkDataObject* ConvertInput(vtkDataObject* input) { return input; }
  void ComputeBounds() override;
  bool GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  void BuildIBO(vtkRenderer* ren, vtkActor* act, vtkPolyData* poly) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void BuildShaders(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void SetMapperShaderParameters(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  void UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor* actor) override;

  //@{
  /**
   * For subclasses that draw the refined faces once more, with a shader of their own.
   * AddFaceHelper() makes a helper of this mapper; DrawFaces() draws the faces with it, within
   * RenderPieceDraw() and if IsDrawable(). IsFaceHelper(): whether a helper draws refined faces.
   */
  vtkOpenGLHelper* AddFaceHelper();
  bool IsFaceHelper(const vtkOpenGLHelper* helper) const;
  void DrawFaces(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act);
  bool IsDrawable() const;
  //@}

  /// For subclasses that add to the vertex shader of a helper's faces: they fill in the extension.
  /// Shaders are written anew when it has changed.
  virtual void ExtendShaders(const vtkOpenGLHelper*, relevo::ShaderExtension&);

  /// One pass over the input: of a composite data set, the blocks that belong to the pass.
  virtual void RenderRefined(vtkRenderer* ren, vtkActor* act);

  //@{
  /**
   * The mappers of a composite input's blocks are of the class of this one. UpdateBlocks() has one
   * for each, with the settings that ShallowCopy() copies; it runs before they draw. Whether
   * RenderRefined() draws all visible blocks, whatever the pass is: by default it does not.
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
  /// Whether a composite input has blocks that are translucent, or such that are not.
  bool HasBlocks(bool translucent);
  void RenderBlocks(vtkRenderer* ren, vtkActor* act);
  /// Whether the input is of a type that the mapper takes; an error, once for each input, where it
  /// is not, or where one of its blocks is not.
  bool CheckInputType();
  /// Of the input before, when it has blocks now.
  void ReleaseMesh(vtkRenderer* ren);
  /// What the last render drew: this mapper, or those of its blocks.
  void ForEachPart(const std::function<void(vtkAdaptiveRefinementMapper*)>& work);
  vtkIdType CountTrianglesOfPass(bool isSlow);
  vtkIdType SumOverParts(const std::function<vtkIdType(vtkInternals&)>& count);
  /// Continue counting after a removed block.
  void AddCounts(vtkAdaptiveRefinementMapper* block);
  std::map<unsigned int, relevo::ProcessAgreementPart> FindParts();

  //@{
  /// What VTK's pickers get in place of the input.
  vtkDataObject* ReplaceInput(vtkDataObject* input);
  bool IsPickable();
  vtkPolyData* GetPickedData(bool isAsked);
  //@}

  //@{
  /// Stages of a frame, in this order.
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

  /// Report what a stage has found; returns whether the frame can go on.
  bool Report(const relevo::StageResult& result);

  /// What the camera sees; nullptr to draw all faces.
  std::unique_ptr<relevo::CullingView> MakeCullingView(vtkRenderer* ren, vtkActor* act);
  /// Whether back faces of closed surfaces are culled in this pass, and whether they are in the
  /// passes that show the surface.
  bool HidesBackFaces(vtkRenderer* ren, vtkActor* act);
  bool CanHideBackFaces(vtkActor* act);

  /// Several actors and renderers that share the mapper have shaders of their own.
  void UseShaderVariant(vtkRenderer* ren, vtkActor* act);
  /// Shift and scale a piece as the whole.
  void BuildBufferObjectsOfPiece(vtkRenderer* ren, vtkActor* act);
  vtkAbstractArray* GetScalarsToInterpolate();
  /// Whether VTK's own mapper would draw the vertices of faces.
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
};

#endif
