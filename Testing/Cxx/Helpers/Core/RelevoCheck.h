// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks that report where they fail and go on. In a test: RelevoCheck check; CHECK(...); ...;
// return check.GetResult();
#ifndef RelevoCheck_h
#define RelevoCheck_h

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkTestErrorObserver.h"

#include <cstdlib>
#include <string>

class RelevoCheck
{
public:
  bool Fail(const char* file, int line, const std::string& what);
  bool That(bool condition, const char* text, const char* file, int line);
  bool Near(
    double value, double expected, double tolerance, const char* text, const char* file, int line);
  int GetResult() const { return this->Failures ? EXIT_FAILURE : EXIT_SUCCESS; }

private:
  int Failures = 0;
};

// Catches the errors of an object as long as it lives, so that they are not printed.
class RelevoErrors
{
public:
  explicit RelevoErrors(vtkObject* object);
  ~RelevoErrors();
  RelevoErrors(const RelevoErrors&) = delete;
  void operator=(const RelevoErrors&) = delete;

  // Whether there was an error that says `words`, and forgets it.
  bool Said(const std::string& words);
  // Whether there was a warning that says `words`, and forgets it.
  bool Warned(const std::string& words);
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
