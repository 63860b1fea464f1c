// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PanelPainter.h"

#include "Drawing/SavedOpenGLState.h"
#include "OpenGL/RelevoOpenGL.h"
#include "relevoOverlayFS.h"
#include "relevoOverlayVS.h"

#include <imgui.h>

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace relevo
{
//------------------------------------------------------------------------------
PixelRectangle FindRectangle(ImDrawData* panels, const int size[2])
{
  float low[2] = { static_cast<float>(size[0]), static_cast<float>(size[1]) };
  float high[2] = { 0.0f, 0.0f };
  for (int i = 0; i < panels->CmdListsCount; ++i)
  {
    for (const ImDrawVert& vertex : panels->CmdLists[i]->VtxBuffer)
    {
      const float position[2] = { vertex.pos.x, size[1] - vertex.pos.y };
      for (int k = 0; k < 2; ++k)
      {
        low[k] = std::min(low[k], std::max(position[k], 0.0f));
        high[k] = std::max(high[k], std::min(position[k], static_cast<float>(size[k])));
      }
    }
  }
  return { { static_cast<int>(std::floor(low[0])), static_cast<int>(std::floor(low[1])),
    static_cast<int>(std::ceil(high[0])), static_cast<int>(std::ceil(high[1])) } };
}

struct PanelPainter::Tile
{
  double Scale[2];  // pixels of the picture per pixel of the window
  double Origin[2]; // lower left corner of the tile in the picture, in pixels
  double Height;    // of the picture
  int Size[2];      // of the tile

  explicit Tile(vtkOpenGLRenderWindow* window)
  {
    const int* size = window->GetActualSize();
    const int* scale = window->GetTileScale();
    const double* viewport = window->GetTileViewport();
    for (int i = 0; i < 2; ++i)
    {
      this->Size[i] = size[i];
      this->Scale[i] = scale[i];
      this->Origin[i] = std::round(viewport[i] * scale[i] * size[i]);
    }
    this->Height = static_cast<double>(scale[1]) * size[1];
  }

  /// Pixels from the left and from the bottom of the tile.
  double ToX(double x) const { return x * this->Scale[0] - this->Origin[0]; }
  double ToY(double y) const { return this->Height - y * this->Scale[1] - this->Origin[1]; }
};

//------------------------------------------------------------------------------
PanelPainter::PanelPainter() = default;

//------------------------------------------------------------------------------
PanelPainter::~PanelPainter() = default;

//------------------------------------------------------------------------------
void PanelPainter::UploadFont(vtkOpenGLRenderWindow* window, int version)
{
  this->Atlas->SetContext(window);
  if (this->Atlas->GetHandle() != 0 && this->AtlasVersion == version)
  {
    return;
  }
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImFontAtlas* fonts = ImGui::GetIO().Fonts;
  fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  this->Atlas->ReleaseGraphicsResources(window);
  this->Atlas->SetContext(window);
  this->Atlas->SetMinificationFilter(vtkTextureObject::Linear);
  this->Atlas->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Atlas->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
    4, VTK_UNSIGNED_CHAR, pixels);
  this->AtlasVersion = version;
#if IMGUI_VERSION_NUM >= 19200
  // Draw commands look it up. In earlier versions, they have a copy, which is 0 here.
  fonts->SetTexID(static_cast<ImTextureID>(this->Atlas->GetHandle()));
#endif
}

//------------------------------------------------------------------------------
void PanelPainter::SetState(vtkOpenGLRenderWindow* window, const Tile& tile)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglViewport(0, 0, tile.Size[0], tile.Size[1]);
  state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglActiveTexture(GL_TEXTURE0);
  glBindSampler(0, 0);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  window->GetShaderCache()->ReadyShaderProgram(this->Program);
  this->VertexArray->Bind();
  this->Indices->Bind();
}

//------------------------------------------------------------------------------
bool PanelPainter::Draw(vtkOpenGLRenderWindow* window, ImDrawData* panels, int fontVersion)
{
  const SavedOpenGLState saved(window);
  this->Program =
    window->GetShaderCache()->ReadyShaderProgram(relevoOverlayVS, relevoOverlayFS, "");
  if (!this->Program)
  {
    return false;
  }
  this->UploadFont(window, fontVersion);
  const Tile tile(window);
  const float scale[2] = { static_cast<float>(2.0 * tile.Scale[0] / tile.Size[0]),
    static_cast<float>(-2.0 * tile.Scale[1] / tile.Size[1]) };
  const float offset[2] = { static_cast<float>(2.0 * tile.ToX(0.0) / tile.Size[0] - 1.0),
    static_cast<float>(2.0 * tile.ToY(0.0) / tile.Size[1] - 1.0) };
  this->Program->SetUniform2f("pixelScale", scale);
  this->Program->SetUniform2f("pixelOffset", offset);
  this->Program->SetUniformi("atlas", 0);
  for (int i = 0; i < panels->CmdListsCount; ++i)
  {
    this->DrawList(window, panels->CmdLists[i], tile);
  }
  this->VertexArray->Release();
  return true;
}

//------------------------------------------------------------------------------
void PanelPainter::DrawList(vtkOpenGLRenderWindow* window, const ImDrawList* list, const Tile& tile)
{
  if (list->VtxBuffer.Size == 0 || list->IdxBuffer.Size == 0)
  {
    return;
  }
  this->VertexArray->Bind();
  this->Vertices->Upload(list->VtxBuffer.Data, static_cast<size_t>(list->VtxBuffer.Size),
    vtkOpenGLBufferObject::ArrayBuffer);
  this->Indices->Upload(list->IdxBuffer.Data, static_cast<size_t>(list->IdxBuffer.Size),
    vtkOpenGLBufferObject::ElementArrayBuffer);
  const struct
  {
    const char* Name;
    size_t Offset;
    int Type;
    int Components;
    bool IsNormalized;
  } attributes[] = { { "position", offsetof(ImDrawVert, pos), VTK_FLOAT, 2, false },
    { "texel", offsetof(ImDrawVert, uv), VTK_FLOAT, 2, false },
    { "color", offsetof(ImDrawVert, col), VTK_UNSIGNED_CHAR, 4, true } };
  for (const auto& attribute : attributes)
  {
    this->VertexArray->AddAttributeArray(this->Program, this->Vertices, attribute.Name,
      static_cast<int>(attribute.Offset), sizeof(ImDrawVert), attribute.Type, attribute.Components,
      attribute.IsNormalized);
  }
  this->SetState(window, tile);
  for (const ImDrawCmd& command : list->CmdBuffer)
  {
    if (command.UserCallback == ImDrawCallback_ResetRenderState)
    {
      this->SetState(window, tile);
      continue;
    }
    if (command.UserCallback)
    {
      command.UserCallback(list, &command);
      this->SetState(window, tile);
      continue;
    }
    const int left = static_cast<int>(std::floor(tile.ToX(command.ClipRect.x)));
    const int right = static_cast<int>(std::ceil(tile.ToX(command.ClipRect.z)));
    const int bottom = static_cast<int>(std::floor(tile.ToY(command.ClipRect.w)));
    const int top = static_cast<int>(std::ceil(tile.ToY(command.ClipRect.y)));
    if (right <= 0 || top <= 0 || left >= tile.Size[0] || bottom >= tile.Size[1] || right <= left ||
      top <= bottom)
    {
      continue;
    }
    window->GetState()->vtkglScissor(
      std::max(left, 0), std::max(bottom, 0), right - std::max(left, 0), top - std::max(bottom, 0));
    // 0 is the font's atlas, other numbers are OpenGL textures of the program.
    const auto texture = static_cast<GLuint>((std::intptr_t)command.GetTexID());
    glBindTexture(GL_TEXTURE_2D, texture != 0 ? texture : this->Atlas->GetHandle());
    const size_t first = sizeof(ImDrawIdx) * command.IdxOffset;
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
      sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(first), static_cast<GLint>(command.VtxOffset));
  }
}

//------------------------------------------------------------------------------
void PanelPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Atlas->ReleaseGraphicsResources(window);
  this->VertexArray->ReleaseGraphicsResources();
  this->Vertices->ReleaseGraphicsResources();
  this->Indices->ReleaseGraphicsResources();
  this->AtlasVersion = 0;
}
}
