// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionCopy.h"

#include "Options/ViewerOptions.h"

#include <algorithm>
#include <map>

namespace
{
using Copy = void (*)(const ViewerOptions& from, ViewerOptions& to);

template <auto Member>
void CopyMember(const ViewerOptions& from, ViewerOptions& to)
{
  to.*Member = from.*Member;
}

void CopyCenter(const ViewerOptions& from, ViewerOptions& to)
{
  to.Center = from.Center;
  to.CenterDegrees = from.CenterDegrees;
}

void CopyRange(const ViewerOptions& from, ViewerOptions& to)
{
  to.Range = from.Range;
  to.HasRangeOfAllSteps = from.HasRangeOfAllSteps;
}

const std::map<std::string, Copy>& GetCopies()
{
  using Options = ViewerOptions;
  static const std::map<std::string, Copy> copies = {
    { "--above", CopyMember<&Options::AboveColor> },
    { "--alpha", CopyMember<&Options::Alpha> },
    { "--amplitude", CopyMember<&Options::Amplitude> },
    { "--below", CopyMember<&Options::BelowColor> },
    { "--blend", CopyMember<&Options::BlendMode> },
    { "--budget", CopyMember<&Options::Budget> },
    { "--center", CopyCenter },
    { "--clip", CopyMember<&Options::Clip> },
    { "--contours", CopyMember<&Options::Contours> },
    { "--error", CopyMember<&Options::Error> },
    { "--extremes", CopyMember<&Options::HasExtremes> },
    { "--field-tolerance", CopyMember<&Options::FieldTolerance> },
    { "--frequency", CopyMember<&Options::Frequency> },
    { "--integration", CopyMember<&Options::Integration> },
    { "--isosurfaces", CopyMember<&Options::IsoSurfaces> },
    { "--level", CopyMember<&Options::UniformLevel> },
    { "--lic-contrast", CopyMember<&Options::LICContrast> },
    { "--lic-intensity", CopyMember<&Options::LICIntensity> },
    { "--lic-mode", CopyMember<&Options::LICMode> },
    { "--lic-phase", CopyMember<&Options::LICPhase> },
    { "--lic-step-size", CopyMember<&Options::LICStepSize> },
    { "--lic-steps", CopyMember<&Options::LICSteps> },
    { "--light", CopyMember<&Options::Light> },
    { "--max-level", CopyMember<&Options::MaximumLevel> },
    { "--method", CopyMember<&Options::Method> },
    { "--metric", CopyMember<&Options::Metric> },
    { "--no-geomorphing", CopyMember<&Options::Geomorphing> },
    { "--offset", CopyMember<&Options::Offset> },
    { "--palette", CopyMember<&Options::Palette> },
    { "--per-edge", CopyMember<&Options::PerEdge> },
    { "--pixels", CopyMember<&Options::Pixels> },
    { "--range", CopyRange },
    { "--reach", CopyMember<&Options::Reach> },
    { "--region", CopyMember<&Options::Region> },
    { "--scale", CopyMember<&Options::Scale> },
    { "--segments", CopyMember<&Options::WholeSegments> },
    { "--shape-tolerance", CopyMember<&Options::ShapeTolerance> },
    { "--time", CopyMember<&Options::Time> },
    { "--transfer", CopyMember<&Options::Transfer> },
    { "--unit-distance", CopyMember<&Options::UnitDistance> },
    { "--view", CopyMember<&Options::View> },
    { "--volume-method", CopyMember<&Options::VolumeMethod> },
    { "--wireframe", CopyMember<&Options::Wireframe> },
    { "--zoom", CopyMember<&Options::Zoom> },
  };
  return copies;
}
}

//------------------------------------------------------------------------------
void CopyOptions(const ViewerOptions& from, const OptionNames& names, ViewerOptions& to)
{
  for (const std::string& name : names)
  {
    const auto copy = GetCopies().find(name);
    if (copy != GetCopies().end())
    {
      copy->second(from, to);
    }
  }
}
