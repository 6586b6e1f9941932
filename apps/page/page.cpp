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

/** \brief Returns points as a group, rounded to the lattice of the group. */
PointGroup
toGroup (const SampledPoints& points)
{
  constexpr double max_steps = std::numeric_limits<std::uint16_t>::max();
  PointGroup group;
  group.all_points = points.all_points;
  if (points.positions.empty())
    return group;
  Eigen::Array3d low = points.positions.front();
  Eigen::Array3d high = low;
  for (const Eigen::Vector3d& position : points.positions) {
    low = low.min (position.array());
    high = high.max (position.array());
  }
  group.origin = low;
  group.step = (high - low) / max_steps;
  const Eigen::Array3d steps_per_unit =
      (high > low).select (max_steps / (high - low), 0.0);
  group.steps.reserve (points.positions.size());
  for (const Eigen::Vector3d& position : points.positions) {
    const Eigen::Array3d exact_steps = (position.array() - low) * steps_per_unit;
    std::array<std::uint16_t, 3>& steps = group.steps.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
      steps.at (axis) = static_cast<std::uint16_t> (std::lround (exact_steps[axis]));
  }
  return group;
}

/** \brief Writes three bytes as four letters, each for six bits (base64, RFC 4648).
 * \param[in] bytes the first byte in bits 16 to 23, the last one in bits 0 to 7 */
void
writeBase64 (std::uint32_t bytes, std::ostream& stream)
{
  constexpr const char* digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::uint32_t six_bits = 63;
  char letters[4];
  for (int i = 0; i < 4; ++i)
    letters[i] = digits[bytes >> (18 - 6 * i) & six_bits];
  stream.write (letters, sizeof letters);
}

/** \brief Writes the steps of each point along x, y and z as 16-bit numbers,
 * little-endian, in base64. */
void
writeSteps (const PointGroup& group, std::ostream& stream)
{
  constexpr std::uint32_t low_byte = 255;
  // writeBase64 takes the first byte in the highest bits. The first byte of a
  // little-endian number is its low byte, so the bytes are swapped.
  const auto swapped = [] (std::uint16_t number) {
    return (number & low_byte) << 8U | number >> 8U;
  };
  for (const auto& [x, y, z] : group.steps) {
    const std::uint32_t swapped_y = swapped (y);
    writeBase64 (swapped (x) << 8U | swapped_y >> 8U, stream);
    writeBase64 ((swapped_y & low_byte) << 16U | swapped (z), stream);
  }
}

/** \brief Writes a JSON list with what viewer.js has to know of each group: the numbers
 * of all points and of those on the page, and the lattice. */
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
    stream << (&group == &groups.front() ? "" : ",\n") << R"({"all":)"
           << group.all_points << R"(,"shown":)" << group.steps.size()
           << R"(,"origin":)" << origin.transpose().format (list) << R"(,"step":)"
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
    groups.push_back (toGroup (sample));
  return groups;
}

std::vector<PointGroup>
groupPoints (const std::vector<std::uint32_t>& labels,
             std::size_t planes,
             const PositionOf& position_of,
             std::size_t max_points)
{
  std::vector<std::size_t> sizes (planes + 1, 0);
  const auto group_of = [&] (std::size_t i) {
    return labels[i] == 0 ? planes : labels[i] - 1;
  };
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (position_of (i).allFinite())
      ++sizes[group_of (i)];
  PointSample sample (sizes, max_points);
  for (std::size_t i = 0; i < labels.size(); ++i)
    sample.add (group_of (i), position_of (i));
  return toGroups (sample.take());
}

void
savePage (const std::string& file,
          const std::string& description,
          const std::vector<PointGroup>& groups,
          const Eigen::Vector3d& shift)
{
  // In JSON only strings have a <. A "</script>" in a string would end the script
  // element of the page.
  const std::string safe_description =
      boost::replace_all_copy (description, "<", "\\u003c");
  const std::string page = viewer_html;
  writeFile (file, [&] (std::ostream& stream) {
    // imbue comes before anything is written, as it throws where the file is full.
    stream.imbue (std::locale::classic());
    stream.precision (std::numeric_limits<double>::max_digits10);
    std::size_t written = 0;
    // Writes what is in front of a placeholder of viewer.html, and skips the
    // placeholder.
    const auto write_up_to = [&] (const std::string& placeholder) {
      const std::size_t end = page.find (placeholder);
      stream << page.substr (written, end - written);
      written = end + placeholder.size();
    };
    write_up_to ("{{description}}");
    stream << safe_description;
    write_up_to ("{{groups}}");
    writeGroups (groups, shift, stream);
    write_up_to ("{{steps}}");
    for (const PointGroup& group : groups)
      writeSteps (group, stream);
    write_up_to ("{{viewer}}");
    stream << viewer_js << page.substr (written);
  });
}

} // namespace pcl_ops::apps
