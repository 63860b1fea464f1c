// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TerrainPainter
 * @brief   draws the faces of a bisected terrain as VTK's mapper draws a polydata
 *
 * Lights, clipping planes, opacity, render passes and selections are VTK's: its shaders get a
 * vertex of a face instead of a vertex of the mesh. Positions are relative to a sample near the
 * eye. Private to the module.
 */
#ifndef TerrainPainter_h
#define TerrainPainter_h

#include "Bisection/TerrainView.h"
#include "Buffers/ColorTable.h"
#include "Buffers/GlobeVertices.h"
#include "Buffers/TerrainBorder.h"
#include "Buffers/TerrainInstances.h"
#include "Buffers/TerrainPatterns.h"
#include "Changes/Dependencies.h"
#include "Shaders/TerrainShader.h"
#include "Shaders/VariantPainter.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class vtkHardwareSelector;
class vtkScalarsToColors;

namespace relevo
{
class TerrainViewpoint;

class TerrainPainter : public VariantPainter
{
public:
  static TerrainPainter* New();
  vtkTypeMacro(TerrainPainter, VariantPainter);

  /// The settings for drawing.
  struct Settings
  {
    TerrainPlacement Placement;
    /// The vertices of the faces, if the placement has a globe.
    const std::vector<const GlobeFaces::Vertices*>* Vertices = nullptr;
    std::uint64_t NumberOfComputedFaces = 0;      // see GlobeFaces
    std::array<int, 2> Dimensions = { { 0, 0 } }; // columns and rows of the raster
    double Exaggeration = 1.0;                    // is part of the placement's scale of heights
    std::optional<double> Base;                   // the height of the bottom of a solid
    TerrainColoring Coloring = TerrainColoring::SOLID;
    vtkScalarsToColors* Table = nullptr; // required if HasTable(Coloring)
    double ContourInterval = 0.0;        // in units of the heights; 0 for none
    double ContourWidth = 1.0;           // in pixels
    std::array<double, 3> ContourColor = { { 0.0, 0.0, 0.0 } };
    vtkTypeInt64 MemoryLimit = vtkTypeInt64(1) << 28; // bytes of textures of tiles
  };

  /// Upload the faces of a view and the tiles for shading, before RenderPiece(). Return the error,
  /// or "".
  std::string Prepare(vtkRenderer* renderer, vtkActor* actor, const std::vector<TerrainFace>& faces,
    const std::vector<MipmapTiles::Item>& shading, const Settings& settings);
  /// Return the error of the colours, or "", after RenderPiece().
  const std::string& GetColorError() const { return this->ColorError; }

  /// Return the number of tiles that fit into textures, in the current context.
  int GetMaximumNumberOfTiles(vtkTypeInt64 memoryLimit);

  /// Forget all heights and positions, because they have changed.
  void ForgetTiles()
  {
    this->Instances.ForgetTiles();
    this->Globe.Clear();
    this->Border.Clear();
  }

  /// Report the largest ids that a selection draws.
  void AnnounceIds(vtkHardwareSelector* selector) const;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  int GetNumberOfDrawCalls() const { return this->NumberOfDrawCalls; }
  vtkTypeInt64 GetMemorySize() const;
  vtkIdType GetNumberOfShaderBuilds() const { return this->Variants.GetNumberOfBuilds(); }
  vtkIdType GetNumberOfTileUploads() const { return this->Instances.GetNumberOfTileUploads(); }

protected:
  TerrainPainter();
  ~TerrainPainter() override;

  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void PrepareShaders(ShaderVariants::Shaders& shaders, vtkActor* actor) override;
  void FinishShaders(ShaderVariants::Shaders& shaders) override;
  bool IsLit() const override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;

private:
  TerrainPainter(const TerrainPainter&) = delete;
  void operator=(const TerrainPainter&) = delete;

  void ChooseOrigin(const TerrainViewpoint& viewpoint, const std::vector<TerrainFace>& faces);
  void ChooseGlobeOrigin(const std::vector<TerrainFace>& faces, const std::array<double, 3>& near,
    const float heights[2]);
  void SetOrigin(const std::array<double, 3>& origin);
  void UpdateColors(vtkOpenGLRenderWindow* window);
  void SetPositionUniforms(vtkShaderProgram* program, bool isTranslucent);
  void SetColorUniforms(vtkShaderProgram* program);
  void FindKinds(const TerrainViewpoint& viewpoint, const std::vector<TerrainFace>& faces);
  void UpdateBorder(const std::vector<TerrainFace>& faces);
  std::string UploadBorder(vtkOpenGLRenderWindow* window, vtkActor* actor);
  // The programs, each of which draws a part.
  enum Program
  {
    LARGE_TRIANGLES,
    SMALL_TRIANGLES,
    BOTTOM,
    BORDER,
    NUMBER_OF_PROGRAMS
  };
  bool IsEmpty(Program part) const;
  bool DrawPart(vtkRenderer* renderer, vtkActor* actor, Program part);
  void DrawGroups(TerrainPatterns::Primitives primitives, Program part);
  void DrawGroup(TerrainPatterns::Primitives primitives, const TerrainInstances::Group& group,
    bool isMirrored, Program part);

  Settings Current;
  TerrainInstances Instances;
  GlobeVertices Globe;
  TerrainPatterns Patterns;
  ColorTable Table;
  Dependencies TableSource;
  std::string ColorError;
  std::array<int, 2> OriginSample = { { 0, 0 } };
  float OriginHeight = 0.0f;

  std::array<double, 2> HalfViewport = { { 0.0, 0.0 } };
  std::vector<TerrainInstances::Kind> Kinds; // by face
  TerrainBorder Border;
  std::vector<unsigned int> BorderNumbers;
  BufferTexture BorderTexture;

  TerrainShaderOptions Options;
  int NumberOfDrawCalls = 0;
};
}

#endif
