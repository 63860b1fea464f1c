// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/GraphicsReport.h"

#include "Scene/OffscreenWindow.h"
#include "Text/ViewerMessages.h"

#include <imgui.h>

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkVersion.h"
#include "vtk_jsoncpp.h"

#include <set>
#include <sstream>

namespace
{
// The words of a line after its first colon.
std::string TakeValue(const std::string& line)
{
  const std::size_t first = line.find_first_not_of(" \t", line.find(':') + 1);
  return first == std::string::npos ? "" : line.substr(first);
}
}

//------------------------------------------------------------------------------
std::string MakeGraphicsReport(const std::string& version)
{
  ViewerMessages messages; // without observers, VTK would print errors
  const auto window = NewOffscreenWindow();
  messages.Observe(window);
  window->AddRenderer(vtkNew<vtkRenderer>());
  window->SetSize(16, 16);
  window->Render();
  messages.Check();
  auto* context = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!context || !context->IsCurrent())
  {
    throw ViewerError("there is no OpenGL context");
  }
  Json::Value report;
  report["relevo"] = version;
  report["vtk"] = vtkVersion::GetVTKVersion();
  report["imgui"] = IMGUI_VERSION;
  std::set<std::string> extensions;
  std::istringstream lines(context->ReportCapabilities());
  for (std::string line; std::getline(lines, line);)
  {
    for (const char* name : { "vendor", "renderer", "version" })
    {
      if (line.find("OpenGL " + std::string(name) + " string:") == 0)
      {
        report["opengl"][name] = TakeValue(line);
      }
    }
    std::istringstream words(line);
    for (std::string word; words >> word;)
    {
      if (word.compare(0, 3, "GL_") == 0)
      {
        extensions.insert(word);
      }
    }
  }
  report["opengl"]["texture size"] = vtkTextureObject::GetMaximumTextureSize(context);
  report["opengl"]["samples"] = context->GetMultiSamples();
  // Levels are chosen by compute shaders, and patterns drawn by indirect draws, where these exist.
  report["opengl"]["compute shaders"] = extensions.count("GL_ARB_compute_shader") > 0;
  report["opengl"]["tessellation shaders"] = extensions.count("GL_ARB_tessellation_shader") > 0;
  report["opengl"]["indirect draws"] = extensions.count("GL_ARB_multi_draw_indirect") > 0;
  for (const std::string& extension : extensions)
  {
    report["opengl"]["extensions"].append(extension);
  }
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  return Json::writeString(builder, report) + "\n";
}
