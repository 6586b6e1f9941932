// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_writer.h"

#include "las_header.h"
#include "las_vlrs.h"
#include "little_endian.h"
#include "output_file.h"

#include <algorithm>
#include <limits>
#include <ostream>

namespace pcl_ops::apps {

namespace {

constexpr std::uint16_t header_size = 227, record_size = 20, labeled_size = 24;

/** \brief Lowest and highest place along an axis. */
std::array<double, 2>
boundsOf (const std::vector<LasPoint>& points,
          std::size_t axis,
          double scale,
          double offset)
{
  std::int32_t low = std::numeric_limits<std::int32_t>::max();
  std::int32_t high = std::numeric_limits<std::int32_t>::min();
  for (const LasPoint& point : points) {
    low = std::min (low, point.raw[axis]);
    high = std::max (high, point.raw[axis]);
  }
  return {low * scale + offset, high * scale + offset};
}

std::string
headerOf (const std::vector<LasPoint>& points,
          double scale,
          const Eigen::Vector3d& offset,
          std::size_t vlr_size)
{
  constexpr std::size_t version = 24, software = 58;
  std::string bytes = "LASF";
  bytes.resize (header_size, '\0');
  bytes.replace (version, 2, "\1\2");
  bytes.replace (software, 7, "pcl_ops");
  const auto count = static_cast<std::uint32_t> (points.size());
  setNumber (bytes, las_field::header_size, header_size);
  setNumber (bytes,
             las_field::points_offset,
             static_cast<std::uint32_t> (header_size + vlr_size));
  setNumber (bytes, las_field::vlr_count, std::uint32_t (1));
  setNumber (bytes, las_field::record_length, labeled_size);
  setNumber (bytes, las_field::legacy_points, count);
  setNumber (bytes, las_field::legacy_points + sizeof (count), count); // first returns
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double zero = offset[static_cast<Eigen::Index> (axis)];
    const auto [low, high] = boundsOf (points, axis, scale, zero);
    setNumber (bytes, las_field::scale + 8 * axis, scale);
    setNumber (bytes, las_field::offset + 8 * axis, zero);
    setNumber (bytes, las_field::bounds + 16 * axis, high);
    setNumber (bytes, las_field::bounds + 16 * axis + 8, low);
  }
  return bytes;
}

} // namespace

void
saveLas (const std::string& file,
         const std::vector<LasPoint>& points,
         double scale,
         const Eigen::Vector3d& offset)
{
  LasHeader plain;
  plain.format_length = plain.record_length = record_size;
  LasExtraBytes none;
  none.described_end = record_size;
  const std::string vlr = extraBytesVlr (descriptionsOf ({label_field}, plain, none));
  writeFile (file, [&] (std::ostream& stream) {
    stream << headerOf (points, scale, offset, vlr.size()) << vlr;
    std::string record (labeled_size, '\0');
    for (const LasPoint& point : points) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        setNumber (record, axis * sizeof (std::int32_t), point.raw[axis]);
      setNumber (record, record_size, point.label);
      stream << record;
    }
  });
}

} // namespace pcl_ops::apps
