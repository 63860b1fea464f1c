// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages/TableLoader.h"

#include "Stages/FunctionLoader.h"

#include "vtkOpenGLRenderWindow.h"

namespace relevo
{
// A length that differs only by rounding does not require another table: see IntegralTable::Has().
bool TableLoader::Update(const TableRequest& request, StageReport& report)
{
  if (this->Known.Update(Dependencies::On(request.Functions.Version)))
  {
    this->Table.ReleaseGraphicsResources(request.Window);
  }
  const IntegralTable::Settings& settings = request.Settings;
  if (!request.IsNeeded || this->Table.Has(settings))
  {
    return true;
  }
  const Dependencies now = Dependencies::On(request.Functions.Version, settings.Size, settings.Is2D,
    settings.Longest, settings.ScalarLow, settings.ScalarSize);
  if (this->Failed == now)
  {
    return false;
  }
  ++this->NumberOfBuilds;
  if (!this->Table.Upload(request.Window, request.Functions.Functions, settings))
  {
    this->Failed = now;
    report.Errors.push_back(
      "There is not enough graphics memory for the table of pre-integration: lower TableSize.");
    return false;
  }
  return true;
}

void TableLoader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Table.ReleaseGraphicsResources(window);
  this->Failed.Clear();
}
}
