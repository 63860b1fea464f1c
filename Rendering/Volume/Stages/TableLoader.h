// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   TableLoader
 * @brief   the stage that computes the table of pre-integration
 *
 * Private to the module.
 */
#ifndef TableLoader_h
#define TableLoader_h

#include "Buffers/IntegralTable.h"
#include "Changes/Dependencies.h"
#include "Checks/StageReport.h"

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace relevo
{
struct VolumeFunctions;

struct TableRequest
{
  vtkOpenGLRenderWindow* Window;
  const VolumeFunctions& Functions;
  bool IsNeeded;
  IntegralTable::Settings Settings;
};

class TableLoader
{
public:
  /// Compute and upload the table, if it is needed and out of date. If it does not fit, return
  /// false; this is tried and reported once.
  bool Update(const TableRequest& request, StageReport& report);

  IntegralTable& GetTable() { return this->Table; }
  const IntegralTable& GetTable() const { return this->Table; }
  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  IntegralTable Table;
  Dependencies Known;  // functions of the table
  Dependencies Failed; // functions and settings that failed
  vtkIdType NumberOfBuilds = 0;
};
}

#endif
