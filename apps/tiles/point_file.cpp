// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_file.h"

#include <io/laz_file.h>
#include <io/shifted_cloud.h>
#include <picture/colors.h>

#include <vector>

namespace pcl_ops::apps {

PointFile::PointFile (const std::string& file)
{
  if (isLasName (file))
    las_ = openLas (file);
  else
    cloud_ = loadCloud (file);
}

std::uint64_t
PointFile::size() const
{
  return las_ ? las_->size() : cloud_.size();
}

Eigen::Vector3d
PointFile::place (std::uint64_t point)
{
  return las_ ? las_->place (point) : CoordinateReader (cloud_) (point);
}

void
PointFile::forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit)
{
  if (las_)
    return las_->forPlaces (visit);
  const CoordinateReader reader (cloud_);
  for (std::size_t i = 0; i < cloud_.size(); ++i)
    visit (reader (i));
}

void
PointFile::saveLabelled (const std::string& output, const LabelOfPlace& label)
{
  if (las_)
    return saveLabelledLas (output, *las_, label);
  std::vector<std::uint32_t> labels;
  labels.reserve (cloud_.size());
  forPlaces ([&] (const Eigen::Vector3d& place) { labels.push_back (label (place)); });
  saveLabelledCloud (output, cloud_, labels, {}, false);
}

std::string
PointFile::problemOfLabels() const
{
  return las_ ? las_->problemOfLabels() : "";
}

} // namespace pcl_ops::apps
