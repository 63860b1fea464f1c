// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   an argument of a call in a generated program
 */
#ifndef CodeValue_h
#define CodeValue_h

#include <string>

struct CodeValue
{
  enum class Kind
  {
    Number,
    Integer,
    Text,
    Flag,
    File,     // the name of a file, relative to the folder of the program
    Object,   // a variable
    Constant, // a member of a class
    Port      // an output of a filter
  };

  CodeValue(double number)
    : Type(Kind::Number)
    , Number(number)
  {
  }
  CodeValue(int integer)
    : Type(Kind::Integer)
    , Integer(integer)
  {
  }
  CodeValue(long long integer)
    : Type(Kind::Integer)
    , Integer(integer)
  {
  }
  CodeValue(const char* text)
    : Text(text)
  {
  }
  CodeValue(const std::string& text)
    : Text(text)
  {
  }
  static CodeValue Flag(bool flag)
  {
    CodeValue value(Kind::Flag, "", "");
    value.Integer = flag ? 1 : 0;
    return value;
  }
  static CodeValue File(const std::string& name) { return { Kind::File, name, "" }; }
  static CodeValue Object(const std::string& name) { return { Kind::Object, name, "" }; }
  static CodeValue Constant(const std::string& className, const std::string& member)
  {
    return { Kind::Constant, className, member };
  }
  static CodeValue Port(const std::string& filter, int port = 0)
  {
    CodeValue value(Kind::Port, filter, "");
    value.Integer = port;
    return value;
  }

  Kind Type = Kind::Text;
  double Number = 0.0;
  long long Integer = 0; // or the index of the output
  std::string Text;      // or the name of the file, object or class
  std::string Member;    // of the class

private:
  CodeValue(Kind type, const std::string& text, const std::string& member)
    : Type(type)
    , Text(text)
    , Member(member)
  {
  }
};

#endif
