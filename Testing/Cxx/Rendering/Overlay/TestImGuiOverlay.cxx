// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkImGuiOverlay draws panels, and changes neither other pixels and depths nor OpenGL's state.
#include "OpenGL/RelevoOpenGL.h"
#include "OverlayStage.h"
#include "RelevoPictures.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <limits>
#include <vector>

namespace
{
// The state that panels need, and that VTK or other props rely on.
std::vector<GLint> ReadState()
{
  const GLenum names[] = { GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST,
    GL_DEPTH_WRITEMASK, GL_COLOR_WRITEMASK, GL_SCISSOR_BOX, GL_VIEWPORT, GL_BLEND_SRC_RGB,
    GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB,
    GL_BLEND_EQUATION_ALPHA, GL_POLYGON_MODE, GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING,
    GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_ACTIVE_TEXTURE,
    GL_TEXTURE_BINDING_2D, GL_SAMPLER_BINDING, GL_UNPACK_ALIGNMENT, GL_DRAW_FRAMEBUFFER_BINDING,
    GL_READ_FRAMEBUFFER_BINDING, GL_DRAW_BUFFER, GL_READ_BUFFER };
  std::vector<GLint> state;
  for (const GLenum name : names)
  {
    GLint values[4] = { 0, 0, 0, 0 };
    glGetIntegerv(name, values);
    state.insert(state.end(), values, values + 4);
  }
  return state;
}

class StateReader
{
public:
  explicit StateReader(vtkRenderer* renderer)
  {
    renderer->AddObserver(vtkCommand::EndEvent, this, &StateReader::OnEnd);
  }
  std::vector<GLint> State;
  GLenum Error = GL_NO_ERROR;

private:
  void OnEnd()
  {
    this->Error = glGetError();
    this->State = ReadState();
  }
};

// Borders are smoothed, by at most a pixel.
bool IsInPanel(int x, int y)
{
  return x >= 9 && x < 141 && y >= 9 && y < 101;
}

void TestPixels(RelevoCheck& check, int multiSamples)
{
  CHECK_CASE(multiSamples);
  OverlayStage stage(multiSamples);
  StateReader reader(stage.Overlay->GetRenderer());
  stage.HasPanel = false;
  stage.Window->Render();
  stage.Window->Render(); // the first frame starts with other states
  const RelevoPicture before(stage.Window);
  const std::vector<GLint> state = reader.State;
  CHECK_EQUAL(stage.Overlay->GetNumberOfFrames(), 0);

  // The first frame shows the complete panel.
  stage.HasPanel = true;
  stage.Window->Render();
  const RelevoPicture after(stage.Window);
  CHECK_EQUAL(reader.Error, static_cast<GLenum>(GL_NO_ERROR));
  CHECK_EQUAL(reader.State, state);
  CHECK_EQUAL(stage.Overlay->GetNumberOfFrames(), 1);
  size_t outside = 0;
  size_t inside = 0;
  size_t depths = 0;
  for (int y = 0; y < OverlayStage::Height; ++y)
  {
    for (int x = 0; x < OverlayStage::Width; ++x)
    {
      const size_t i = static_cast<size_t>(OverlayStage::Height - 1 - y) * OverlayStage::Width + x;
      bool differs = false;
      for (size_t k = 3 * i; k < 3 * i + 3; ++k)
      {
        differs = differs || before.Colors[k] != after.Colors[k];
      }
      (IsInPanel(x, y) ? inside : outside) += differs;
      depths += before.Depths[i] != after.Depths[i];
    }
  }
  CHECK_EQUAL(outside, 0u);
  CHECK_GREATER(inside, 130u * 90u * 9u / 10u);
  CHECK_EQUAL(depths, 0u);

  // The next frame without changes is the same.
  stage.Window->Render();
  CHECK(RelevoPictures::Equal(RelevoPicture(stage.Window), after));

  // Without the panel, the picture is as before.
  stage.Overlay->VisibilityOff();
  stage.Window->Render();
  CHECK(RelevoPictures::Equal(RelevoPicture(stage.Window), before));
  stage.Overlay->VisibilityOn();
  stage.Overlay->SetRenderWindow(nullptr);
  stage.Window->Render();
  CHECK(RelevoPictures::Equal(RelevoPicture(stage.Window), before));
}

// A magnified picture, which is drawn in tiles, shows magnified panels.
void TestMagnified(RelevoCheck& check)
{
  OverlayStage stage;
  stage.Window->Render();
  const RelevoPicture small(stage.Window);
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(stage.Window);
  filter->SetScale(3);
  filter->SetInputBufferTypeToRGB();
  filter->Update();
  vtkDataArray* colors = filter->GetOutput()->GetPointData()->GetScalars();
  int size[3];
  filter->GetOutput()->GetDimensions(size);
  CHECK_EQUAL(size[0], 3 * OverlayStage::Width);
  // Text and edges are smoothed, the rest of the panel is uniform.
  size_t number = 0;
  size_t equal = 0;
  for (int y = 12; y < 98; ++y)
  {
    for (int x = 12; x < 138; ++x)
    {
      const int row = OverlayStage::Height - 1 - y;
      const vtkIdType large = static_cast<vtkIdType>(3 * row + 1) * size[0] + 3 * x + 1;
      const size_t i = 3 * (static_cast<size_t>(row) * OverlayStage::Width + x);
      double difference = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        difference = std::max(difference,
          std::abs(colors->GetComponent(large, k) - static_cast<double>(small.Colors[i + k])));
      }
      ++number;
      equal += difference <= 8.0;
    }
  }
  CHECK_GREATER(equal, number * 95 / 100);
}

void TestSettings(RelevoCheck& check)
{
  OverlayStage stage;
  stage.Window->Render();
  CHECK_EQUAL(stage.Overlay->GetScaleInUse(), 1.0);
  const RelevoPicture small(stage.Window);
  stage.Overlay->SetScale(2.0);
  stage.Window->Render();
  CHECK_EQUAL(stage.Overlay->GetScaleInUse(), 2.0);
  CHECK(!RelevoPictures::Equal(RelevoPicture(stage.Window), small));
  stage.Overlay->SetScale(0.0);
  stage.Window->SetDPI(216);
  stage.Window->Render();
  CHECK_EQUAL(stage.Overlay->GetScaleInUse(), 3.0);

  RelevoErrors errors(stage.Overlay);
  stage.Overlay->SetScale(std::numeric_limits<double>::quiet_NaN());
  CHECK(errors.Said("Scale must be in [0.25, 8], got nan"));
  stage.Overlay->SetScale(9.0);
  CHECK(errors.Said("Scale must be in [0.25, 8], got 9"));
  CHECK_EQUAL(stage.Overlay->GetScale(), 0.0);
  stage.Overlay->SetFontSize(1.0);
  CHECK(errors.Said("FontSize must be in [6, 96], got 1"));
  stage.Overlay->SetFontFileName("no such file.ttf");
  stage.Window->Render();
  CHECK(errors.Said("no such file.ttf"));
}

// Contexts are separate, and that of the program stays current.
void TestTwoWindows(RelevoCheck& check)
{
  ImGuiContext* own = ImGui::CreateContext();
  ImGui::SetCurrentContext(own);
  OverlayStage first;
  {
    OverlayStage second;
    first.Window->Render();
    second.Window->Render();
    CHECK(first.Overlay->GetContext() != second.Overlay->GetContext());
    first.Click(60, first.SliderY);
    second.Click(100, second.SliderY);
    CHECK_GREATER(first.Value, 0.0f);
    CHECK_GREATER(second.Value, first.Value + 0.2f);
  }
  first.Click(20, first.SliderY);
  CHECK_LESS(first.Value, 0.1f);
  CHECK(ImGui::GetCurrentContext() == own);
  ImGui::DestroyContext(own);
}

// The overlay may outlive its window and its interactor.
void TestLifetime(RelevoCheck& check)
{
  vtkNew<vtkImGuiOverlay> overlay;
  CHECK(!overlay->Update());
  {
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetSize(50, 50);
    vtkNew<vtkGenericRenderWindowInteractor> interactor;
    window->SetInteractor(interactor);
    overlay->SetRenderWindow(window);
    int calls = 0;
    overlay->SetCallback([&] { ++calls; });
    CHECK(overlay->Update());
    window->Render();
    CHECK_GREATER(calls, 1);
    CHECK(!overlay->Update());
    overlay->RequestFrame();
    CHECK(overlay->Update());
    overlay->SetCallback(nullptr);
  }
  CHECK(overlay->GetRenderWindow() == nullptr);
  CHECK(overlay->GetInteractor() == nullptr);
}
}

int TestImGuiOverlay(int, char*[])
{
  RelevoCheck check;
  TestPixels(check, 0);
  TestPixels(check, 4);
  TestMagnified(check);
  TestSettings(check);
  TestTwoWindows(check);
  TestLifetime(check);
  return check.GetResult();
}
