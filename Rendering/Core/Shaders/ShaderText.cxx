// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/ShaderText.h"

#include "vtkShaderProgram.h"
#include "vtkVersion.h"

namespace relevo
{
namespace
{
constexpr const char* Main = "void main(";

const char* GetStageName(vtkShader::Type stage)
{
  switch (stage)
  {
    case vtkShader::Vertex:
      return "vertex";
    case vtkShader::Geometry:
      return "geometry";
    case vtkShader::Fragment:
      return "fragment";
    default:
      return "unknown";
  }
}

// Return the position of the brace that closes the one at a position; braces in comments are
// skipped.
size_t FindClosingBrace(const std::string& text, size_t place)
{
  int depth = 0;
  while ((place = text.find_first_of("{}/", place)) != std::string::npos)
  {
    if (text[place] == '/')
    {
      const bool isLine = text.compare(place, 2, "//") == 0;
      const bool isBlock = text.compare(place, 2, "/*") == 0;
      place = isLine ? text.find('\n', place) : isBlock ? text.find("*/", place + 2) : place + 1;
      continue;
    }
    depth += text[place] == '{' ? 1 : -1;
    if (depth == 0)
    {
      return place;
    }
    ++place;
  }
  return place;
}
}

ShaderText::ShaderText(vtkShader* shader, MissingAnchors& missing)
  : Shader(shader)
  , Missing(missing)
  , Text(shader->GetSource())
{
}

ShaderText::~ShaderText()
{
  this->Shader->SetSource(this->Text);
}

bool ShaderText::Has(const std::string& anchor) const
{
  return this->Text.find(anchor) != std::string::npos;
}

void ShaderText::Miss(const std::string& anchor)
{
  this->Missing.insert(
    std::string(GetStageName(this->Shader->GetType())) + " shader: \"" + anchor + "\"");
}

size_t ShaderText::Find(const std::string& anchor)
{
  const size_t place = this->Text.find(anchor);
  if (place == std::string::npos)
  {
    this->Miss(anchor);
  }
  return place;
}

void ShaderText::Replace(const std::string& anchor, const std::string& text)
{
  if (!vtkShaderProgram::Substitute(this->Text, anchor, text))
  {
    this->Miss(anchor);
  }
}

void ShaderText::InsertBefore(const std::string& anchor, const std::string& text)
{
  const size_t place = this->Find(anchor);
  if (place != std::string::npos)
  {
    this->Text.insert(place, text);
  }
}

void ShaderText::InsertAfter(const std::string& anchor, const std::string& text)
{
  const size_t place = this->Find(anchor);
  if (place != std::string::npos)
  {
    this->Text.insert(place + anchor.size(), text);
  }
}

void ShaderText::IfReplace(const std::string& anchor, const std::string& text)
{
  vtkShaderProgram::Substitute(this->Text, anchor, text);
}

void ShaderText::IfInsertAfter(const std::string& anchor, const std::string& text)
{
  if (this->Has(anchor))
  {
    this->InsertAfter(anchor, text);
  }
}

void ShaderText::InsertAfterVersion(const std::string& text)
{
  const std::string mark = "//VTK::System::Dec";
  const size_t directive = this->Text.find("#version");
  const size_t end =
    directive == std::string::npos ? std::string::npos : this->Text.find('\n', directive);
  if (!this->Has(mark) && end != std::string::npos)
  {
    this->Text.insert(end + 1, text);
  }
  else
  {
    this->InsertAfter(mark, "\n" + text);
  }
}

void ShaderText::InsertBeforeMain(const std::string& text)
{
  this->InsertBefore(Main, text);
}

size_t ShaderText::FindBody()
{
  const size_t main = this->Find(Main);
  if (main == std::string::npos)
  {
    return main;
  }
  const size_t brace = this->Text.find_first_not_of(" \t\r\n", this->Text.find(')', main) + 1);
  if (brace == std::string::npos || this->Text[brace] != '{')
  {
    this->Miss("{");
    return std::string::npos;
  }
  return brace;
}

void ShaderText::InsertAtStart(const std::string& text)
{
  const size_t brace = this->FindBody();
  if (brace != std::string::npos)
  {
    this->Text.insert(brace + 1, "\n" + text);
  }
}

void ShaderText::InsertAtEnd(const std::string& text)
{
  const size_t start = this->FindBody();
  if (start == std::string::npos)
  {
    return;
  }
  const size_t end = FindClosingBrace(this->Text, start);
  if (end != std::string::npos)
  {
    this->Text.insert(end, "\n" + text);
  }
  else
  {
    this->Miss("}");
  }
}

void InsertColors(ShaderText& fragment, bool ownFragments, const std::string& text)
{
  const std::string colors = "//VTK::Color::Impl"; // where VTK writes the colours of fragments
  if (ownFragments)
  {
    fragment.IfInsertAfter(colors, text);
  }
  else
  {
    fragment.InsertAfter(colors, text);
  }
}

std::string MakeMaterialColor(const std::string& color)
{
  return "\n  vec4 relevoColor = " + color +
    ";\n  ambientColor = ambientIntensity * relevoColor.rgb;\n"
    "  diffuseColor = diffuseIntensity * relevoColor.rgb;\n"
    "  opacity = opacityUniform * relevoColor.a;\n";
}

bool ComputeVertexAttributes(ShaderText& vertex, const std::string& function)
{
  vertex.Replace("in vec4 vertexMC;", "vec4 vertexMC;");
  const bool hasNormal = vertex.Has("in vec3 normalMC;");
  vertex.IfReplace("in vec3 normalMC;", "vec3 normalMC;");
  vertex.IfReplace("gl_VertexID", "0"); // vertices are not points of the input
  vertex.InsertAtStart("  " + function + "();\n");
  vertex.InsertAtEnd("  if (relevoHidden) { gl_Position = vec4(0.0, 0.0, 2.0, 1.0); }\n");
  return hasNormal;
}

const char* GetPreciseExtension()
{
  return "#extension GL_ARB_gpu_shader5 : enable\n"
         "#ifndef GL_ARB_gpu_shader5\n"
         "#define precise\n"
         "#endif\n";
}

std::string DescribeMissing(const MissingAnchors& missing)
{
  std::string list;
  for (const std::string& anchor : missing)
  {
    list += (list.empty() ? "" : ", ") + anchor;
  }
  return std::string("The shaders of VTK ") + vtkVersion::GetVTKVersion() +
    " do not contain text that Relevo replaces (" + list +
    "). The surface is not drawn. Use a release of VTK that Relevo supports, and keep this text in "
    "the replacements of the actor's vtkShaderProperty.";
}

void DrawNothing(std::map<vtkShader::Type, vtkShader*>& shaders)
{
  shaders[vtkShader::Vertex]->SetSource(
    "//VTK::System::Dec\nvoid main()\n{\n  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);\n}\n");
  shaders[vtkShader::Geometry]->SetSource("");
  shaders[vtkShader::Fragment]->SetSource(
    "//VTK::System::Dec\n//VTK::Output::Dec\nvoid main()\n{\n  discard;\n}\n");
}
}
