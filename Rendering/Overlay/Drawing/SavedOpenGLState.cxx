// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SavedOpenGLState.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"

namespace relevo
{
SavedOpenGLState::SavedOpenGLState(vtkOpenGLRenderWindow* window)
  : Window(window)
  , State(window->GetState())
  , Blend(this->State, GL_BLEND)
  , CullFace(this->State, GL_CULL_FACE)
  , DepthTest(this->State, GL_DEPTH_TEST)
  , ScissorTest(this->State, GL_SCISSOR_TEST)
  , StencilTest(this->State, GL_STENCIL_TEST)
  , DepthMask(this->State)
  , ColorMask(this->State)
  , Scissor(this->State)
  , Viewport(this->State)
  , BlendFunction(this->State)
  , ActiveTexture(this->State)
{
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->BlendEquations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->BlendEquations[1]);
  glGetIntegerv(GL_POLYGON_MODE, this->PolygonModes);
  glGetIntegerv(GL_CURRENT_PROGRAM, &this->Program);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &this->VertexArray);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &this->ArrayBuffer);
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &this->UnpackAlignment);
  this->State->vtkglActiveTexture(GL_TEXTURE0);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &this->Texture);
  glGetIntegerv(GL_SAMPLER_BINDING, &this->Sampler);
}

//------------------------------------------------------------------------------
SavedOpenGLState::~SavedOpenGLState()
{
  this->State->vtkglActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, this->Texture);
  glBindSampler(0, this->Sampler);
  this->State->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, this->UnpackAlignment);
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->ArrayBuffer);
  glPolygonMode(GL_FRONT_AND_BACK, this->PolygonModes[0]);
  this->State->vtkglBlendEquationSeparate(this->BlendEquations[0], this->BlendEquations[1]);
  // The cache must not assume that its last program is current.
  this->Window->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(this->Program);
}
}
