// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random calls of VTK's classes around a mapper: three actors in two windows, pickers and
// selections.
#ifndef RelevoFuzzStage_h
#define RelevoFuzzStage_h

#include "RelevoFuzzColors.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <string>
#include <vector>

namespace RelevoFuzz
{
class Stage
{
public:
  explicit Stage(Dice& dice);
  virtual ~Stage() = default;
  Stage(const Stage&) = delete;
  void operator=(const Stage&) = delete;

  std::string FindError() { return this->Error; }

protected:
  struct View
  {
    vtkSmartPointer<vtkRenderWindow> Window;
    vtkSmartPointer<vtkRenderer> Renderer;
    bool IsDrawn = false;
  };

  void Renew(View& view);
  virtual vtkMapper* ChooseMapperOfActor() = 0;
  virtual void AfterRender() = 0;

  View& ChooseView() { return this->Views[static_cast<size_t>(this->D.Throw(2))]; }
  vtkActor* ChooseActor() { return this->D.Choose(this->Actors); }

  void ResetCamera(View& view);
  void Say(const std::string& error) { this->Error = this->Error.empty() ? error : this->Error; }

  void Render(View& view);

  void ChangeProperty(vtkProperty* property);

  void AddActorCalls(std::vector<Call>& calls);

  void AddViewCalls(std::vector<Call>& calls);

  void Pick();

  void Select();

  Dice& D;
  std::string Error;
  std::vector<View> Views = std::vector<View>(2);
  std::vector<vtkSmartPointer<vtkActor>> Actors = std::vector<vtkSmartPointer<vtkActor>>(3);
};
}

#endif
