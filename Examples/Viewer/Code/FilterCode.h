// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   adds the filters of a mapper to the program of a scene
 */
#ifndef FilterCode_h
#define FilterCode_h

#include "Code/CodeValue.h"

#include <string>

class SceneCode;
class vtkAlgorithm;
class vtkPlane;

/// Adds the filters that give an input of an algorithm, unless the code has them. Data that the
/// code does not know are saved beside the program, in a file with this name. Returns the output
/// that the input is connected to. Throws ViewerError for filters that the viewer does not use.
CodeValue AddInputCode(
  SceneCode& code, vtkAlgorithm* algorithm, const std::string& name, int port = 0);

CodeValue AddPlaneCode(SceneCode& code, vtkPlane* plane);

#endif
