// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "boards.h"

#include <cmath>

namespace pcl_ops::benchmark {

simulation::Scene
makeBoards (unsigned number)
{
  constexpr double spacing = 2.0; // [m]; a board is 1 m wide
  // No two of its multiples are near each other on the circle [rad].
  constexpr double golden_angle = 2.399963229728653;
  constexpr double steepest = 0.5; // [rad]
  const auto columns =
      static_cast<unsigned> (std::ceil (std::sqrt (static_cast<double> (number))));
  simulation::Scene scene;
  for (unsigned i = 0; i < number; ++i) {
    simulation::Body board;
    simulation::addSurface (board, {});
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate (Eigen::Vector3d (
        spacing * (i % columns), spacing * std::floor (i / columns), 0.0));
    pose.rotate (Eigen::AngleAxisd (golden_angle * i, Eigen::Vector3d::UnitZ()));
    pose.rotate (Eigen::AngleAxisd (steepest * i / number, Eigen::Vector3d::UnitX()));
    simulation::addBody (scene, board, pose);
  }
  return scene;
}

} // namespace pcl_ops::benchmark
