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
  /// Compute and upload the table if it is needed and there is none of these functions and
  /// settings. Returns false if there is no room for it, which is reported, and tried, once.
  bool Update(const TableRequest& request, StageReport& report);

  IntegralTable& GetTable() { return this->Table; }
  const IntegralTable& GetTable() const { return this->Table; }
  vtkIdType GetNumberOfBuilds() const { return this->NumberOfBuilds; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  IntegralTable Table;
  Dependencies Known;  // functions
  Dependencies Failed; // functions and settings
  vtkIdType NumberOfBuilds = 0;
};
}

#endif
