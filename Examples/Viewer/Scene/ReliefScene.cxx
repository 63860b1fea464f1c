// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ReliefScene.h"

#include "Code/SceneCode.h"
#include "Scene/ReliefActor.h"
#include "Text/ReadingGuard.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkReliefDatabaseReader.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
ReliefScene::ReliefScene(const ViewerOptions& options, ViewerMessages& messages)
  : ViewerScene(options, messages)
{
  vtkNew<vtkReliefDatabaseReader> reader;
  messages.Observe(reader);
  reader->SetFileName(options.Input.c_str());
  {
    const ReadingGuard guard({ options.Input });
    reader->Update();
  }
  messages.Check();
  this->Actor = MakeReliefActor(reader->GetOutput(), options, messages);
  this->Renderer->AddActor(this->Actor);
  this->SetView(this->Actor->GetBounds());
}

//------------------------------------------------------------------------------
ReliefScene::~ReliefScene() = default;

//------------------------------------------------------------------------------
void ReliefScene::AddDataCode(SceneCode& code)
{
  code.Note("The reliefs.");
  const std::string reader = code.New("vtkReliefDatabaseReader", "reader");
  code.Call(reader, "SetFileName", { code.GetFile(this->Options.Input) });
  code.Remember(this->Actor->GetMapper()->GetInputDataObject(0, 0), CodeValue::Port(reader));
}

//------------------------------------------------------------------------------
void ReliefScene::Draw(vtkRenderWindow* window)
{
  DrawReliefs(this->Actor, this->Renderer, window, this->Options, this->Messages);
}
