// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/ViewerLegend.h"

#include "vtkScalarBarActor.h"
#include "vtkScalarsToColors.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// Neighbouring labels differ by two digits at least; thousands and hundredths are written out.
std::string GetLabelFormat(const double range[2], int numberOfLabels)
{
  const double largest = std::max(std::abs(range[0]), std::abs(range[1]));
  const double step = (range[1] - range[0]) / (numberOfLabels - 1);
  if (!(step >= 1e-4 && largest < 1e6))
  {
    return "%.3g";
  }
  const int decimals = static_cast<int>(std::max(std::ceil(1.0 - std::log10(step)), 0.0));
  return "%." + std::to_string(decimals) + "f";
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkScalarBarActor> MakeLegend(
  vtkScalarsToColors* table, const std::string& title, int numberOfLabels, const int size[2])
{
  const int rowHeight = 20;      // pixels
  const double narrowest = 80.0; // pixels, for words
  const int rows =
    table->GetIndexedLookup() ? static_cast<int>(table->GetNumberOfAnnotatedValues()) : 10;
  const double share = static_cast<double>(rowHeight) * (rows + 2) / size[1];
  if (share > 0.90)
  {
    return nullptr;
  }
  auto legend = vtkSmartPointer<vtkScalarBarActor>::New();
  legend->SetLookupTable(table);
  legend->SetTitle(title.c_str());
  legend->SetNumberOfLabels(numberOfLabels);
  legend->SetLabelFormat(GetLabelFormat(table->GetRange(), numberOfLabels).c_str());
  if (table->GetIndexedLookup())
  {
    legend->SetTextPositionToPrecedeScalarBar(); // which puts annotations on the other side
  }
  legend->SetVerticalTitleSeparation(8);
  legend->SetAnnotationLeaderPadding(6);
  legend->UnconstrainedFontSizeOn();
  legend->SetBarRatio(0.25);
  // What stands beside an indexed table's colours makes its own room.
  legend->SetWidth(table->GetIndexedLookup() ? 0.08 : std::max(0.08, narrowest / size[0]));
  legend->SetHeight(share);
  // The title of a continuous bar stands above it.
  const double headroom =
    table->GetIndexedLookup() ? 0.0 : static_cast<double>(rowHeight) / size[1];
  legend->SetPosition(0.015, 0.98 - headroom - share);
  for (vtkTextProperty* text : { legend->GetTitleTextProperty(), legend->GetLabelTextProperty(),
         legend->GetAnnotationTextProperty() })
  {
    text->SetColor(0.1, 0.1, 0.1);
    text->SetFontSize(14);
    text->ShadowOff();
    text->BoldOff();
    text->ItalicOff();
  }
  return legend;
}
