// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that relevo::Dependencies detects a change of every kind of value, and reports each change
// once.
#include "RelevoCheck.h"

#include "Changes/Dependencies.h"
#include "vtkCamera.h"
#include "vtkNew.h"

#include <limits>
#include <map>

namespace
{
using relevo::Dependencies;

Dependencies OnObject(vtkObject* object)
{
  Dependencies dependencies;
  dependencies.AddObject(object);
  return dependencies;
}

void TestValues(RelevoCheck& check)
{
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK_EQUAL(Dependencies::On(1, 2.0, true), Dependencies::On(1, 2.0, true));
  CHECK_NOT_EQUAL(Dependencies::On(1, 2), Dependencies::On(2, 1));
  CHECK_NOT_EQUAL(Dependencies::On(1), Dependencies::On(1, 0));
  CHECK_NOT_EQUAL(Dependencies::On(0.0), Dependencies::On(least));
  CHECK_EQUAL(Dependencies::On(1.0), Dependencies::On(1.0f));
  CHECK_NOT_EQUAL(Dependencies::On(true), Dependencies::On(false));
  CHECK_NOT_EQUAL(Dependencies(), Dependencies::On(0));
  vtkTimeStamp time;
  time.Modified();
  CHECK_EQUAL(Dependencies::On(time), Dependencies::On(time.GetMTime()));
}

void TestTexts(RelevoCheck& check)
{
  const std::string texts[] = { "", "a", "b", "seven ch", "eight chars and more",
    "eight chars and mora", std::string(1, '\0'), std::string(9, '\0') };
  for (const std::string& a : texts)
  {
    for (const std::string& b : texts)
    {
      CHECK_EQUAL((Dependencies::On(a) == Dependencies::On(b)), (a == b));
    }
  }
  CHECK_NOT_EQUAL(Dependencies::On(std::string("a"), std::string("b")),
    Dependencies::On(std::string("ab"), std::string()));
}

void TestObjects(RelevoCheck& check)
{
  vtkNew<vtkCamera> first;
  vtkNew<vtkCamera> second;
  const Dependencies before = OnObject(first);
  CHECK_EQUAL(before, OnObject(first));
  CHECK(before != OnObject(second) && before != OnObject(nullptr));
  first->Modified();
  CHECK_NOT_EQUAL(before, OnObject(first));
}

void TestUpdate(RelevoCheck& check)
{
  Dependencies kept;
  CHECK(kept.IsEmpty());
  CHECK(!kept.Update({}));
  CHECK(kept.Update(Dependencies::On(1)) && !kept.IsEmpty());
  CHECK(!kept.Update(Dependencies::On(1)));
  CHECK(kept.Update(Dependencies::On(2)));
  CHECK(!kept.Update(Dependencies::On(2)));
  kept.Clear();
  CHECK(kept.Update(Dependencies::On(2)));
  std::map<Dependencies, int> known;
  known[Dependencies::On(1)] = 1;
  known[Dependencies::On(1, 1)] = 2;
  CHECK_EQUAL(known.at(Dependencies::On(1)), 1);
  CHECK_EQUAL(known.count(Dependencies::On(2)), 0);
}
}

int TestDependencies(int, char*[])
{
  RelevoCheck check;
  TestValues(check);
  TestTexts(check);
  TestObjects(check);
  TestUpdate(check);
  return check.GetResult();
}
