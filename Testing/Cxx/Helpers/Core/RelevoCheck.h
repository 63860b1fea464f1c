// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks that report where they fail and go on. In a test: RelevoCheck check; CHECK(...); ...;
// return check.GetResult();
#ifndef RelevoCheck_h
#define RelevoCheck_h

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkTestErrorObserver.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

class RelevoCheck
{
public:
  bool Fail(const char* file, int line, const std::string& what)
  {
    std::cerr << file << ":" << line << ": " << what << "\n";
    ++this->Failures;
    return false;
  }
  bool That(bool condition, const char* text, const char* file, int line)
  {
    return condition || this->Fail(file, line, std::string("not so: ") + text);
  }
  bool Near(
    double value, double expected, double tolerance, const char* text, const char* file, int line)
  {
    return std::abs(value - expected) <= tolerance ||
      this->Fail(file, line,
        std::string(text) + " is " + std::to_string(value) + ", not " + std::to_string(expected) +
          " +- " + std::to_string(tolerance));
  }
  int GetResult() const { return this->Failures ? EXIT_FAILURE : EXIT_SUCCESS; }

private:
  int Failures = 0;
};

// Catches the errors of an object as long as it lives, so that they are not printed.
class RelevoErrors
{
public:
  explicit RelevoErrors(vtkObject* object)
    : Object(object)
    , Tag(object->AddObserver(vtkCommand::ErrorEvent, this->Observer))
    , WarningTag(object->AddObserver(vtkCommand::WarningEvent, this->Observer))
  {
  }
  ~RelevoErrors()
  {
    this->Object->RemoveObserver(this->Tag);
    this->Object->RemoveObserver(this->WarningTag);
  }
  RelevoErrors(const RelevoErrors&) = delete;
  void operator=(const RelevoErrors&) = delete;

  // Whether there was an error that says `words`, and forgets it.
  bool Said(const std::string& words)
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
  // Whether there was a warning that says `words`, and forgets it.
  bool Warned(const std::string& words)
  {
    const bool warned = this->Observer->GetWarning() &&
      this->Observer->GetWarningMessage().find(words) != std::string::npos;
    this->Observer->Clear();
    return warned;
  }
  bool None() const { return !this->Observer->GetError() && !this->Observer->GetWarning(); }

private:
  vtkObject* Object;
  vtkNew<vtkTest::ErrorObserver> Observer;
  unsigned long Tag;
  unsigned long WarningTag;
};

#define CHECK(condition) check.That((condition), #condition, __FILE__, __LINE__)
#define CHECK_NEAR(value, expected, tolerance) \
  check.Near((value), (expected), (tolerance), #value, __FILE__, __LINE__)

#endif
