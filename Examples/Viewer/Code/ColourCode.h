// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds colour tables to the program of a scene
 */
#ifndef ColourCode_h
#define ColourCode_h

#include "Code/CodeValue.h"

#include <string>

class SceneCode;
class vtkColorTransferFunction;
class vtkLookupTable;
class vtkScalarsToColors;

/// Returns the variable of the table. Throws ViewerError for tables that are no
/// vtkColorTransferFunction, unless the code has them.
CodeValue AddColourCode(
  SceneCode& code, vtkScalarsToColors* colours, const std::string& name = "colours");

/// Adds the nodes and settings of a function whose variable exists.
void AddFunctionCode(
  SceneCode& code, vtkColorTransferFunction* function, const std::string& variable);

/// Adds a table of logarithmic scale that MakeColours() has filled from a function.
void AddLogColourCode(SceneCode& code, vtkColorTransferFunction* function, vtkLookupTable* table);

#endif
