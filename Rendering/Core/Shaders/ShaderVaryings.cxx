// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/ShaderVaryings.h"

#include "Shaders/ShaderText.h"

namespace relevo
{
std::string DeclareVaryings(const char* direction, const std::vector<ShaderVarying>& varyings)
{
  std::string text;
  for (const ShaderVarying& varying : varyings)
  {
    text += varying.Qualifier + direction + " " + varying.Type + " " + varying.Name + "VSOutput;\n";
  }
  return text;
}

void PassOnVaryings(const std::vector<ShaderVarying>& varyings, ShaderText& geometry)
{
  std::string declarations;
  std::string copies;
  for (const ShaderVarying& varying : varyings)
  {
    const std::string& name = varying.Name;
    declarations += varying.Qualifier + "in " + varying.Type + " " + name + "VSOutput[];\n" +
      varying.Qualifier + "out " + varying.Type + " " + name + "GSOutput;\n";
    copies += name + "GSOutput = " + name + "VSOutput[i];\n    ";
  }
  geometry.InsertBeforeMain(declarations);
  geometry.Replace("EmitVertex();", copies + "EmitVertex();");
}
}
