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

/** \brief The points of a file: read on demand from a .las, else all in memory. */
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

  /** \brief NaN for a point without coordinates. */
  Eigen::Vector3d
  place (std::uint64_t point)
  {
    return las ? las->place (point) : CoordinateReader (cloud) (point);
  }

  /** \brief Calls \p visit with the place of each point, in their order. */
  void
  forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit)
  {
    if (las)
      return las->forPlaces (visit);
    const CoordinateReader reader (cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      visit (reader (i));
  }

  /** \brief Visits the points of a file that \ref saveLabelled has written.
   * \throws WorkError if they have no labels */
  void
  forLabels (const VisitLabelled& visit)
  {
    if (las)
      return las->forLabels (visit);
    const int index = pcl::getFieldIndex (cloud.points, label_field.name);
    if (index < 0)
      throw WorkError (name, "has no labels; give a file with labels");
    const pcl::PCLPointField& field = cloud.points.fields[std::size_t (index)];
    const NumberReader label = numberType (field.datatype).read;
    const CoordinateReader place (cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::size_t at = i * cloud.points.point_step + field.offset;
      visit (place (i), static_cast<std::uint32_t> (label (&cloud.points.data[at])));
    }
  }

  /** \brief Writes a copy of the file with a label for each point; in a .pcd also with
   * a color by label, in place of that of the file.
   * \param[in] output a .las for a .las, else a .pcd
   * \param[in] label called for each point, in the order of the file
   * \throws WorkError if it cannot be written */
  void
  saveLabelled (const std::string& output, const LabelOfPlace& label)
  {
    if (las)
      return saveLasWith (output, *las, {{label_field, label}});
    std::vector<std::uint32_t> labels;
    forPlaces (
        [&] (const Eigen::Vector3d& place) { labels.push_back (label (place)); });
    saveLabelledCloud (output, cloud, labels, {}, false);
  }

  std::string name;
  std::shared_ptr<LasFile> las;
  FileCloud cloud;
};

} // namespace pcl_ops::apps
