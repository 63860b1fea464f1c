// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/TessellationPrograms.h"

#include "OpenGL/RelevoOpenGL.h"
#include "OpenGL/ShaderLog.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace relevo
{
namespace
{
// The GLSL version of OpenGL 4.0, the first with tessellation stages.
constexpr int MinimumVersion = 400;

// Suppresses errors, which the caller reports.
class Silence : public vtkCommand
{
public:
  static Silence* New() { return new Silence; }
  void Execute(vtkObject*, unsigned long, void*) override {}
};

class TessellationProgram : public vtkShaderProgram
{
public:
  static TessellationProgram* New();
  vtkTypeMacro(TessellationProgram, vtkShaderProgram);

  std::string ControlSource;
  std::string EvaluationSource;

  // Return why the program could not be built.
  std::string FindError()
  {
    for (vtkShader* shader :
      { this->GetVertexShader(), this->GetGeometryShader(), this->GetFragmentShader() })
    {
      if (!shader->GetError().empty())
      {
        return shader->GetError();
      }
    }
    return this->GetError();
  }

protected:
  TessellationProgram() = default;
  ~TessellationProgram() override = default;

  int CompileShader() override
  {
    if (this->Handle == 0)
    {
      this->Handle = static_cast<int>(glCreateProgram());
    }
    return this->AttachStage(GL_TESS_CONTROL_SHADER, "tessellation control", this->ControlSource) &&
        this->AttachStage(
          GL_TESS_EVALUATION_SHADER, "tessellation evaluation", this->EvaluationSource)
      ? this->Superclass::CompileShader()
      : 0;
  }

private:
  bool AttachStage(GLenum stage, const char* name, const std::string& source)
  {
    const GLuint shader = relevo::CompileShader(stage, name, source, this->Error);
    if (shader)
    {
      glAttachShader(static_cast<GLuint>(this->Handle), shader);
      glDeleteShader(shader); // deleted together with the program
    }
    return shader != 0;
  }
};
vtkStandardNewMacro(TessellationProgram);

// Releasing a program also releases the current one, so VTK's shader cache must be updated.
void LetGo(vtkWindow* window)
{
  if (vtkOpenGLRenderWindow* current = vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    current->GetShaderCache()->ReleaseCurrentShader();
  }
}

// Replace the version that VTK has chosen, if it is too old.
std::string GetVersion(std::string& evaluation)
{
  const std::string directive = "#version ";
  const size_t begin = evaluation.find(directive);
  const size_t end = evaluation.find('\n', begin);
  if (begin == std::string::npos || end == std::string::npos)
  {
    return "";
  }
  const int version = std::atoi(evaluation.c_str() + begin + directive.size());
  const std::string line = directive + std::to_string(std::max(version, MinimumVersion)) + "\n";
  evaluation.replace(begin, end + 1 - begin, line);
  return line;
}
}

// VTK's cache resolves the remaining anchors in the shaders. This cache builds another kind of
// program from them, which the window's cache binds.
class TessellationProgramCache : public vtkOpenGLShaderCache
{
public:
  static TessellationProgramCache* New();
  vtkTypeMacro(TessellationProgramCache, vtkOpenGLShaderCache);

  // The sources of the programs.
  std::string VertexSource;
  std::string ControlSource;

  // Programs by the sources of their stages.
  std::map<std::vector<std::string>, vtkSmartPointer<TessellationProgram>> Programs;

  // Remove the last program, and return why it could not be built.
  std::string TakeFailure()
  {
    const auto last = this->Programs.find(this->LastKey);
    if (last == this->Programs.end())
    {
      return "there is no program";
    }
    const std::string error =
      this->HasVersion ? last->second->FindError() : "the vertex shader contains no \"#version\"";
    last->second->ReleaseGraphicsResources(nullptr);
    this->Programs.erase(last);
    return error;
  }

protected:
  TessellationProgramCache() = default;
  ~TessellationProgramCache() override = default;

  using vtkOpenGLShaderCache::GetShaderProgram;
  vtkShaderProgram* GetShaderProgram(std::map<vtkShader::Type, vtkShader*> shaders) override
  {
    std::string evaluation = shaders[vtkShader::Vertex]->GetSource();
    const std::string version = GetVersion(evaluation);
    this->HasVersion = !version.empty();
    this->LastKey = { this->VertexSource, this->ControlSource, evaluation,
      shaders[vtkShader::Geometry]->GetSource(), shaders[vtkShader::Fragment]->GetSource() };
    vtkSmartPointer<TessellationProgram>& program = this->Programs[this->LastKey];
    if (!program)
    {
      program = vtkSmartPointer<TessellationProgram>::New();
      program->GetVertexShader()->SetSource(version + this->VertexSource);
      program->ControlSource = version + this->ControlSource;
      program->EvaluationSource = evaluation;
      program->SetGeometryShader(shaders[vtkShader::Geometry]);
      program->SetFragmentShader(shaders[vtkShader::Fragment]);
      vtkNew<Silence> silence;
      program->AddObserver(vtkCommand::ErrorEvent, silence);
    }
    return program;
  }

  int BindShader(vtkShaderProgram*) override { return 1; }

private:
  std::vector<std::string> LastKey;
  bool HasVersion = false;
};
vtkStandardNewMacro(TessellationProgramCache);

TessellationPrograms::TessellationPrograms() = default;
TessellationPrograms::~TessellationPrograms() = default;

bool TessellationPrograms::AreSupported()
{
  GLint major = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  return major >= 4 && glPatchParameteri != nullptr;
}

vtkShaderProgram* TessellationPrograms::Build(vtkOpenGLRenderWindow* window,
  const std::string& vertex, const std::string& control,
  const std::map<vtkShader::Type, vtkShader*>& shaders)
{
  LetGo(window);
  this->Cache->VertexSource = vertex;
  this->Cache->ControlSource = control;
  vtkShaderProgram* program = this->Cache->ReadyShaderProgram(shaders);
  this->Error.clear();
  if (program)
  {
    program->RemoveObservers(vtkCommand::ErrorEvent); // errors are reported from now on
  }
  else
  {
    this->Error = this->Cache->TakeFailure();
  }
  return program;
}

void TessellationPrograms::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Cache->Programs.empty())
  {
    return;
  }
  LetGo(window);
  for (auto& program : this->Cache->Programs)
  {
    program.second->ReleaseGraphicsResources(window);
  }
  this->Cache->Programs.clear();
}
}
