// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ShaderText
 * @brief   the text of one shader while it is changed, at places that VTK's text must have
 *
 * A place is named by an anchor, text that stands there: a mark of VTK's templates
 * ("//VTK::Light::Impl") or a piece of GLSL. An anchor that is not found is remembered, and nothing
 * changes: VTK's templates differ from release to release, and a shader that lacks what it should
 * have got must not draw. Where an anchor may be absent, If...() is called. Private to the modules
 * and their tests.
 */
#ifndef ShaderText_h
#define ShaderText_h

#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkShader.h"                 // for vtkShader::Type

#include <map>    // for signature
#include <set>    // for MissingAnchors
#include <string> // for text

namespace relevo
{
/// Anchors that shaders lack, each with its stage, as in: vertex shader: "void main(".
using MissingAnchors = std::set<std::string>;

class RELEVORENDERINGCORE_EXPORT ShaderText
{
public:
  /**
   * The text of a shader, which takes it back when this object goes. Anchors that are not found are
   * added to `missing`.
   */
  ShaderText(vtkShader* shader, MissingAnchors& missing);
  ~ShaderText();
  ShaderText(const ShaderText&) = delete;
  void operator=(const ShaderText&) = delete;

  const std::string& Get() const { return this->Text; }
  void Set(const std::string& text) { this->Text = text; }
  bool IsEmpty() const { return this->Text.empty(); }
  bool Has(const std::string& anchor) const;

  //@{
  /**
   * Put text in place of an anchor wherever it stands, or before or after the first.
   */
  void Replace(const std::string& anchor, const std::string& text);
  void InsertBefore(const std::string& anchor, const std::string& text);
  void InsertAfter(const std::string& anchor, const std::string& text);
  //@}

  //@{
  /**
   * The same with an anchor that may be absent.
   */
  void IfReplace(const std::string& anchor, const std::string& text);
  void IfInsertAfter(const std::string& anchor, const std::string& text);
  //@}

  //@{
  /**
   * Put text after the version, which is VTK's mark or a directive of the user's; before the first
   * main(); where its body starts; and where it ends.
   */
  void InsertAfterVersion(const std::string& text);
  void InsertBeforeMain(const std::string& text);
  void InsertAtStart(const std::string& text);
  void InsertAtEnd(const std::string& text);
  //@}

  /// Remember that an anchor was not found.
  void Miss(const std::string& anchor);

private:
  /// Where an anchor starts; npos, and it is remembered, if it is not there.
  size_t Find(const std::string& anchor);
  /// Where the brace that opens the body of main() stands.
  size_t FindBody();

  vtkShader* Shader;
  MissingAnchors& Missing;
  std::string Text;
};

/**
 * Insert text that changes the colours which VTK has given a fragment. An actor's own text may
 * replace VTK's: then it decides on colours, and nothing is missed.
 */
RELEVORENDERINGCORE_EXPORT void InsertColors(
  ShaderText& fragment, bool ownFragments, const std::string& text);

/// Declares what has no `precise`, for the start of a shader.
RELEVORENDERINGCORE_EXPORT const char* GetPreciseExtension();

/// An error message: which anchors this release of VTK lacks, and what to do.
RELEVORENDERINGCORE_EXPORT std::string DescribeMissing(const MissingAnchors& missing);

/// Have shaders compile and leave no pixel.
RELEVORENDERINGCORE_EXPORT void DrawNothing(std::map<vtkShader::Type, vtkShader*>& shaders);
}

#endif
