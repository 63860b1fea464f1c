// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RepresentationReports.h"

#include "Checks/ShouldReport.h"
#include "FirstRank.h"
#include "vtkObject.h"

namespace relevo
{
namespace
{
void ReportOnce(
  vtkObject* representation, bool isError, std::string& last, const std::string& message)
{
  if (ShouldReport(last, message) && IsFirstRank())
  {
    Report(representation, isError, message);
  }
}
}

void Report(vtkObject* representation, bool isError, const std::string& message)
{
  if (isError)
  {
    vtkErrorWithObjectMacro(representation, << message);
  }
  else
  {
    vtkWarningWithObjectMacro(representation, << message);
  }
}

void ReportError(vtkObject* representation, std::string& last, const std::string& error)
{
  ReportOnce(representation, true, last, error);
}

void ReportWarning(vtkObject* representation, std::string& last, const std::string& warning)
{
  ReportOnce(representation, false, last, warning);
}
}
