// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Random calls of the public API on random meshes, valid and hostile. A test makes a fixed number
// of runs. RELEVO_FUZZ_RUNS sets another number, RELEVO_FUZZ_FIRST the first seed, and
// RELEVO_FUZZ_VERBOSE prints the calls, so that the last one printed is the one that crashed. In
// Testing/Fuzz, libFuzzer chooses the calls.
#ifndef RelevoFuzz_h
#define RelevoFuzz_h

#include "RelevoSanitizer.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#ifdef __unix__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace RelevoFuzz
{
class Dice
{
public:
  explicit Dice(unsigned int seed);
  // Throws what the bytes of a fuzz target say, and random numbers after their end.
  Dice(const unsigned char* bytes, size_t size);
  // Returns 0 to sides - 1.
  int Throw(int sides)
  {
    return static_cast<int>(this->Draw(sides <= 256 ? 1 : 4) % static_cast<unsigned>(sides));
  }
  bool Once(int in) { return this->Throw(in) == 0; }
  double Share() { return this->Draw(4) / 4294967296.0; }
  bool HasBytes() const { return this->Bytes != this->End; }
  // Returns the remaining bytes.
  std::string TakeBytes();
  template <typename T>
  const T& Choose(const std::vector<T>& from)
  {
    return from[static_cast<size_t>(this->Throw(static_cast<int>(from.size())))];
  }
  // Mostly a number of ordinary size, sometimes an extreme one.
  double Number();
  int Whole() { return this->Once(6) ? this->Choose(Whole_) : this->Throw(6) - 1; }

private:
  unsigned int Draw(int bytes);

  std::mt19937 Random;
  const unsigned char* Bytes = nullptr;
  const unsigned char* End = nullptr;
  const std::vector<int> Whole_ = { -7, 100, 1000000, std::numeric_limits<int>::max(),
    std::numeric_limits<int>::lowest() };
};

// Moves the values to the end of a memory page that is followed by an inaccessible one. Reading
// past the end crashes, with or without a sanitizer.
template <typename Array>
void Fence(Array* array, size_t bytes)
{
#ifdef __unix__
  if (bytes == 0)
  {
    return;
  }
  static std::map<void*, std::pair<char*, size_t>> pages;
  const size_t page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  const size_t used = (bytes + page - 1) / page * page;
  void* first =
    mmap(nullptr, used + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (first == MAP_FAILED)
  {
    return;
  }
  char* begin = static_cast<char*>(first);
  mprotect(begin + used, page, PROT_NONE);
  void* values = begin + used - bytes;
  std::memcpy(values, array->GetVoidPointer(0), bytes);
  pages[values] = { begin, used + page };
  array->SetVoidArray(values, array->GetNumberOfValues(), 0);
  array->SetArrayFreeFunction(
    [](void* freed)
    {
      munmap(pages[freed].first, pages[freed].second);
      pages.erase(freed);
    });
#endif
}

void Fence(vtkDataArray* array);

vtkSmartPointer<vtkAbstractArray> MakeArray(Dice& dice, vtkIdType size);

void AddArrays(Dice& dice, vtkDataSetAttributes* data, vtkIdType size);

// The name of an array that a mesh may have.
std::string ChooseName(Dice& dice);

vtkSmartPointer<vtkCellArray> MakeCells(
  Dice& dice, int most, int longest, vtkIdType numberOfPoints, bool dangling);

// Duplicate and non-finite points, polygons of 0 to 8 points, strips, lines, vertices, arrays of
// every type and length, and sometimes cells with invalid point ids.
vtkSmartPointer<vtkPolyData> MakeMesh(Dice& dice);

// Whether all points of polygons are finite.
bool IsFinite(vtkPolyData* mesh);

struct Call
{
  std::string Name;
  std::function<void()> Make;
};

int GetNumber(const char* variable, int otherwise);

// A run creates a Machine(dice) and makes the calls listed by its GetCalls() in random order.
template <typename Machine>
int Run(int runs, int callsPerRun, int& made)
{
  const int first = GetNumber("RELEVO_FUZZ_FIRST", 0);
  const bool isVerbose = GetNumber("RELEVO_FUZZ_VERBOSE", 0) != 0;
  constexpr int share = RelevoHasAddressSanitizer ? 3 : 1;
  runs = GetNumber("RELEVO_FUZZ_RUNS", runs / share);
  vtkObject::GlobalWarningDisplayOff();
  int failures = 0;
  for (int seed = first; seed < first + runs; ++seed)
  {
    Dice dice(static_cast<unsigned int>(seed));
    Machine machine(dice);
    const std::vector<Call> calls = machine.GetCalls();
    for (int i = 0; i < callsPerRun; ++i)
    {
      const Call& call = dice.Choose(calls);
      if (isVerbose)
      {
        std::cerr << seed << ": " << call.Name << std::endl;
      }
      call.Make();
      ++made;
      const std::string error = machine.FindError();
      if (!error.empty())
      {
        std::cerr << "seed " << seed << ", call " << i << ", " << call.Name << ": " << error
                  << "\n";
        ++failures;
        break;
      }
    }
  }
  vtkObject::GlobalWarningDisplayOn();
  return failures;
}

// Makes the calls that the bytes of a fuzz target choose. Aborts after an error.
template <typename Machine>
void RunBytes(const unsigned char* bytes, size_t size)
{
  constexpr int mostCalls = 60;
  vtkObject::GlobalWarningDisplayOff();
  Dice dice(bytes, size);
  Machine machine(dice);
  const std::vector<Call> calls = machine.GetCalls();
  for (int i = 0; i < mostCalls && dice.HasBytes(); ++i)
  {
    const Call& call = dice.Choose(calls);
    call.Make();
    const std::string error = machine.FindError();
    if (!error.empty())
    {
      std::cerr << "call " << i << ", " << call.Name << ": " << error << std::endl;
      std::abort();
    }
  }
}
}

// In Testing/Fuzz, defines libFuzzer's entry point, so that a file is both a test and a fuzz
// target.
#ifdef RELEVO_LIBFUZZER
#define RELEVO_FUZZ_TARGET(Machine)                                              \
  extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size) \
  {                                                                              \
    RelevoFuzz::RunBytes<Machine>(bytes, size);                                  \
    return 0;                                                                    \
  }
#else
#define RELEVO_FUZZ_TARGET(Machine)
#endif

#endif
