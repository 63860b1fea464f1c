// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   makes the methods by which a mapper can draw
 *
 * Private to the module.
 */
#ifndef MethodFactory_h
#define MethodFactory_h

#include "Methods/RefinementMethod.h"

#include <memory>

namespace relevo
{
/// A method by its number among RefinementMethod::Methods; ARKFPI for others.
std::unique_ptr<RefinementMethod> NewMethod(int method);
}

#endif
