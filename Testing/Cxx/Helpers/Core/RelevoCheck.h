// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks that report failures and continue. In a test: RelevoCheck check; CHECK(...); ...; return
// check.GetResult(); A failure prints both operands and the names of the enclosing cases:
//   TestX.cxx:12: [mesh "torus", level 2] failed: cells == 4 (3 == 4)
#ifndef RelevoCheck_h
#define RelevoCheck_h

#include "RelevoPrinted.h"

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkTestErrorObserver.h"

#include <cstdlib>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

class RelevoCheck
{
public:
  bool Fail(const char* file, int line, const std::string& what);
  bool That(bool condition, const char* text, const char* file, int line);
  bool Near(
    double value, double expected, double tolerance, const char* text, const char* file, int line);
  // An operand. Numbers are copied, because both operands may point to the same buffer, as with
  // GetPoint().
  template <class T>
  static std::conditional_t<std::is_scalar<T>::value, T, const T&> Value(const T& value)
  {
    return value;
  }

  // Whether the relation, for example std::less<>, holds for both values.
  template <class Relation, class A, class B>
  bool Compare(
    const A& a, const B& b, const char* text, const char* sign, const char* file, int line)
  {
    return RelevoCheck::Holds<Relation>(a, b) ||
      this->Differ(RelevoPrint(a), RelevoPrint(b), text, sign, file, line);
  }

  void Enter(const std::string& name) { this->Cases.push_back(name); }
  void Leave() { this->Cases.pop_back(); }
  int GetResult() const { return this->Failures ? EXIT_FAILURE : EXIT_SUCCESS; }

private:
  // Compares numbers as the operator does, without a warning about signs.
  template <class Relation, class A, class B>
  static bool Holds(const A& a, const B& b)
  {
    if constexpr (std::is_arithmetic<A>::value && std::is_arithmetic<B>::value)
    {
      using Number = typename std::common_type<A, B>::type;
      return Relation()(static_cast<Number>(a), static_cast<Number>(b));
    }
    else
    {
      return Relation()(a, b);
    }
  }

  bool Differ(const std::string& a, const std::string& b, const char* text, const char* sign,
    const char* file, int line);

  int Failures = 0;
  std::vector<std::string> Cases;
};

// Names a case during its lifetime: CHECK_CASE(level) prints "level 2".
class RelevoCase
{
public:
  template <class T>
  RelevoCase(RelevoCheck& check, const char* text, const T& value)
    : Check(check)
  {
    this->Check.Enter(std::string(text) + " " + RelevoPrint(value));
  }
  ~RelevoCase() { this->Check.Leave(); }
  RelevoCase(const RelevoCase&) = delete;
  void operator=(const RelevoCase&) = delete;

private:
  RelevoCheck& Check;
};

// Captures the errors of an object during its lifetime, so that they are not printed.
class RelevoErrors
{
public:
  explicit RelevoErrors(vtkObject* object);
  ~RelevoErrors();
  RelevoErrors(const RelevoErrors&) = delete;
  void operator=(const RelevoErrors&) = delete;

  // Whether an error contains `words`. Clears the errors.
  bool Said(const std::string& words);
  // Whether a warning contains `words`. Clears the warnings.
  bool Warned(const std::string& words);
  bool None() const { return !this->Observer->GetError() && !this->Observer->GetWarning(); }

private:
  vtkObject* Object;
  vtkNew<vtkTest::ErrorObserver> Observer;
  unsigned long Tag;
  unsigned long WarningTag;
};

#define CHECK(condition) check.That((condition), #condition, __FILE__, __LINE__)
#define CHECK_RELATION(relation, sign, a, b)                                                    \
  check.Compare<relation>(RelevoCheck::Value((a)), RelevoCheck::Value((b)), #a " " sign " " #b, \
    sign, __FILE__, __LINE__)
#define CHECK_EQUAL(a, b) CHECK_RELATION(std::equal_to<>, "==", a, b)
#define CHECK_NOT_EQUAL(a, b) CHECK_RELATION(std::not_equal_to<>, "!=", a, b)
#define CHECK_LESS(a, b) CHECK_RELATION(std::less<>, "<", a, b)
#define CHECK_LESS_EQUAL(a, b) CHECK_RELATION(std::less_equal<>, "<=", a, b)
#define CHECK_GREATER(a, b) CHECK_RELATION(std::greater<>, ">", a, b)
#define CHECK_GREATER_EQUAL(a, b) CHECK_RELATION(std::greater_equal<>, ">=", a, b)
#define RELEVO_JOIN_LINE(name, line) name##line
#define RELEVO_NAME_OF_LINE(name, line) RELEVO_JOIN_LINE(name, line)
#define CHECK_CASE(value) \
  const RelevoCase RELEVO_NAME_OF_LINE(caseOfLine, __LINE__)(check, #value, (value))
#define CHECK_NEAR(value, expected, tolerance) \
  check.Near((value), (expected), (tolerance), #value, __FILE__, __LINE__)

#endif
