// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MethodStage
 * @brief   the methods that a mapper has drawn with, and the one of this frame
 *
 * Where the method that the user has set is not available, METHOD_ARKFPI draws. Private to the
 * module.
 */
#ifndef MethodStage_h
#define MethodStage_h

#include "Methods/RefinementMethod.h" // for members
#include "Stages/StageResult.h"

#include <map>    // for members
#include <memory> // for members
#include <string> // for members
#include <vector> // for numbers

namespace relevo
{
class MethodStage
{
public:
  using Primitives = RefinementMethod::Primitives;

  MethodStage();
  ~MethodStage();
  MethodStage(const MethodStage&) = delete;
  void operator=(const MethodStage&) = delete;

  struct Input
  {
    /// The one that the user has set, a RefinementMethod::Methods.
    int Method;
    const PatternFamily* Family;
    /// Whether its shaders could not be built.
    bool HasFailedShaders;
    /// The primitives that faces are drawn as, and whether their vertices are drawn, too.
    Primitives Faces;
    bool HasVertices;
  };

  /// Choose the method of this frame.
  StageResult Choose(const Input& input);

  /// The method of this frame, and its number.
  RefinementMethod& Get();
  int GetNumber() const { return this->InUse; }
  bool IsDefault() const { return this->InUse == RefinementMethod::ARKFPI; }

  /// The rest of this frame is drawn by METHOD_ARKFPI.
  void FallBackToDefaultMethod() { this->InUse = RefinementMethod::ARKFPI; }

  /// The error message: why the method that the user has set is not available.
  std::string DescribeUnavailable(const std::string& error) const;

  /// Release the buffers of methods that are not in use. Returns their numbers.
  std::vector<int> ReleaseUnused(vtkWindow* window);

  /// Report a problem again.
  void ForgetError() { this->Error.clear(); }

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::map<int, std::unique_ptr<RefinementMethod>> Methods;
  int Wanted = RefinementMethod::ARKFPI;
  int InUse = RefinementMethod::ARKFPI;
  std::string Error; // that was reported last
};
}

#endif
