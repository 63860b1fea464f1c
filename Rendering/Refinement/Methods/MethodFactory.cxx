// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Methods/MethodFactory.h"

#include "Methods/ARKFPIMethod.h"
#include "Methods/ARKMethod.h"
#include "Methods/DMRMethod.h"
#include "Methods/HardwareTessellation.h"
#include "Methods/SUAPTMethod.h"
#include "Methods/UniformMethod.h"

namespace relevo
{
std::unique_ptr<RefinementMethod> NewMethod(int method)
{
  switch (method)
  {
    case RefinementMethod::ARK:
      return std::unique_ptr<RefinementMethod>(new ARKMethod);
    case RefinementMethod::DMR:
      return std::unique_ptr<RefinementMethod>(new DMRMethod);
    case RefinementMethod::SUAPT:
      return std::unique_ptr<RefinementMethod>(new SUAPTMethod);
    case RefinementMethod::HARDWARE_TESSELLATION:
      return std::unique_ptr<RefinementMethod>(new HardwareTessellation);
    case RefinementMethod::UNIFORM:
      return std::unique_ptr<RefinementMethod>(new UniformMethod);
    default:
      return std::unique_ptr<RefinementMethod>(new ARKFPIMethod);
  }
}
}
