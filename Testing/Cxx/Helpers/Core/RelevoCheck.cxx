// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoCheck.h"

#include <cmath>
#include <iostream>

bool RelevoCheck::Fail(const char* file, int line, const std::string& what)
{
  std::string names;
  for (const std::string& name : this->Cases)
  {
    names += (names.empty() ? "[" : ", ") + name;
  }
  std::cerr << file << ":" << line << ": " << names << (names.empty() ? "" : "] ") << what << "\n";
  ++this->Failures;
  return false;
}

bool RelevoCheck::That(bool condition, const char* text, const char* file, int line)
{
  return condition || this->Fail(file, line, std::string("failed: ") + text);
}

bool RelevoCheck::Near(
  double value, double expected, double tolerance, const char* text, const char* file, int line)
{
  return std::abs(value - expected) <= tolerance ||
    this->Fail(file, line,
      std::string(text) + " is " + RelevoPrint(value) + ", not " + RelevoPrint(expected) + " +- " +
        RelevoPrint(tolerance));
}

bool RelevoCheck::Differ(const std::string& a, const std::string& b, const char* text,
  const char* sign, const char* file, int line)
{
  return this->Fail(
    file, line, std::string("failed: ") + text + " (" + a + " " + sign + " " + b + ")");
}

RelevoErrors::RelevoErrors(vtkObject* object)
  : Object(object)
  , Tag(object->AddObserver(vtkCommand::ErrorEvent, this->Observer))
  , WarningTag(object->AddObserver(vtkCommand::WarningEvent, this->Observer))
{
}

RelevoErrors::~RelevoErrors()
{
  this->Object->RemoveObserver(this->Tag);
  this->Object->RemoveObserver(this->WarningTag);
}

bool RelevoErrors::Said(const std::string& words)
{
  const bool said = this->Observer->GetError() &&
    this->Observer->GetErrorMessage().find(words) != std::string::npos;
  if (!said)
  {
    std::cerr << "errors so far: " << this->Observer->GetErrorMessage() << "\n";
  }
  this->Observer->Clear();
  return said;
}

bool RelevoErrors::Warned(const std::string& words)
{
  const bool warned = this->Observer->GetWarning() &&
    this->Observer->GetWarningMessage().find(words) != std::string::npos;
  this->Observer->Clear();
  return warned;
}
