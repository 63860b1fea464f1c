// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   errors and warnings of representations
 *
 * Private to the module.
 */
#ifndef RepresentationReports_h
#define RepresentationReports_h

#include <string>

class vtkObject;

namespace relevo
{
/// Report an error or a warning of a representation.
void Report(vtkObject* representation, bool isError, const std::string& message);

//@{
/// Report a problem that all ranks know on the first one, unless it is empty or equals the last
/// one, which it replaces.
void ReportError(vtkObject* representation, std::string& last, const std::string& error);
void ReportWarning(vtkObject* representation, std::string& last, const std::string& warning);
//@}
}

#endif
