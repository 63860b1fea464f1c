// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeProgram
 * @brief   a compute shader with its buffers and uniforms
 *
 * VTK before 9.4 does not support compute shaders. Needs a current context with OpenGL 4.3. Run the
 * program between Begin() and End(), which restore the state that VTK assumes. Private to the
 * module and its tests.
 */
#ifndef RefinementComputeProgram_h
#define RefinementComputeProgram_h

#include "RelevoRenderingRefinementModule.h" // for export macro
#include <initializer_list>                  // for buffers
#include <string>                            // for members

class vtkOpenGLRenderWindow;

namespace relevo
{
class RELEVORENDERINGREFINEMENT_EXPORT RefinementComputeProgram
{
public:
  RefinementComputeProgram() = default;
  RefinementComputeProgram(const RefinementComputeProgram&) = delete;
  void operator=(const RefinementComputeProgram&) = delete;

  /// The number of invocations per work group, the same as in relevoComputeCS.glsl.
  static constexpr int GroupSize = 256;

  /// Return whether the current context supports OpenGL 4.3, and VTK's loader its functions.
  static bool IsSupported();

  /**
   * Compile and link `source`, preceded by relevoComputeCS.glsl, unless it was built last. Return
   * false and set GetError() if OpenGL does not accept it.
   */
  bool Build(const std::string& source);
  bool IsBuilt() const { return this->Handle != 0; }
  const std::string& GetError() const { return this->Error; }

  /// Release VTK's current program.
  static void Begin(vtkOpenGLRenderWindow* window);
  /// Unbind the buffers and the program.
  static void End();

  /// Make the program current, with the buffers of these names at bindings 0, 1, ...
  void Use(std::initializer_list<unsigned int> buffers);

  //@{
  /**
   * Set a uniform of the current program; unknown names are ignored.
   */
  void SetUniform(const char* name, int value);
  void SetUniform(const char* name, float value);
  void SetUniform(const char* name, const float* values, int components, int count = 1);
  //@}

  /// Run once per element, and make the results visible to subsequent programs.
  void Dispatch(int elements);
  /// Do the same with one work group.
  void DispatchGroup();

  void ReleaseGraphicsResources();

private:
  int GetLocation(const char* name) const;

  unsigned int Handle = 0;
  std::string Source;
  std::string Error;
};
}

#endif
