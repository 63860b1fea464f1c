// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Counts the warnings of an object.
#ifndef RelevoWarnings_h
#define RelevoWarnings_h

#include "vtkObject.h"

#include <string>

// Must live at least as long as the object issues warnings. The warnings are not printed.
class RelevoWarnings
{
public:
  explicit RelevoWarnings(vtkObject* object);
  int Number = 0;
  std::string Text;
};

#endif
