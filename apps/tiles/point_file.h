// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/las_file.h>
#include <io/shifted_cloud.h>
#include <picture/colors.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The points of a file: read from the file when needed if it is a .las or .laz,
 * else all in memory. */
struct PointFile {
  /** \throws UsageError or WorkError as \ref loadCloud */
  explicit PointFile (const std::string& file)
  : name (file)
  , las (isLasName (file) ? openLas (file) : nullptr)
  , cloud (las ? FileCloud() : loadCloud (file))
  {}

  std::uint64_t
  size () const
  {
    return las ? las->size() : cloud.size();
  }

  /** \brief Returns the coordinates of a point, by its index; they may be NaN. */
  Eigen::Vector3d
  position (std::uint64_t point)
  {
    return las ? las->position (point) : CoordinateReader (cloud) (point);
  }

  /** \brief Calls \p visit with the coordinates of each point, in their order. */
  void
  forPositions (const std::function<void (const Eigen::Vector3d&)>& visit)
  {
    if (las)
      return las->forPositions (visit);
    const CoordinateReader reader (cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      visit (reader (i));
  }

  /** \brief Calls \p visit with the coordinates and the label of each point of a file
   * that \ref saveLabeled has written.
   * \throws WorkError if the points have no labels */
  void
  forLabels (const VisitLabeledPosition& visit)
  {
    if (las)
      return las->forLabels (visit);
    const int index = pcl::getFieldIndex (cloud.points, label_field.name);
    if (index < 0)
      throw WorkError (name, "has no labels; give a file with labels");
    const pcl::PCLPointField& field = cloud.points.fields[std::size_t (index)];
    const NumberReader read_number = numberType (field.datatype).read;
    const CoordinateReader position_of (cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::size_t offset = i * cloud.points.point_step + field.offset;
      const double label = read_number (&cloud.points.data[offset]);
      visit (position_of (i), static_cast<std::uint32_t> (label));
    }
  }

  /** \brief Writes a copy of the file with a label for each point; in a .pcd also with
   * a color by label, in place of that of the file.
   * \param[in] output a .las or .laz for such a file, else a .pcd
   * \param[in] label_of called for each point, in the order of the file
   * \throws WorkError if \p output cannot be written */
  void
  saveLabeled (const std::string& output, const NextFieldValue& label_of)
  {
    if (las)
      return saveLasWith (output, *las, {{label_field, label_of}});
    std::vector<std::uint32_t> labels;
    forPositions (
        [&] (const Eigen::Vector3d& point) { labels.push_back (label_of (point)); });
    saveLabeledCloud (output, cloud, labels, {}, false);
  }

  std::string name;
  /** \brief nullptr for formats other than .las and .laz. */
  std::shared_ptr<LasFile> las;
  /** \brief All points of a file of another format, else empty. */
  FileCloud cloud;
};

} // namespace pcl_ops::apps
