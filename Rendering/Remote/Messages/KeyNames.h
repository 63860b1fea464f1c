// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   KeyNames
 * @brief   names of keys in browsers and in VTK
 */
#ifndef KeyNames_h
#define KeyNames_h

#include <string>

namespace relevo
{
struct WindowKey
{
  char Code = 0;      // ASCII; 0 for other keys
  std::string Symbol; // as X11 and VTK name it
};

/// The key with a name as in KeyboardEvent.key. Unknown names are the symbol.
WindowKey FindKey(const std::string& name, bool hasControl);
}

#endif
