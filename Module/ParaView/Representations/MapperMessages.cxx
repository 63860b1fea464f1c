// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperMessages.h"

#include "vtkCommand.h"
#include "vtkObject.h"

#include <utility>

namespace relevo
{
MapperMessages::MapperMessages(Function report, MapperWords words)
  : Report(std::move(report))
  , Words(std::move(words))
{
}

MapperMessages::~MapperMessages()
{
  this->Stop();
}

void MapperMessages::Observe(vtkObject* mapper)
{
  this->Stop();
  mapper->RemoveObservers(vtkCommand::ProgressEvent);
  this->Tags = { { mapper->AddObserver(vtkCommand::ErrorEvent, this, &MapperMessages::Pass),
    mapper->AddObserver(vtkCommand::WarningEvent, this, &MapperMessages::Pass) } };
  this->Mapper = mapper;
}

void MapperMessages::Stop()
{
  for (unsigned long tag : this->Tags)
  {
    if (this->Mapper)
    {
      this->Mapper->RemoveObserver(tag);
    }
  }
  this->Mapper = nullptr;
}

void MapperMessages::Pass(vtkObject*, unsigned long event, void* text)
{
  this->Report(event == vtkCommand::ErrorEvent, ReadMapperMessage(text, this->Words));
}
}
