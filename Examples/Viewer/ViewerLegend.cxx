// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerLegend.h"

#include "vtkScalarBarActor.h"
#include "vtkScalarsToColors.h"
#include "vtkTextProperty.h"

vtkSmartPointer<vtkScalarBarActor> MakeLegend(
  vtkScalarsToColors* table, const std::string& title, int numberOfLabels, int height)
{
  const int rowHeight = 20; // pixels
  const int rows =
    table->GetIndexedLookup() ? static_cast<int>(table->GetNumberOfAnnotatedValues()) : 10;
  const double share = static_cast<double>(rowHeight) * (rows + 2) / height;
  if (share > 0.90)
  {
    return nullptr;
  }
  auto legend = vtkSmartPointer<vtkScalarBarActor>::New();
  legend->SetLookupTable(table);
  legend->SetTitle(title.c_str());
  legend->SetNumberOfLabels(numberOfLabels);
  legend->SetLabelFormat("%.3g");
  if (table->GetIndexedLookup())
  {
    legend->SetTextPositionToPrecedeScalarBar(); // which puts annotations on the other side
  }
  legend->SetVerticalTitleSeparation(8);
  legend->SetAnnotationLeaderPadding(6);
  legend->UnconstrainedFontSizeOn();
  legend->SetBarRatio(0.25);
  legend->SetWidth(0.08);
  legend->SetHeight(share);
  // The title of a continuous bar stands above it.
  const double headroom = table->GetIndexedLookup() ? 0.0 : static_cast<double>(rowHeight) / height;
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
