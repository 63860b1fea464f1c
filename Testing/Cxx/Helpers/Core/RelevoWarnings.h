// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The warnings of an object, counted.
#ifndef RelevoWarnings_h
#define RelevoWarnings_h

#include "vtkObject.h"

#include <string>

// Lives at least as long as the object warns; none of the warnings is printed.
class RelevoWarnings
{
public:
  explicit RelevoWarnings(vtkObject* object);
  int Number = 0;
  std::string Text;
};

#endif
