// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the modules of the classes in generated programs
 */
#ifndef ClassModules_h
#define ClassModules_h

#include <string>

/// A module of VTK or Relevo, such as RenderingCore.
struct ClassModule
{
  std::string Name;
  bool IsRelevo;
};

/// The class must be one that generated programs use.
ClassModule FindModule(const std::string& className);

#endif
