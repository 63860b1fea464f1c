// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Imagery/OpenImagery.h"

#if RELEVO_HAS_GDAL
#include "Imagery/WarpedImagery.h"
#endif

namespace relevo
{
std::shared_ptr<const ImageryLattice> OpenImagery(const ImageryOptions& options,
  const RasterDescription& terrain, std::string& warning, std::string& error)
{
  warning.clear();
#if RELEVO_HAS_GDAL
  return WarpedImagery::Open(options, terrain, warning, error);
#else
  static_cast<void>(options);
  static_cast<void>(terrain);
  error = "this build of Relevo does not have GDAL. Install libgdal-dev and build again";
  return nullptr;
#endif
}
}
