// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RelevoCheck.h"

#include <cmath>
#include <iostream>

bool RelevoCheck::Fail(const char* file, int line, const std::string& what)
{
  std::cerr << file << ":" << line << ": " << what << "\n";
  ++this->Failures;
  return false;
}

bool RelevoCheck::That(bool condition, const char* text, const char* file, int line)
{
  return condition || this->Fail(file, line, std::string("not so: ") + text);
}

bool RelevoCheck::Near(
  double value, double expected, double tolerance, const char* text, const char* file, int line)
{
  return std::abs(value - expected) <= tolerance ||
    this->Fail(file, line,
      std::string(text) + " is " + std::to_string(value) + ", not " + std::to_string(expected) +
        " +- " + std::to_string(tolerance));
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
