// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/visualization/interactor_style.h>

#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief PCLVisualizer's way with mouse and keys, but the viewer is asked first: its
 * keys win over PCL's, and a click of the left button that does not turn the cloud is a
 * question to it. */
class Interaction : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  static Interaction*
  New ();

  /** \brief Gets the character of a pressed key, returns whether it was one of the
   * viewer's.
   */
  std::function<bool (const std::string&)> on_key;
  /** \brief Gets the pixel from the lower left corner. */
  std::function<void (int, int)> on_click;

protected:
  Interaction() = default;

  void
  OnKeyDown () override;
  void
  OnChar () override;
  void
  OnLeftButtonDown () override;
  void
  OnLeftButtonUp () override;

private:
  bool is_own_key_ = false;
  int pressed_x_ = 0;
  int pressed_y_ = 0;
};

} // namespace pcl_ops::apps
