// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Imagery/OpenImagery.h"

#if RELEVO_HAS_GDAL
#include "Imagery/WarpedImagery.h"
#endif

namespace relevo
{
std::shared_ptr<const ImageryLattice> OpenImagery(const std::string& fileName,
  const RasterDescription& terrain, std::string& warning, std::string& error)
{
  warning.clear();
#if RELEVO_HAS_GDAL
  return WarpedImagery::Open(fileName, terrain, warning, error);
#else
  static_cast<void>(fileName);
  static_cast<void>(terrain);
  error = "this build of Relevo does not have GDAL. Install libgdal-dev and build again";
  return nullptr;
#endif
}
}
