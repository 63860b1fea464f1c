// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that ShaderText finds the end of main() in every text.
#include "RelevoCheck.h"

#include "Shaders/ShaderText.h"

namespace
{
std::string InsertAtEnd(const std::string& text, relevo::MissingAnchors& missing)
{
  vtkNew<vtkShader> shader;
  shader->SetType(vtkShader::Vertex);
  shader->SetSource(text);
  {
    relevo::ShaderText changed(shader, missing);
    changed.InsertAtEnd("END;");
  }
  return shader->GetSource();
}
}

int TestShaderText(int, char*[])
{
  RelevoCheck check;
  const std::string before = "void f()\n{\n}\n";
  const std::string after = "\nvoid g()\n{\n  if (true) { h(); }\n}\n";
  for (const std::string body : { "  a;", "  if (a) { b; }\n  { { } }",
         "  // }\n  a / b; /* } { */", "#ifdef A // {\n  a;\n#endif" })
  {
    CHECK_CASE(body);
    const std::string main = before + "void main()\n{\n" + body + "\n";
    relevo::MissingAnchors missing;
    CHECK_EQUAL(InsertAtEnd(main + "}" + after, missing), main + "\nEND;}" + after);
    CHECK(missing.empty());
  }
  for (const std::string text :
    { "void main()\n{\n  if (a) { b; }\n", "void main()\n{\n  // }", "void main()\n{\n  /* }" })
  {
    CHECK_CASE(text);
    relevo::MissingAnchors missing;
    CHECK_EQUAL(InsertAtEnd(text, missing), text);
    CHECK_EQUAL(missing.count("vertex shader: \"}\""), 1);
  }
  return check.GetResult();
}
