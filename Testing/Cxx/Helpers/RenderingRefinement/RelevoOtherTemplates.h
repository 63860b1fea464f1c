// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Mappers that see modified shader templates, as another release of VTK may have.
#ifndef RelevoOtherTemplates_h
#define RelevoOtherTemplates_h

#include "RelevoScene.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkVersion.h"

#include <iostream>
#include <map>
#include <string>
#include <vector>

// Text to rename, by shader stage.
struct RelevoRenaming
{
  vtkShader::Type Stage = vtkShader::Unknown;
  std::string From;
  std::string To;
};

// Renames text of the templates and of code that VTK inserted.
template <typename Mapper>
class RelevoOtherTemplates : public Mapper
{
public:
  vtkTemplateTypeMacro(RelevoOtherTemplates, Mapper);
  static RelevoOtherTemplates* New() { VTK_STANDARD_NEW_BODY(RelevoOtherTemplates); }

  inline static RelevoRenaming Renaming; // applies to all instances

protected:
  using Shaders = std::map<vtkShader::Type, vtkShader*>;

  void GetShaderTemplate(Shaders shaders, vtkRenderer* ren, vtkActor* act) override
  {
    this->Superclass::GetShaderTemplate(shaders, ren, act);
    Rename(shaders);
  }
  void ReplaceShaderColor(Shaders shaders, vtkRenderer* ren, vtkActor* act) override
  {
    this->Superclass::ReplaceShaderColor(shaders, ren, act);
    Rename(shaders);
  }
  void ReplaceShaderEdges(Shaders shaders, vtkRenderer* ren, vtkActor* act) override
  {
    this->Superclass::ReplaceShaderEdges(shaders, ren, act);
    Rename(shaders);
  }
  void ReplaceShaderPicking(Shaders shaders, vtkRenderer* ren, vtkActor* act) override
  {
    this->Superclass::ReplaceShaderPicking(shaders, ren, act);
    Rename(shaders);
  }

private:
  static void Rename(Shaders& shaders)
  {
    if (Renaming.Stage != vtkShader::Unknown)
    {
      std::string text = shaders[Renaming.Stage]->GetSource();
      if (text.find(Renaming.To) == std::string::npos)
      {
        vtkShaderProgram::Substitute(text, Renaming.From, Renaming.To);
        shaders[Renaming.Stage]->SetSource(text);
      }
    }
  }
};

// Captures the errors of mappers, and checks that nothing else is reported.
class RelevoComplaints
{
public:
  explicit RelevoComplaints(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this, &RelevoComplaints::Take);
    vtkOutputWindow::SetInstance(this->Others);
  }
  ~RelevoComplaints() { vtkOutputWindow::SetInstance(nullptr); }
  RelevoComplaints(const RelevoComplaints&) = delete;
  void operator=(const RelevoComplaints&) = delete;

  // Whether there was exactly one error, which names this stage and anchor. Clears the errors.
  bool IsMissing(const std::string& stage, const std::string& anchor)
  {
    const bool found = this->Texts.size() == 1 && this->Others->Text.empty() &&
      this->Texts[0].find(stage + " shader: \"" + anchor + "\"") != std::string::npos &&
      this->Texts[0].find(vtkVersion::GetVTKVersion()) != std::string::npos;
    if (!found)
    {
      std::cerr << this->Texts.size() << " errors:\n";
      for (const std::string& text : this->Texts)
      {
        std::cerr << text;
      }
      std::cerr << "others: " << this->Others->Text << "\n";
    }
    this->Texts.clear();
    return found;
  }
  bool None() const { return this->Texts.empty() && this->Others->Text.empty(); }

private:
  class OutputWindow : public vtkOutputWindow
  {
  public:
    static OutputWindow* New() { VTK_STANDARD_NEW_BODY(OutputWindow); }
    vtkTemplateTypeMacro(OutputWindow, vtkOutputWindow);
    void DisplayText(const char* text) override { this->Text += text; }
    std::string Text;
  };

  void Take(vtkObject*, unsigned long, void* text)
  {
    this->Texts.emplace_back(static_cast<const char*>(text));
  }

  std::vector<std::string> Texts;
  vtkNew<OutputWindow> Others;
};

#endif
