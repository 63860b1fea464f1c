// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ReliefPainter
 * @brief   draws one relief as VTK's mapper draws a polydata
 *
 * Lights, clipping planes, opacity, render passes and selections are VTK's: its shaders get a point
 * of the relief's surface instead of a fragment of the mesh. Private to the module.
 */
#ifndef ReliefPainter_h
#define ReliefPainter_h

#include "Buffers/ReliefPatterns.h"
#include "Buffers/ReliefTextures.h"
#include "Buffers/ReliefTiles.h"
#include "Buffers/WarpedTextures.h"
#include "Changes/Dependencies.h"
#include "Shaders/ReliefShader.h"
#include "Shaders/VariantPainter.h"

#include <string>

namespace relevo
{
class Relief;
class ReliefView;

class ReliefPainter : public VariantPainter
{
public:
  static ReliefPainter* New();
  vtkTypeMacro(ReliefPainter, VariantPainter);

  /// The settings of the mapper.
  struct Settings
  {
    ReliefShaderOptions::Methods Method = ReliefShaderOptions::RAY_MARCH;
    int Search = ReliefShaderOptions::MAXIMUM_MIPMAP;
    bool IsLit = false;
    bool IsShadowed = false;
    bool Yields = false;
    bool IsRim = false; // whether the relief is of MakeReliefRims()
  };

  /// Set a relief, and compute everything that does not need OpenGL.
  void SetRelief(const Relief& relief, double maximumStretch);
  /// Return the error of the shaders that were built last, or "".

  const double* GetSurfaceBounds() const { return this->SurfaceBounds; }
  bool IsTranslucent() const { return this->Tiles.IsTranslucent(); }
  /// Return the number of triangles that REFINEMENT draws for the whole surface if texels are at
  /// least as large as pixels. It is infinite if the surface is open, because rays find its
  /// silhouettes more exactly.
  double GetNumberOfTriangles() const { return this->NumberOfTriangles; }

  /// Upload the textures of the relief, before RenderPiece(). Return the error, or "".
  std::string Prepare(vtkRenderer* renderer, vtkActor* actor, const Settings& settings);
  /// Return the method that draws, after RenderPiece(). It is not WARP if the camera does not see
  /// the plane.
  ReliefShaderOptions::Methods GetMethod() const { return this->Current.Method; }

  /// Report the largest ids that a selection draws.
  void AnnounceIds(vtkHardwareSelector* selector) const;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  vtkTypeInt64 GetMemorySize() const
  {
    return this->Textures.GetMemorySize() + this->Patterns.GetMemorySize() +
      this->Warped.GetMemorySize();
  }
  /// How often data have been uploaded and shaders built.
  struct Counts
  {
    vtkIdType BufferBuilds = 0;
    vtkIdType ShaderBuilds = 0;
    vtkIdType Warps = 0;

    void operator+=(const Counts& other);
  };
  Counts GetCounts() const;

protected:
  ReliefPainter();
  ~ReliefPainter() override;

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void PrepareShaders(ShaderVariants::Shaders& shaders, vtkActor* actor) override;
  void FinishShaders(ShaderVariants::Shaders& shaders) override;
  bool IsLit() const override;
  void ReplaceShaderClip(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;

private:
  ReliefPainter(const ReliefPainter&) = delete;
  void operator=(const ReliefPainter&) = delete;

  ReliefView MakeView(vtkRenderer* renderer, vtkActor* actor);
  ReliefShaderOptions GetOptions();
  bool IsMarching() const { return this->Current.Method == ReliefShaderOptions::RAY_MARCH; }
  vtkOpenGLHelper& GetHelper() { return this->Variants.GetHelper(this->Current.Method); }
  void DrawBoxes();
  void DrawMethod(vtkRenderer* renderer, vtkActor* actor);
  void SetOwnUniforms(vtkRenderer* renderer, vtkActor* actor);

  Settings Current;
  ReliefTiles Tiles;
  ivec2 Size = ivec2(0);
  double SurfaceBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double NumberOfTriangles = 0.0;
  ReliefTextures Textures;
  bool NeedsUpload = false;
  ReliefPatterns Patterns;
  WarpedTextures Warped;
  double Plane = 0.0;     // the relief's plane, in coordinates of the tiles
  int NumberOfLayers = 1; // drawn per tile, at most
  vtkIdType NumberOfBufferBuilds = 0;
};
}

#endif
