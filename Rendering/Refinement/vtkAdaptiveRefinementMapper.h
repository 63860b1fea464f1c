// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRefinementMapper
 * @brief   a polydata mapper that refines every frame on the GPU and stores nothing refined
 *
 * Draws a coarse surface as its recipe says: each coarse triangle takes a pattern, the triangles
 * that share a base pattern are drawn by one instanced call, and the vertex shader maps the
 * pattern's points onto the surface and displaces them (ARKFPI, Lenz 2009). Everything else is
 * vtkOpenGLPolyDataMapper: lights, textures, lookup tables, opacity, clipping planes,
 * representations, selection. At level 0 without displacement the picture is the same. Other
 * methods of refinement are there to compare, see SetMethod().
 *
 * Input: a vtkPolyData, or a composite data set (vtkMultiBlockDataSet) whose vtkPolyData leaves are
 * drawn, see vtkBlockAttributesPolyDataMapper for how each looks. Polygons are cut into fans;
 * vertices and lines are drawn as they are. Scalars and texture coordinates are interpolated over
 * the refined surface, and coloured as InterpolateScalarsBeforeMapping says; whole numbers stay
 * whole, names and bits are the nearest point's. Where numbers are categories
 * (vtkScalarsToColors::IndexedLookup), colours of points are interpolated instead, for lack of a
 * category between two. Hardware selection returns the input's cells and points. Translucent faces
 * need depth peeling: else their order shows, which is by patterns. Visible vertices (vtkProperty)
 * are drawn once for each face: translucent ones look denser than vtkPolyDataMapper's.
 *
 * SetPiece(), SetNumberOfPieces() and SetGhostLevel() ask the pipeline for a piece. Cells whose
 * vtkGhostType says that another piece draws them (DUPLICATECELL) are not drawn, unlike by
 * vtkPolyDataMapper. GetBounds() is of all that surface and displacement can reach.
 *
 * Levels are evaluated again only when the mesh, the recipe or, for view-dependent metrics, the
 * camera, the actor's matrix or the viewport changed. The displacement's scale, offset and
 * direction change live, and so do the surface's own numbers, as vtkPhongSurface::SetAlpha().
 *
 * VTK's pickers find the surface that is drawn: vtkCellPicker its nearest point, with the normal,
 * the input's cell and point, parametric and texture coordinates of that cell, and the block;
 * vtkPointPicker the input's points where the surface has them; vtkPicker its bounds. They ask for
 * the levels of the last frame, or, before one, for what the recipe gives without a view, which of
 * metrics of the view is MaximumLevel. Inside a face, DMR, SUAPT and tessellation draw other
 * triangles than those that are picked, ARKFPI's, which meet them on edges. What a
 * vtkProceduralSurface's GLSL adds is not picked. The data set that vtkCellPicker gives has the
 * input's cells and arrays, but is not the input itself, and normals are no active attribute of it;
 * locators added to the picker are not asked, and none is needed. Subclasses of VTK's pickers find
 * the same; a picker of another kind, which asks vtkMapper::GetInput(), gets the input.
 *
 * Needs OpenGL 3.3 with ARB_texture_buffer_object_rgb32; with OpenGL 4.3 faces can choose their
 * patterns on the GPU (see SetSelectionDevice()). Errors (ErrorEvent of this object; the
 * surface is then not drawn, rendering goes on): no recipe, an older OpenGL, depth-tags or texture
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
#include <memory>     // for Internals
#include <string>     // for reasons

class vtkAdaptiveRefinement;
class vtkScalarsToColors;

namespace relevo
{
struct RefinementShaderOptions;
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
   * Whether coarse faces outside the view are left out, on by default. What counts is the frustum
   * of the camera of each pass, and the whole reach of surface and displacement: the picture is the
   * same.
   */
  void SetFrustumCulling(bool culling);
  vtkGetMacro(FrustumCulling, bool);
  vtkBooleanMacro(FrustumCulling, bool);
  //@}

  //@{
  /**
   * Whether coarse faces that face away are left out, on by default, where that cannot be seen: of
   * a closed surface that winds outwards, linear, of PN or Phong triangles, not displaced, drawn as
   * an opaque surface without shaders of the user's, unclipped, also by the near plane, and from
   * outside. Needs FrustumCulling. At most single pixels of the outline differ, where front and
   * back have the same depth.
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
   * METHOD_ARKFPI (0, the default): one instanced draw call for all faces that share a base
   * pattern (Lenz 2009).
   *
   * METHOD_ARK (1): one draw call per face, whose number, permutation and tags the CPU hands over
   * (Boubekeur and Schlick, A Flexible Kernel for Adaptive Mesh Refinement on GPU, 2008). The same
   * vertices in the same order as ARKFPI, and the same picture to the bit. As in the paper no face
   * is culled: there are as many draw calls as coarse faces, and time grows with their number.
   *
   * METHOD_DMR (2): a geometry shader splits triangles once per pass where edges have levels left,
   * and transform feedback hands them to the next pass (Lorenz and Doellner, Dynamic Mesh
   * Refinement on GPU using Geometry Shaders, 2008). An edge is cut at its middle; what joins two
   * middles has the mean of their edges' levels less one, what joins a middle and a corner half of
   * the edge's. A pass makes at most four triangles of one, so level d takes d passes. The refined
   * triangles stay on the GPU, 48 bytes each, until levels or faces in sight change: memory grows
   * with what is drawn, and while it is made with the pass before it, too. Cannot draw whole
   * numbers of segments.
   *
   * METHOD_SUAPT (3), semi-uniform adaptive patches: each face has the uniform pattern of its
   * highest edge, instanced, and the shader moves the vertices on its coarser edges to where these
   * have points (as compared in Lenz 2009). Leaves triangles without area there, which are drawn
   * all the same, and abrupt transitions between fine and coarse.
   *
   * METHOD_HARDWARE_TESSELLATION (4): one patch per face, which the tessellator of OpenGL 4.0 cuts
   * up. Edges have at most 64 segments: level 7 is drawn as level 6. Inside, a face has as many
   * segments as the edge that has most, n, which leaves the best triangles but about 1.5 n^2 of
   * them, also where the other edges have fewer. Whole numbers of segments can be drawn. One draw
   * call; OpenGL on the CPU takes one for each 65535 vertices. A shader of the actor's own
   * (vtkShaderProperty) runs where vertices are made; if it cannot, that is an error and ARKFPI
   * draws until it is another or the method is set again.
   *
   * METHOD_UNIFORM (5): all faces have the uniform pattern of the highest level that any edge of
   * the mesh has, instanced (after Boubekeur and Schlick, Generic Mesh Refinement on GPU, 2005).
   * Nothing is adaptive.
   *
   * Under all of them the same levels of edges give the same points on edges, but for
   * METHOD_UNIFORM, and surfaces without cracks. Only ARKFPI draws what the GPU has selected; the
   * others select on the CPU whatever SetSelectionDevice() says. ARKFPI and ARK can morph
   * (vtkAdaptiveRefinement::SetGeomorphing()), the others draw rounded levels. What DMR and
   * hardware tessellation cannot draw is drawn by ARKFPI: wireframes, points, visible vertices and
   * picking of points. Faces are coloured by the levels or the pattern that their edges ask for;
   * under SUAPT and UNIFORM by those of the uniform pattern. Targets and time budgets
   * (SetTargetNumberOfTriangles()) count ARKFPI's triangles. Where OpenGL lacks something that a
   * method needs, or the method cannot draw such levels, an error says so once and ARKFPI draws.
   *
   * A change uploads no mesh again. A value of no method is an error and changes nothing.
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

  /**
   * The method that the last render used; of a composite data set, that of its last part.
   */
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
   * but statistics when they are asked for. Needs OpenGL 4.3: without, an error says so once and
   * the CPU does it. SELECTION_DEVICE_AUTOMATIC (0, the default): on the GPU where OpenGL has 4.3
   * and is not a program on the CPU itself (llvmpipe, softpipe, swr), which is slower at it.
   *
   * Metrics of the view that are functions of a shader (by distance, by edges on the screen, by the
   * angle of normals, view-dependent) are evaluated on the GPU, too; what others give is uploaded.
   * Levels are the same from both for the same depth-tags. Depth-tags are the same as far as the
   * driver rounds quotients and square roots as IEEE 754 demands; where it does not, an edge whose
   * tag is halfway between two levels may get the other. The order in which the faces of a
   * pattern are drawn is not defined on the GPU. On the GPU all patterns up to MaximumLevel are
   * loaded with the first picture. Another value is an error and changes nothing.
   *
   * Left to the CPU: whole numbers of segments (vtkAdaptiveRefinement::SetSegmentPolicy()), whose
   * tables are too large; budgets in force and faces coloured by the metric, which need the tags.
   */
  void SetSelectionDevice(int device);
  vtkGetMacro(SelectionDevice, int);
  void SetSelectionDeviceToAutomatic() { this->SetSelectionDevice(SELECTION_DEVICE_AUTOMATIC); }
  void SetSelectionDeviceToCPU() { this->SetSelectionDevice(SELECTION_DEVICE_CPU); }
  void SetSelectionDeviceToGPU() { this->SetSelectionDevice(SELECTION_DEVICE_GPU); }
  //@}

  /**
   * What the last render used: SELECTION_DEVICE_CPU or SELECTION_DEVICE_GPU; of a composite data
   * set, the GPU if any of its parts did.
   */
  int GetSelectionDeviceInUse();

  //@{
  /**
   * How many triangles to draw, 0 (the default) for what the recipe says. Otherwise each selection
   * adds to all levels what brings GetNumberOfDrawnTriangles() nearest to the target: within 5 %
   * where that can be had, with culled faces and those over no-data counted. All blocks of a
   * composite input share the target. Levels depend on the view and the target alone, not on
   * earlier frames, so that nothing swings. Where many edges have the same level before they are
   * rounded, as at the ends of a metric's range, their faces change together and the target may
   * be missed from below: have the metric ask for about as much as the target. That goes for edges
   * beside and behind the eye too, as good as endless to vtkScreenEdgeDepthTagMetric;
   * vtkDistanceDepthTagMetric knows none. Selects on the CPU.
   * A negative value is an error and changes nothing.
   */
  void SetTargetNumberOfTriangles(vtkIdType triangles);
  vtkIdType GetTargetNumberOfTriangles();
  //@}

  //@{
  /**
   * Whether a frame may take no longer than the time VTK allots to the actor, on by default:
   * vtkProp::GetAllocatedRenderTime() in seconds, its share of 1 / DesiredUpdateRate of the window,
   * or of its renderer's time where that is less. Interaction styles ask for 15 frames a second
   * while the mouse is down, ParaView likewise, and for as good as none for still pictures; the
   * default of a window is still. Where the latest frames say that a frame would take longer,
   * levels are lowered so that it takes 85 % of the time. They are raised again when there is time
   * for it, with a gap between the two: a still camera settles in a few frames, and then nothing
   * changes. The time is that of drawing this mapper's surface, on the CPU and on the GPU.
   */
  void SetUseAllocatedRenderTime(bool use);
  vtkGetMacro(UseAllocatedRenderTime, bool);
  vtkBooleanMacro(UseAllocatedRenderTime, bool);
  //@}

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
#ifdef __GNUC__ // vtkAdaptiveLICMapper hides it on purpose: g++ 13 and later warn here, clang there
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#endif
  void SetColorMode(int mode) override;
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif
  //@}

  //@{
  /**
   * The colours of levels (mapped from 0, 1, ..., MaximumLevel), of patterns (mapped from
   * vtkRefinementPatternTable::GetPatternIndex(); where edges take any whole number of segments,
   * from that of their places in the sequence 1, 2, ..., 16, 18, 20, ...) or of tags. The table's
   * opacity is not used. By default, and after nullptr, one table that follows the mode, the
   * recipe's MaximumLevel and its segments: viridis, or for patterns colours that tell them apart.
   * Its levels and patterns are annotated, so a vtkScalarBarActor of this table is a legend.
   */
  void SetLevelLookupTable(vtkScalarsToColors* table);
  vtkScalarsToColors* GetLevelLookupTable();
  //@}

  /**
   * Triangles of the surface in the last render, those of culled faces counted. Of ARKFPI and ARK
   * the polygons that vtkAdaptiveRefinementFilter gives for the same recipe and camera; of the
   * other methods what they make of the same levels, those over no-data counted.
   */
  vtkIdType GetNumberOfDrawnTriangles();

  /**
   * Coarse faces that the last render left out because they could not be seen.
   */
  vtkIdType GetNumberOfCulledFaces();

  /**
   * Draw calls of the last render for refined faces. One that draws many patterns indirectly counts
   * as one. With ARK as many as faces are drawn.
   */
  int GetNumberOfDrawCalls();

  /**
   * Base patterns that the levels of the last render ask for: those that ARKFPI and ARK draw.
   */
  int GetNumberOfUsedPatterns();

  /**
   * How often levels have been evaluated since the mapper was made.
   */
  vtkIdType GetNumberOfSelections();

  //@{
  /**
   * How often the coarse mesh has been uploaded, and how often shaders have been written, since the
   * mapper was made. Neither grows with the values that change live: a displacement's scale, offset
   * and direction, and what the surface says of its own.
   */
  vtkIdType GetNumberOfBufferBuilds();
  vtkIdType GetNumberOfShaderBuilds();
  //@}

  /**
   * Seconds the last evaluation of levels took: tag, select and group, without the upload. What the
   * GPU does counts only as long as it takes to hand it over.
   */
  double GetSelectionTime();

  /**
   * Coarse triangles of the input.
   */
  vtkIdType GetNumberOfCoarseFaces();

  /**
   * Bytes on the GPU: coarse buffers (VTK's own included), patterns and height textures.
   */
  virtual vtkTypeInt64 GetGraphicsMemorySize();

  //@{
  /**
   * Of a composite data set that has both, each block is drawn in its own pass.
   */
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

  /// The input, where it is a vtkPolyData.
  vtkPolyData* GetInput();

  using vtkOpenGLPolyDataMapper::MapScalars;
  /**
   * As of any mapper; an array that VTK cannot map (too few tuples; more components than colours
   * have, where they are not mapped) is an error, and there are no colours.
   */
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;

  void RenderPiece(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceStart(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceDraw(vtkRenderer* ren, vtkActor* act) override;
  void RenderPieceFinish(vtkRenderer* ren, vtkActor* act) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* sel, std::vector<unsigned int>& pixeloffsets, vtkProp* prop) override;

protected:
  vtkAdaptiveRefinementMapper();
  ~vtkAdaptiveRefinementMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
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
   * For subclasses that draw the refined faces once more, with a shader of their own:
   * DrawFaces() of what AddFaceHelper() gives, which is this mapper's, draws them, from within
   * RenderPieceDraw() and where IsDrawable(). IsFaceHelper() is true of all that draw refined
   * faces.
   */
  vtkOpenGLHelper* AddFaceHelper();
  bool IsFaceHelper(const vtkOpenGLHelper* helper) const;
  void DrawFaces(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act);
  bool IsDrawable() const;
  //@}

  /**
   * For subclasses that add to the vertex shader of a helper's faces: they fill in
   * options.Extension. Shaders are written anew when it has changed.
   */
  virtual void ExtendShaders(const vtkOpenGLHelper*, relevo::RefinementShaderOptions&);

  /// One pass over the input, all blocks of a composite data set.
  virtual void RenderRefined(vtkRenderer* ren, vtkActor* act);

  //@{
  /**
   * The mappers of a composite input's blocks are of the class of this one. UpdateBlocks() has one
   * for each, with the settings that ShallowCopy() copies; it runs before they draw.
   */
  void UpdateBlocks() override;
  void ForEachBlock(const std::function<void(vtkAdaptiveRefinementMapper*)>& work) const;
  //@}

private:
  vtkAdaptiveRefinementMapper(const vtkAdaptiveRefinementMapper&) = delete;
  void operator=(const vtkAdaptiveRefinementMapper&) = delete;

  struct vtkInternals;
  friend struct vtkInternals;

  bool IsComposite();
  /// Whether a composite input has blocks that are translucent, or such that are not.
  bool HasBlocks(bool translucent);
  vtkAbstractArray* GetScalarsToInterpolate();
  void InitializePicking();
  vtkDataObject* ReplaceInput(vtkDataObject* input);
  vtkPolyData* GetPickedData(bool isAsked);
  bool CheckOpenGL(vtkRenderer* ren);
  void FollowLook(vtkRenderer* ren, vtkActor* act);
  bool UploadMesh(vtkRenderer* ren);
  bool UploadFaces(vtkRenderer* ren, vtkActor* act);
  bool Report(bool valid);
  bool UpdateMesh();
  bool UpdateSelection(vtkRenderer* ren, vtkActor* act);
  void UpdateBudget(vtkRenderer* ren, vtkActor* act);
  bool SelectsOnGPU();
  bool SelectOnGPU(vtkRenderer* ren, vtkActor* act);
  void GiveUpGPU(const std::string& reason);
  void ReadSelection();
  bool HidesBackFaces(vtkRenderer* ren, vtkActor* act);
  void ChooseMethod(vtkRenderer* ren, vtkActor* act);
  bool BuildStages(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act);
  void GiveUpMethod(vtkRenderer* ren, vtkActor* act);
  void SetRefinementColorMode(RefinementColorModes mode);
  bool UpdateFaceColors(vtkRenderer* ren);
  void UpdateRefiningShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act);

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
