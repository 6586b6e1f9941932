// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "interaction.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cstdlib>

namespace pcl_ops::apps {

vtkStandardNewMacro (Interaction)

    void Interaction::OnKeyDown()
{
  const std::string key (1, Interactor->GetKeyCode());
  const bool has_modifier =
      Interactor->GetControlKey() != 0 || Interactor->GetAltKey() != 0;
  is_own_key_ = !has_modifier && on_key && on_key (key);
  if (!is_own_key_)
    PCLVisualizerInteractorStyle::OnKeyDown();
}

void
Interaction::OnChar()
{
  // Follows the same press of a key.
  if (!is_own_key_)
    PCLVisualizerInteractorStyle::OnChar();
}

void
Interaction::OnLeftButtonDown()
{
  Interactor->GetEventPosition (pressed_x_, pressed_y_);
  PCLVisualizerInteractorStyle::OnLeftButtonDown();
}

void
Interaction::OnLeftButtonUp()
{
  constexpr int kStill = 3;
  PCLVisualizerInteractorStyle::OnLeftButtonUp();
  int x = 0;
  int y = 0;
  Interactor->GetEventPosition (x, y);
  const bool is_click =
      std::max (std::abs (x - pressed_x_), std::abs (y - pressed_y_)) <= kStill;
  if (is_click && on_click)
    on_click (x, y);
}

} // namespace pcl_ops::apps
