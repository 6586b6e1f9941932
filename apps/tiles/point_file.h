// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/cloud_file.h>
#include <io/las_file.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace pcl_ops::apps {

/** \brief The points of a file: those of a .las are read as they are asked for, those
 * of a .pcd or .ply are in memory. */
class PointFile {
public:
  /** \throws UsageError or WorkError as \ref loadCloud */
  explicit PointFile (const std::string& file);

  std::uint64_t
  size () const;

  /** \brief NaN for a point without coordinates. */
  Eigen::Vector3d
  place (std::uint64_t point);

  /** \brief Calls \p visit with the place of each point, in their order. */
  void
  forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit);

  /** \brief Writes all there is in the file with a label for each point.
   * \param[in] output a .las for a .las, else a .pcd
   * \param[in] label asked for each point, in their order
   * \throws WorkError if it cannot be written */
  void
  saveLabelled (const std::string& output, const LabelOfPlace& label);

  /** \brief Why there can be no labels, with the fix; empty where there can. */
  std::string
  problemOfLabels () const;

private:
  std::shared_ptr<LasFile> las_;
  FileCloud cloud_;
};

} // namespace pcl_ops::apps
