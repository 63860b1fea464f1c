// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeProgram
 * @brief   a compute shader: built, given its buffers and uniforms, and run
 *
 * VTK before 9.4 has no compute stage. Needs a current context with OpenGL 4.3. Run it between
 * Begin() and End(), which leave OpenGL as VTK believes it to be. Private to the module and
 * its tests.
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

  /// Invocations of a work group; relevoComputeCS.glsl repeats it.
  static constexpr int GroupSize = 256;

  /// Whether the current context has OpenGL 4.3, and VTK's loader its functions.
  static bool IsSupported();

  /**
   * Compile and link `source`, preceded by relevoComputeCS.glsl, unless it is what was built last.
   * False, with GetError(), when OpenGL does not accept it.
   */
  bool Build(const std::string& source);
  bool IsBuilt() const { return this->Handle != 0; }
  const std::string& GetError() const { return this->Error; }

  /// Take VTK's program out of use.
  static void Begin(vtkOpenGLRenderWindow* window);
  /// Unbind what programs have used.
  static void End();

  /// Make current, with the buffers of these names at bindings 0, 1, ...
  void Use(std::initializer_list<unsigned int> buffers);

  //@{
  /**
   * Set a uniform of the program in use; one that it does not have is ignored.
   */
  void SetUniform(const char* name, int value);
  void SetUniform(const char* name, float value);
  void SetUniform(const char* name, const float* values, int components, int count = 1);
  //@}

  /// Run once for each of that many elements, then have its results seen by programs after it.
  void Dispatch(int elements);
  /// The same with one work group.
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
