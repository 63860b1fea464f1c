// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   values of generated programs as texts, which differ by a few words of the language
 */
#ifndef ValueText_h
#define ValueText_h

#include "Code/CodeValue.h"

#include <functional>
#include <string>
#include <vector>

struct LanguageWords
{
  std::string True;
  std::string False;
  std::string OfObject; // between an object and its method
  std::string OfClass;  // between a class and its member
  std::string BeforeFile;
  std::string AfterFile; // around the name of a file in the folder of the program
  std::function<std::string(const std::string&)> NameClass;
};

std::string WriteValue(const CodeValue& value, const LanguageWords& words);

/// The numbers of a row, separated by commas.
std::string WriteRow(const std::vector<double>& row);

#endif
