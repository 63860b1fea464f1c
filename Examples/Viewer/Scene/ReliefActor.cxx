// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ReliefActor.h"

#include "Options/ViewerOptions.h"
#include "Scene/ViewerStatistics.h"
#include "Text/ViewerMessages.h"

#include "vtkActor.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkReliefMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <iomanip>
#include <iostream>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeReliefActor(
  vtkMultiBlockDataSet* reliefs, const ViewerOptions& options, ViewerMessages& messages)
{
  vtkNew<vtkReliefMapper> mapper;
  messages.Observe(mapper);
  mapper->SetInputDataObject(reliefs);
  mapper->SetMethod(options.ReliefMethod.value_or(mapper->GetMethod()));
  mapper->SetSearch(options.ReliefSearch.value_or(mapper->GetSearch()));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

//------------------------------------------------------------------------------
void DrawReliefs(vtkActor* actor, vtkRenderer* renderer, vtkRenderWindow* window,
  const ViewerOptions& options, ViewerMessages& messages)
{
  if (!options.Statistics)
  {
    window->Render();
    messages.Check();
    return;
  }
  const double milliseconds = MeasureFrame(renderer, window, messages);
  auto* mapper = vtkReliefMapper::SafeDownCast(actor->GetMapper());
  auto* reliefs = vtkMultiBlockDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  std::cout << std::fixed << std::setprecision(1) << "reliefs: " << reliefs->GetNumberOfBlocks()
            << "\n"
            << "graphics memory: " << mapper->GetGraphicsMemorySize() / 1048576.0 << " MiB\n"
            << "frame time: " << milliseconds << " ms" << std::endl;
}
