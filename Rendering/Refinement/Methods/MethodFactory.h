// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   creates the methods that a mapper can draw with
 *
 * Private to the module.
 */
#ifndef MethodFactory_h
#define MethodFactory_h

#include "Methods/RefinementMethod.h"

#include <memory>

namespace relevo
{
/// Create a method by its number in RefinementMethod::Methods; ARKFPI for other numbers.
std::unique_ptr<RefinementMethod> NewMethod(int method);
}

#endif
