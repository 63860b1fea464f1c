// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   random tokens, and their comparison
 */
#ifndef AccessToken_h
#define AccessToken_h

#include <string>

namespace relevo
{
/// 128 random bits as 32 hexadecimal digits, from the random source of the system. Empty if that
/// is not available.
std::string MakeToken();

/// Whether all characters are letters, digits or one of - . _ ~, which need no escape in a URL.
bool IsToken(const std::string& text);

/// Compares in a time that depends only on the length of `given`.
bool AreEqualTokens(const std::string& given, const std::string& expected);
}

#endif
