// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   all controls, in the order of the panel
 */
#ifndef ControlTable_h
#define ControlTable_h

#include "Controls/Control.h"

#include <vector>

std::vector<Control> GetControlTable();

#endif
