// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "las_header.h"

#include <array>
#include <functional>
#include <utility>

namespace pcl_ops::apps {

/** \brief Of the next point, given where that is. */
using LabelOfPlace = std::function<std::uint32_t (const Eigen::Vector3d&)>;

/** \brief A field of extra bytes, and its four of the next point. */
using LasColumn = std::pair<LasField, LabelOfPlace>;

/** \brief A LAS file, versions 1.2 to 1.4. It stays open, so that what is no coordinate
 * need not be in memory to be written again, and may be removed meanwhile. */
class LasFile {
public:
  /** \throws WorkError if it is none, compressed, or does not hold what it promises */
  explicit LasFile (const std::string& file);

  /** \brief With x, y, z in double precision, intensity, and label if there is one. */
  pcl::PCLPointCloud2
  readPoints ();

  std::uint64_t
  size () const
  {
    return frame_.header.points;
  }

  Eigen::Vector3d
  place (std::uint64_t point);

  /** \brief Visits the places of all points, with a block of them in memory. */
  void
  forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit);

  /** \brief Why there can be no such fields beside all else, with the fix, or empty. */
  std::string
  validate (const std::vector<LasField>& fields) const;

  /** \brief Writes every byte of the file with further fields, each in place of the one
   * of its name that there is. \throws WorkError if the file was cut meanwhile */
  void
  writeWith (const std::vector<LasColumn>& columns, std::ostream& stream);

private:
  LasFrame frame_;
};

/** \brief Writes it labeled by \ref writeFile. */
void
saveLabelledLas (const std::string& file, LasFile& las, const LabelOfPlace& label);

/** \brief The same with a label and, unless there are none, a distance per point. */
void
saveLabelledLas (const std::string& file,
                 LasFile& las,
                 const std::vector<std::uint32_t>& labels,
                 const std::vector<float>& distances = {});

/** \brief A point in units of the scale, relative to the offset, with its label. */
struct LasPoint {
  std::array<std::int32_t, 3> raw{};
  std::uint32_t label = 0;
};

/** \brief Writes a LAS 1.2 of point data record format 0 by \ref writeFile, with the
 * labels in its extra bytes. */
void
saveLas (const std::string& file,
         const std::vector<LasPoint>& points,
         double scale,
         const Eigen::Vector3d& offset);

} // namespace pcl_ops::apps
