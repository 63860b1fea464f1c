// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Code/ValueText.h"

#include "Code/NumberText.h"

//------------------------------------------------------------------------------
std::string WriteValue(const CodeValue& value, const LanguageWords& words)
{
  switch (value.Type)
  {
    case CodeValue::Kind::Number:
      return WriteNumber(value.Number);
    case CodeValue::Kind::Integer:
      return std::to_string(value.Integer);
    case CodeValue::Kind::Flag:
      return value.Integer != 0 ? words.True : words.False;
    case CodeValue::Kind::Text:
      return Quote(value.Text);
    case CodeValue::Kind::File:
      return words.BeforeFile + Quote(value.Text) + words.AfterFile;
    case CodeValue::Kind::Object:
      return value.Text;
    case CodeValue::Kind::Constant:
      return words.NameClass(value.Text) + words.OfClass + value.Member;
    case CodeValue::Kind::Port:
      return value.Text + words.OfObject + "GetOutputPort(" +
        (value.Integer > 0 ? std::to_string(value.Integer) : "") + ")";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string WriteRow(const std::vector<double>& row)
{
  std::string text;
  for (const double number : row)
  {
    text += (text.empty() ? "" : ", ") + WriteNumber(number);
  }
  return text;
}
