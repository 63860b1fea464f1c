// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   MethodStage
 * @brief   the methods that a mapper has used, and the one for the current frame
 *
 * If the method that the user has set is not available, METHOD_ARKFPI draws. Private to the module.
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
    /// The method that the user has set, one of RefinementMethod::Methods.
    int Method;
    const PatternFamily* Family;
    /// Whether the shaders of the method could not be built.
    bool HasFailedShaders;
    /// The primitives of faces, and whether their vertices are drawn, too.
    Primitives Faces;
    bool HasVertices;
  };

  /// Choose the method for this frame.
  StageResult Choose(const Input& input);

  /// Return the method for this frame, and its number.
  RefinementMethod& Get();
  int GetNumber() const { return this->InUse; }
  bool IsDefault() const { return this->InUse == RefinementMethod::ARKFPI; }

  /// Draw the rest of this frame with METHOD_ARKFPI.
  void FallBackToDefaultMethod() { this->InUse = RefinementMethod::ARKFPI; }

  /// Return the error message for a method that is not available.
  std::string DescribeUnavailable(const std::string& error) const;

  /// Release the buffers of methods that are not in use, and return their numbers.
  std::vector<int> ReleaseUnused(vtkWindow* window);

  /// Forget the reported error, so that it is reported again.
  void ForgetError() { this->Error.clear(); }

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::map<int, std::unique_ptr<RefinementMethod>> Methods;
  int Wanted = RefinementMethod::ARKFPI;
  int InUse = RefinementMethod::ARKFPI;
  std::string Error; // error that was reported last
};
}

#endif
