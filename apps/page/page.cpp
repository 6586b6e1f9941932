// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "page.h"

#include <boost/algorithm/string/replace.hpp>

#include "viewer.h"
#include <io/output_file.h>

#include <cmath>
#include <limits>
#include <locale>
#include <ostream>

namespace pcl_ops::apps {

namespace {

/** \brief Rounds places to a lattice of 16 bits per axis in their bounding box. */
PointGroup
onLattice (const SampledPoints& points)
{
  constexpr double last = std::numeric_limits<std::uint16_t>::max();
  PointGroup group;
  group.all = points.all;
  if (points.places.empty())
    return group;
  Eigen::Array3d low = points.places.front();
  Eigen::Array3d high = low;
  for (const Eigen::Vector3d& place : points.places) {
    low = low.min (place.array());
    high = high.max (place.array());
  }
  group.origin = low;
  group.step = (high - low) / last;
  const Eigen::Array3d per_step = (high > low).select (last / (high - low), 0.0);
  group.places.reserve (points.places.size());
  for (const Eigen::Vector3d& place : points.places) {
    const Eigen::Array3d steps = (place.array() - low) * per_step;
    std::array<std::uint16_t, 3>& on_lattice = group.places.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
      on_lattice.at (axis) = static_cast<std::uint16_t> (std::lround (steps[axis]));
  }
  return group;
}

/** \brief Writes three bytes, the last in the lowest bits, as four letters
 * (RFC 4648). */
void
writeBase64 (std::uint32_t bytes, std::ostream& stream)
{
  constexpr const char* digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  char letters[4];
  for (int i = 0; i < 4; ++i)
    letters[i] = digits[bytes >> (18 - 6 * i) & 63U];
  stream.write (letters, sizeof letters);
}

/** \brief Writes x, y and z of each point as 16-bit numbers, little-endian. */
void
writePlaces (const PointGroup& group, std::ostream& stream)
{
  const auto swapped = [] (std::uint16_t number) {
    return std::uint32_t (number & 255U) << 8U | number >> 8U;
  };
  for (const auto& [x, y, z] : group.places) {
    const std::uint32_t second = swapped (y);
    writeBase64 (swapped (x) << 8U | second >> 8U, stream);
    writeBase64 ((second & 255U) << 16U | swapped (z), stream);
  }
}

void
writeGroups (const std::vector<PointGroup>& groups,
             const Eigen::Vector3d& shift,
             std::ostream& stream)
{
  const Eigen::IOFormat list (
      Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",", "", "", "[", "]");
  stream << '[';
  for (const PointGroup& group : groups) {
    const Eigen::Vector3d origin = group.origin + shift;
    stream << (&group == &groups.front() ? "" : ",\n") << R"({"all":)" << group.all
           << R"(,"shown":)" << group.places.size() << R"(,"origin":)"
           << origin.transpose().format (list) << R"(,"step":)"
           << group.step.transpose().format (list) << '}';
  }
  stream << ']';
}

} // namespace

std::vector<PointGroup>
toGroups (const std::vector<SampledPoints>& samples)
{
  std::vector<PointGroup> groups;
  for (const SampledPoints& sample : samples)
    groups.push_back (onLattice (sample));
  return groups;
}

std::vector<PointGroup>
groupPoints (const std::vector<std::uint32_t>& labels,
             std::size_t planes,
             const PlaceOf& place,
             std::size_t max_points)
{
  std::vector<std::size_t> sizes (planes + 1, 0);
  const auto group_of = [&] (std::size_t i) {
    return labels[i] == 0 ? planes : labels[i] - 1;
  };
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (place (i).allFinite())
      ++sizes[group_of (i)];
  PointSample sample (sizes, max_points);
  for (std::size_t i = 0; i < labels.size(); ++i)
    sample.add (group_of (i), place (i));
  return toGroups (sample.take());
}

void
savePage (const std::string& file,
          const std::string& description,
          const std::vector<PointGroup>& groups,
          const Eigen::Vector3d& shift)
{
  // In JSON only strings have a <; the page would end its script at a "</script>" in
  // one.
  const std::string safe = boost::replace_all_copy (description, "<", "\\u003c");
  const std::string page = viewer_html;
  writeFile (file, [&] (std::ostream& stream) {
    // Before anything is written: imbue throws where the file is full.
    stream.imbue (std::locale::classic());
    stream.precision (std::numeric_limits<double>::max_digits10);
    std::size_t written = 0;
    const auto write_up_to = [&] (const std::string& mark) {
      const std::size_t end = page.find (mark);
      stream << page.substr (written, end - written);
      written = end + mark.size();
    };
    write_up_to ("{{description}}");
    stream << safe;
    write_up_to ("{{groups}}");
    writeGroups (groups, shift, stream);
    write_up_to ("{{places}}");
    for (const PointGroup& group : groups)
      writePlaces (group, stream);
    write_up_to ("{{viewer}}");
    stream << viewer_js << page.substr (written);
  });
}

} // namespace pcl_ops::apps
