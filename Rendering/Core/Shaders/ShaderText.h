// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   ShaderText
 * @brief   edits the source of a shader at anchors that VTK's source must contain
 *
 * An anchor is a piece of text: a tag of VTK's templates ("//VTK::Light::Impl") or a piece of GLSL.
 * If an anchor is not found, the source does not change and the anchor is recorded, because VTK's
 * templates differ from release to release, and an incomplete shader must not draw. The methods
 * If...() accept a missing anchor. Private to the modules and their tests.
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
/// The missing anchors of shaders, each with its stage, for example: vertex shader: "void main(".
using MissingAnchors = std::set<std::string>;

class RELEVORENDERINGCORE_EXPORT ShaderText
{
public:
  /**
   * Take the source of a shader. The destructor writes it back. Anchors that are not found are
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
   * Replace all occurrences of an anchor by a text, or insert a text before or after its first
   * occurrence.
   */
  void Replace(const std::string& anchor, const std::string& text);
  void InsertBefore(const std::string& anchor, const std::string& text);
  void InsertAfter(const std::string& anchor, const std::string& text);
  //@}

  //@{
  /**
   * Do the same with an anchor that may be missing.
   */
  void IfReplace(const std::string& anchor, const std::string& text);
  void IfInsertAfter(const std::string& anchor, const std::string& text);
  //@}

  //@{
  /**
   * Insert a text after the version (VTK's tag or the user's directive), before the first main(),
   * at the start of its body, or at its end.
   */
  void InsertAfterVersion(const std::string& text);
  void InsertBeforeMain(const std::string& text);
  void InsertAtStart(const std::string& text);
  void InsertAtEnd(const std::string& text);
  //@}

  /// Record that an anchor was not found.
  void Miss(const std::string& anchor);

private:
  /// Return the position of an anchor. If it is missing, record it and return npos.
  size_t Find(const std::string& anchor);
  /// Return the position of the opening brace of main().
  size_t FindBody();

  vtkShader* Shader;
  MissingAnchors& Missing;
  std::string Text;
};

/**
 * Insert a text that changes the colours which VTK has computed for a fragment. If an actor's own
 * source replaces VTK's, that source sets the colours, and missing anchors are accepted.
 */
RELEVORENDERINGCORE_EXPORT void InsertColors(
  ShaderText& fragment, bool ownFragments, const std::string& text);

/// Return a text for InsertColors() that draws the material with a colour, an expression of type
/// vec4.
RELEVORENDERINGCORE_EXPORT std::string MakeMaterialColor(const std::string& color);

/**
 * Turn VTK's attributes of a vertex into variables, which a function sets that runs at the start of
 * main(). Vertices for which that function sets relevoHidden are not drawn. Return whether the
 * shader has a normal.
 */
RELEVORENDERINGCORE_EXPORT bool ComputeVertexAttributes(
  ShaderText& vertex, const std::string& function);

/// Return a definition for contexts that do not support `precise`, for the start of a shader.
RELEVORENDERINGCORE_EXPORT const char* GetPreciseExtension();

/// Return an error message that lists the anchors that this release of VTK lacks, and a remedy.
RELEVORENDERINGCORE_EXPORT std::string DescribeMissing(const MissingAnchors& missing);

/// Replace shaders by ones that compile and discard all pixels.
RELEVORENDERINGCORE_EXPORT void DrawNothing(std::map<vtkShader::Type, vtkShader*>& shaders);
}

#endif
