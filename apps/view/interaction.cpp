// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "interaction.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cstdlib>

namespace pcl_ops::apps {

namespace {

/** \brief The character of the last key, that of a number pad too. */
std::string
pressedKey (vtkRenderWindowInteractor& interactor)
{
  const char* const symbol = interactor.GetKeySym();
  const std::string name = symbol == nullptr ? "" : symbol;
  // The key with + and = where + needs the shift key, which many will not press.
  if (name == "KP_Add" || name == "equal")
    return "+";
  if (name == "KP_Subtract")
    return "-";
  return std::string (1, interactor.GetKeyCode());
}

} // namespace

vtkStandardNewMacro (Interaction)

    void Interaction::OnKeyDown()
{
  const std::string key = pressedKey (*Interactor);
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
  constexpr int still = 3;
  PCLVisualizerInteractorStyle::OnLeftButtonUp();
  int x = 0;
  int y = 0;
  Interactor->GetEventPosition (x, y);
  const bool is_click =
      std::max (std::abs (x - pressed_x_), std::abs (y - pressed_y_)) <= still;
  if (is_click && on_click)
    on_click (x, y);
}

} // namespace pcl_ops::apps
