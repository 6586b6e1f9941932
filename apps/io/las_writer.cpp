// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_writer.h"

#include "las_header.h"
#include "las_vlrs.h"
#include "little_endian.h"
#include "output_file.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <ostream>

namespace pcl_ops::apps {

namespace {

constexpr std::uint16_t header_size = 227, record_format_size = 20;

/** \brief Puts bytes in place of some. */
void
replace (std::string& bytes, std::size_t place, const std::string& changed)
{
  bytes.replace (place, changed.size(), changed);
}

std::string
bytesOf (double number)
{
  std::uint64_t bits;
  std::memcpy (&bits, &number, sizeof (bits));
  return littleEndian (bits);
}

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
  constexpr std::size_t software = 58, header_size_at = 94, points_at = 107,
                        scale_at = 131, offset_at = 155, bounds_at = 179;
  std::string bytes (header_size, '\0');
  replace (bytes, 0, "LASF");
  replace (bytes, 24, "\1\2");
  replace (bytes, software, "pcl_ops");
  replace (bytes, header_size_at, littleEndian (header_size));
  replace (bytes,
           las_field::points_offset,
           littleEndian (static_cast<std::uint32_t> (header_size + vlr_size)));
  replace (bytes, las_field::vlr_count, littleEndian (std::uint32_t (1)));
  replace (bytes,
           las_field::record_length,
           littleEndian (static_cast<std::uint16_t> (record_format_size +
                                                     sizeof (std::uint32_t))));
  const std::string count = littleEndian (static_cast<std::uint32_t> (points.size()));
  replace (bytes, points_at, count + count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double zero = offset[static_cast<Eigen::Index> (axis)];
    const auto [low, high] = boundsOf (points, axis, scale, zero);
    replace (bytes, scale_at + 8 * axis, bytesOf (scale));
    replace (bytes, offset_at + 8 * axis, bytesOf (zero));
    replace (bytes, bounds_at + 16 * axis, bytesOf (high) + bytesOf (low));
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
  plain.format_length = plain.record_length = record_format_size;
  LasExtraBytes none;
  none.described_end = record_format_size;
  const std::string vlr = extraBytesVlr (descriptionsOf ({label_field}, plain, none));
  writeFile (file, [&] (std::ostream& stream) {
    stream << headerOf (points, scale, offset, vlr.size()) << vlr;
    std::string record (record_format_size + sizeof (std::uint32_t), '\0');
    for (const LasPoint& point : points) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        replace (record,
                 axis * sizeof (std::int32_t),
                 littleEndian (static_cast<std::uint32_t> (point.raw[axis])));
      replace (record, record_format_size, littleEndian (point.label));
      stream << record;
    }
  });
}

} // namespace pcl_ops::apps
