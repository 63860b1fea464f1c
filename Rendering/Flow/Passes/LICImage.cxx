// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/LICImage.h"

#include "OpenGL/RelevoOpenGL.h"
#include "Passes/LICPass.h"
#include "Passes/LICScreen.h"
#include "relevoLIC.h"
#include "relevoLICBlendFS.h"
#include "relevoLICColor.h"
#include "relevoLICConvolveFS.h"
#include "relevoLICFilterFS.h"
#include "relevoLICFilters.h"
#include "relevoLICImageFS.h"
#include "relevoLICKernel.h"
#include "relevoLICRangeFS.h"
#include "relevoLICStretch.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relevo
{
namespace
{
constexpr int ReductionSize = 16; // as in relevoLICRangeFS.glsl

constexpr const char* ShaderError =
  "The shaders of the LIC could not be built; OpenGL's own message gives the reason.";

void SetSize(vtkShaderProgram* program, const char* name, int width, int height)
{
  const int size[2] = { width, height };
  program->SetUniform2i(name, size);
}
}

void LICColoring::SetUniforms(vtkShaderProgram* program) const
{
  const auto setFloat = [program](const char* name, double value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformf(name, static_cast<float>(value));
    }
  };
  if (program->IsUniformUsed("relevoLICColorMode"))
  {
    program->SetUniformi("relevoLICColorMode", this->Mode);
  }
  setFloat("relevoLICIntensity", this->Intensity);
  setFloat("relevoLICBias", this->Bias);
}

struct LICImage::Work
{
  Work(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer, LICScreen& screen,
    const RangeMerger& merge)
    : Window(window)
    , Framebuffer(framebuffer)
    , Screen(screen)
    , Merge(merge)
  {
    vtkOpenGLState* state = window->GetState();
    for (unsigned int capability : { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE })
    {
      state->vtkglDisable(capability);
    }
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }

  // Begin a pass over the viewport; return nullptr if its program cannot be built.
  vtkShaderProgram* Begin(LICPass& pass)
  {
    vtkShaderProgram* program = pass.Begin(this->Window);
    if (program)
    {
      SetSize(program, "size", this->Screen.Viewport[2], this->Screen.Viewport[3]);
    }
    return program;
  }

  vtkOpenGLRenderWindow* Window;
  vtkOpenGLFramebufferObject* Framebuffer;
  LICScreen& Screen;
  const RangeMerger& Merge;
};

LICImage::LICImage()
{
  const std::string image = relevoLICImageFS;
  const std::string reduce = relevoLICRangeFS;
  const std::string color = std::string(relevoLICColor) + relevoLICBlendFS;
  this->ConvolvePass.reset(
    new LICPass(std::string(relevoLICConvolveFS) + relevoLICKernel + relevoLIC + R"(
vec4 relevoConvolve()
{
  vec2 p = gl_FragCoord.xy;
  float mark = texelFetch(vectors, ivec2(p), 0).w;
  LICKernel kernel = LICKernel(steps, stepSize, normalized, oriented, phase);
  float value = mark <= 0.0 ? licNoise(p)
                            : licRestoreContrast(licConvolve(p, kernel), noiseMean, kernel);
  return vec4(value, mark, 0.0, 0.0);
}
)",
      "relevoConvolve()"));
  const char* filters[NumberOfFilters] = { "licHighPass(pixel)", "licSmooth(pixel, direction)",
    "licStretch(licValue(pixel), texelFetch(range, ivec2(0), 0).xy, factors)" };
  for (int i = 0; i < NumberOfFilters; ++i)
  {
    this->FilterPasses[i].reset(
      new LICPass(image + relevoLICFilterFS + relevoLICFilters + relevoLICStretch + R"(
vec4 relevoFilter()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 texel = texelFetch(image, pixel, 0);
  texel.r = texel.g <= 0.0 ? texel.r : )" +
          filters[i] + R"(;
  return texel;
}
)",
        "relevoFilter()"));
  }
  this->RangePass.reset(new LICPass(image + reduce + color, "relevoReduce()"));
  this->ColorRangePass.reset(
    new LICPass("#define RELEVO_COLORS\n" + image + reduce + color, "relevoReduce()"));
  this->ReducePass.reset(new LICPass("uniform sampler2D ranges;\n" + reduce +
      "vec2 relevoRange(ivec2 texel)\n{\n  return texelFetch(ranges, texel, 0).xy;\n}\n",
    "relevoReduce()"));
}

LICImage::~LICImage() = default;

const char* LICImage::GetTextureError()
{
  return "OpenGL cannot create or draw to floating-point textures of the viewport's size.";
}

bool LICImage::Convolve(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
  LICScreen& screen, vtkTextureObject* noise, const LICPassSettings& settings,
  const RangeMerger& merge)
{
  if (!this->Spare || this->Spare->GetContext() != window ||
    this->Spare->GetWidth() != screen.Image->GetWidth() ||
    this->Spare->GetHeight() != screen.Image->GetHeight())
  {
    this->Spare.TakeReference(
      NewFloatTexture(window, screen.Viewport[2], screen.Viewport[3], 2, false));
    if (!this->Spare)
    {
      this->Error = GetTextureError();
      return false;
    }
  }
  Work work(window, framebuffer, screen, merge);
  const LICKernel& kernel = settings.Kernel;
  const auto stretch = [&](vec2 factors)
  { return !settings.Stretched || this->ApplyFilter(work, CONTRAST, ivec2(0), factors); };
  bool done = this->ApplyConvolution(work, kernel, settings.NoiseMean, noise, true);
  if (settings.Enhanced)
  {
    done = done && stretch(vec2(0.0f)) && this->ApplyFilter(work, HIGH_PASS) &&
      this->ApplyConvolution(
        work, licSecondKernel(kernel), settings.NoiseMean, screen.Image, false);
  }
  for (int i = 0; i < settings.NumberOfSmoothings; ++i)
  {
    done = done && this->ApplyFilter(work, SMOOTH, ivec2(1, 0)) &&
      this->ApplyFilter(work, SMOOTH, ivec2(0, 1));
  }
  return done && stretch(settings.StretchFactors);
}

int LICImage::CountRanges(const LICPassSettings& settings)
{
  return settings.Stretched ? (settings.Enhanced ? 2 : 1) : 0;
}

int LICImage::FindReach(const LICPassSettings& settings)
{
  // Vectors have at most length 1. One more pixel is needed for sharpening, and one for
  // interpolation.
  const LICKernel second = licSecondKernel(settings.Kernel);
  const double length = std::min(1.0 * second.Steps * second.StepSize, 1e6);
  return settings.NumberOfSmoothings +
    (settings.Enhanced ? static_cast<int>(std::ceil(length)) + 2 : 0);
}

bool LICImage::ApplyConvolution(
  Work& work, const LICKernel& kernel, float noiseMean, vtkTextureObject* noise, bool isTiled)
{
  vtkShaderProgram* program = work.Begin(*this->ConvolvePass);
  if (!program)
  {
    this->Error = ShaderError;
    return false;
  }
  LICPass::Read(program, "vectors", work.Screen.Vectors);
  LICPass::Read(program, "noise", noise);
  SetSize(program, "noiseSize", static_cast<int>(noise->GetWidth()),
    static_cast<int>(noise->GetHeight()));
  program->SetUniformi("noiseIsTiled", isTiled);
  program->SetUniform2i("noiseOrigin", work.Screen.PartOrigin);
  program->SetUniformi("steps", kernel.Steps);
  program->SetUniformf("stepSize", kernel.StepSize);
  program->SetUniformi("normalized", kernel.Normalized);
  program->SetUniformi("oriented", kernel.Oriented);
  program->SetUniformf("phase", kernel.Phase);
  program->SetUniformf("noiseMean", noiseMean);
  this->ConvolvePass->Draw(work.Framebuffer, this->Spare, work.Screen.Convolved);
  noise->Deactivate();
  work.Screen.Vectors->Deactivate();
  std::swap(work.Screen.Image, this->Spare);
  return true;
}

bool LICImage::ApplyFilter(Work& work, Filter filter, ivec2 direction, vec2 factors)
{
  vtkSmartPointer<vtkTextureObject> range;
  if (filter == CONTRAST)
  {
    range = this->FindRange(work, *this->RangePass, nullptr);
    if (!range)
    {
      return false;
    }
  }
  LICPass& pass = *this->FilterPasses[filter];
  vtkShaderProgram* program = work.Begin(pass);
  if (!program)
  {
    this->Error = ShaderError;
    return false;
  }
  LICPass::Read(program, "image", work.Screen.Image);
  if (range)
  {
    LICPass::Read(program, "range", range);
    program->SetUniform2f("factors", &factors.x);
  }
  if (filter == SMOOTH)
  {
    program->SetUniform2i("direction", &direction.x);
  }
  pass.Draw(work.Framebuffer, this->Spare, work.Screen.Convolved);
  work.Screen.Image->Deactivate();
  if (range)
  {
    range->Deactivate();
  }
  std::swap(work.Screen.Image, this->Spare);
  return true;
}

vtkSmartPointer<vtkTextureObject> LICImage::FindRange(
  Work& work, LICPass& first, const LICColoring* coloring)
{
  vtkSmartPointer<vtkTextureObject> source;
  const int* rectangle = work.Screen.Rectangle;
  int width = work.Screen.Viewport[2];
  int height = work.Screen.Viewport[3];
  do
  {
    LICPass& pass = source ? *this->ReducePass : first;
    vtkShaderProgram* program = source ? pass.Begin(work.Window) : work.Begin(pass);
    const int smallerWidth = (width + ReductionSize - 1) / ReductionSize;
    const int smallerHeight = (height + ReductionSize - 1) / ReductionSize;
    auto target =
      vtk::TakeSmartPointer(NewFloatTexture(work.Window, smallerWidth, smallerHeight, 2, false));
    if (!program || !target)
    {
      this->Error = target ? ShaderError : GetTextureError();
      return nullptr;
    }
    const int left = source ? 0 : rectangle[0];
    const int bottom = source ? 0 : rectangle[1];
    SetSize(program, "sourceFirst", left, bottom);
    SetSize(program, "sourceEnd", source ? width : left + rectangle[2],
      source ? height : bottom + rectangle[3]);
    if (source)
    {
      LICPass::Read(program, "ranges", source);
    }
    else
    {
      LICPass::Read(program, "image", work.Screen.Image);
      if (coloring)
      {
        LICPass::Read(program, "colors", work.Screen.Colors);
        coloring->SetUniforms(program);
      }
    }
    pass.Draw(work.Framebuffer, target);
    if (source)
    {
      source->Deactivate();
    }
    else
    {
      work.Screen.Image->Deactivate();
      if (coloring)
      {
        work.Screen.Colors->Deactivate();
      }
    }
    source = target;
    width = smallerWidth;
    height = smallerHeight;
  } while (width > 1 || height > 1);
  if (work.Merge)
  {
    float range[2];
    work.Framebuffer->ActivateReadBuffer(0);
    glReadPixels(0, 0, 1, 1, GL_RG, GL_FLOAT, range);
    work.Framebuffer->DeactivateReadBuffer();
    work.Merge(range);
    source->Activate();
    glTexSubImage2D(source->GetTarget(), 0, 0, 0, 1, 1, GL_RG, GL_FLOAT, range);
    source->Deactivate();
  }
  return source;
}

bool LICImage::FindColorRange(vtkOpenGLRenderWindow* window,
  vtkOpenGLFramebufferObject* framebuffer, LICScreen& screen, const LICColoring& coloring,
  const RangeMerger& merge)
{
  Work work(window, framebuffer, screen, merge);
  screen.Range = this->FindRange(work, *this->ColorRangePass, &coloring);
  return screen.Range != nullptr;
}

void LICImage::ReleaseGraphicsResources(vtkWindow* window)
{
  for (LICPass* pass : { this->ConvolvePass.get(), this->FilterPasses[HIGH_PASS].get(),
         this->FilterPasses[SMOOTH].get(), this->FilterPasses[CONTRAST].get(),
         this->RangePass.get(), this->ColorRangePass.get(), this->ReducePass.get() })
  {
    pass->ReleaseGraphicsResources();
  }
  if (this->Spare)
  {
    this->Spare->ReleaseGraphicsResources(window);
    this->Spare = nullptr;
  }
}

vtkTypeInt64 LICImage::GetMemorySize() const
{
  return this->Spare
    ? static_cast<vtkTypeInt64>(this->Spare->GetWidth()) * this->Spare->GetHeight() * 8
    : 0;
}
}
