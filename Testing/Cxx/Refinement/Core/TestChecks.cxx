// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that failed checks print both operands and the names of the cases. This test compares
// results itself, because broken checks would not report anything.
#include "RelevoCheck.h"

#include <array>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
struct Unprintable
{
  int Value;
  bool operator==(const Unprintable& other) const { return this->Value == other.Value; }
};

enum class Color
{
  Red = 3,
  Green = 4
};

// Captures the messages of failed checks during its lifetime.
class Printed
{
public:
  Printed()
    : Before(std::cerr.rdbuf(this->Stream.rdbuf()))
  {
  }
  ~Printed() { std::cerr.rdbuf(this->Before); }
  Printed(const Printed&) = delete;
  void operator=(const Printed&) = delete;

  // The messages so far, without file and line number.
  std::string Get() const
  {
    std::string text;
    std::istringstream stream(this->Stream.str());
    for (std::string line; std::getline(stream, line);)
    {
      const std::string file = "TestChecks.cxx:";
      const std::size_t start = line.find(' ', line.find(file) + file.size());
      text += line.substr(start + 1) + "\n";
    }
    return text;
  }

private:
  std::ostringstream Stream;
  std::streambuf* Before;
};

bool IsSame(const std::string& printed, const std::string& expected)
{
  if (printed != expected)
  {
    std::cerr << "failed checks print\n" << printed << "but should print\n" << expected;
  }
  return printed == expected;
}

void FailNumbers(RelevoCheck& check)
{
  const int cells = 3;
  const std::size_t points = 5;
  CHECK(cells == 4);
  CHECK_EQUAL(cells, 4);
  CHECK_NOT_EQUAL(points, 5);
  CHECK_LESS(points, cells);
  CHECK_LESS_EQUAL(4, cells);
  CHECK_GREATER(0.1, 1e300);
  CHECK_GREATER_EQUAL(1.0, 1.0 + 1e-15);
  CHECK_NEAR(1e-9, 3e-9, 1e-10);
  CHECK_EQUAL(cells == 3, false);
  CHECK_EQUAL(-1, 4294967295.5);
}

void FailOthers(RelevoCheck& check)
{
  const std::string name = "torus";
  const std::vector<int> many(20, 7);
  const std::array<double, 2> pair = { { 0.5, 1.0 } };
  const int* const nothing = nullptr;
  CHECK_EQUAL(name, "cube");
  CHECK_EQUAL(many, std::vector<int>());
  CHECK_EQUAL(pair[0], pair[1]);
  CHECK_NOT_EQUAL(nothing, nullptr);
  CHECK_EQUAL(Color::Red, Color::Green);
  CHECK_EQUAL(Unprintable{ 1 }, Unprintable{ 2 });
}

void FailCases(RelevoCheck& check)
{
  const std::string mesh = "torus";
  CHECK_CASE(mesh);
  for (int level : { 2, 4 })
  {
    CHECK_CASE(level);
    CHECK_EQUAL(level, 4);
  }
  CHECK(1 > 3);
}

bool HasResult(void (*test)(RelevoCheck&), const std::string& expected)
{
  RelevoCheck check;
  std::string text;
  {
    Printed printed;
    test(check);
    text = printed.Get();
  }
  return IsSame(text, expected) && check.GetResult() == EXIT_FAILURE;
}

bool TestNumbers()
{
  return HasResult(FailNumbers,
    "failed: cells == 4\n"
    "failed: cells == 4 (3 == 4)\n"
    "failed: points != 5 (5 != 5)\n"
    "failed: points < cells (5 < 3)\n"
    "failed: 4 <= cells (4 <= 3)\n"
    "failed: 0.1 > 1e300 (0.1 > 1e+300)\n"
    "failed: 1.0 >= 1.0 + 1e-15 (1 >= 1.000000000000001)\n"
    "1e-9 is 1e-09, not 3e-09 +- 1e-10\n"
    "failed: cells == 3 == false (true == false)\n"
    "failed: -1 == 4294967295.5 (-1 == 4294967295.5)\n");
}

bool TestOthers()
{
  return HasResult(FailOthers,
    "failed: name == \"cube\" (\"torus\" == \"cube\")\n"
    "failed: many == std::vector<int>() ([7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, "
    "... of 20] == [])\n"
    "failed: pair[0] == pair[1] (0.5 == 1)\n"
    "failed: nothing != nullptr (a null pointer != a null pointer)\n"
    "failed: Color::Red == Color::Green (3 == 4)\n"
    "failed: Unprintable{ 1 } == Unprintable{ 2 } (? == ?)\n");
}

bool TestCases()
{
  return HasResult(FailCases,
    "[mesh \"torus\", level 2] failed: level == 4 (2 == 4)\n"
    "[mesh \"torus\"] failed: 1 > 3\n");
}

// Returns a pointer to a buffer that each call overwrites, like vtkPoints::GetPoint().
const double* GetShared(int value)
{
  static double buffer[1];
  buffer[0] = value;
  return buffer;
}

// A check that passes prints nothing.
bool TestRight()
{
  RelevoCheck check;
  std::string text;
  {
    Printed printed;
    CHECK_EQUAL(2, 2u);
    CHECK_LESS(-1, 0.5);
    CHECK_LESS(GetShared(1)[0], GetShared(2)[0]);
    CHECK_NEAR(1.0, 1.1, 0.2);
    text = printed.Get();
  }
  return IsSame(text, "") && check.GetResult() == EXIT_SUCCESS;
}
}

int TestChecks(int, char*[])
{
  const bool numbers = TestNumbers();
  const bool others = TestOthers();
  const bool cases = TestCases();
  const bool right = TestRight();
  return numbers && others && cases && right ? EXIT_SUCCESS : EXIT_FAILURE;
}
