// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   UsageError
 * @brief   the exception for invalid arguments of the command line
 *
 * Its message names the option and says which values are valid.
 */
#ifndef UsageError_h
#define UsageError_h

#include <stdexcept>

struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

#endif
