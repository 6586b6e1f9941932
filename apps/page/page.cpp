// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "page.h"

#include <boost/algorithm/string/replace.hpp>

#include "viewer.h"
#include <io/output_file.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <ostream>

namespace pcl_ops::apps {

namespace {

/** \brief A point, by its index, and what its turn in the order depends on. */
struct Turn {
  std::uint32_t hash;
  std::uint32_t point;
};

using Turns = std::vector<Turn>;

std::vector<Turns>
turnsOf (const std::vector<std::uint32_t>& labels,
         std::size_t planes,
         const PlaceOf& place)
{
  std::vector<Turns> turns (planes + 1);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (const Eigen::Vector3d at = place (i); at.allFinite()) {
      const std::size_t group = labels[i] == 0 ? planes : labels[i] - 1;
      turns[group].push_back ({hashOf (at), static_cast<std::uint32_t> (i)});
    }
  return turns;
}

/** \brief Leaves those whose turn comes first, in order. */
void
keepFirst (Turns& turns, std::size_t kept, const PlaceOf& place)
{
  const auto is_before = [&] (const Turn& a, const Turn& b) {
    if (a.hash != b.hash)
      return a.hash < b.hash;
    const Eigen::Vector3d first = place (a.point);
    const Eigen::Vector3d second = place (b.point);
    return std::lexicographical_compare (
        first.begin(), first.end(), second.begin(), second.end());
  };
  const auto end = turns.begin() + static_cast<std::ptrdiff_t> (kept);
  if (kept < turns.size())
    std::nth_element (turns.begin(), end, turns.end(), is_before);
  turns.erase (end, turns.end());
  std::sort (turns.begin(), turns.end(), is_before);
}

/** \brief How many of a group's points are kept. */
class Quota {
public:
  Quota (const std::vector<Turns>& groups, std::size_t max_points)
  {
    constexpr std::size_t enough = 100;
    std::size_t all = 0;
    for (const Turns& turns : groups)
      all += turns.size();
    if (all <= max_points)
      return;
    least_ = std::min (enough, max_points / (2 * groups.size()));
    share_ = double (max_points - least_ * groups.size()) / double (all);
  }

  std::size_t
  of (std::size_t points) const
  {
    const auto shared =
        static_cast<std::size_t> (std::floor (share_ * double (points)));
    return std::min (points, std::max (least_, shared));
  }

private:
  std::size_t least_ = 0;
  double share_ = 1.0;
};

/** \brief Places on the lattice of the box around them. */
PointGroup
onLattice (const Turns& turns, const PlaceOf& place)
{
  constexpr double last = std::numeric_limits<std::uint16_t>::max();
  PointGroup group;
  if (turns.empty())
    return group;
  Eigen::Array3d low = place (turns.front().point);
  Eigen::Array3d high = low;
  for (const Turn& turn : turns) {
    low = low.min (place (turn.point).array());
    high = high.max (place (turn.point).array());
  }
  group.origin = low;
  group.step = (high - low) / last;
  const Eigen::Array3d per_step = (high > low).select (last / (high - low), 0.0);
  group.places.reserve (turns.size());
  for (const Turn& turn : turns) {
    const Eigen::Array3d steps = (place (turn.point).array() - low) * per_step;
    std::array<std::uint16_t, 3>& on_lattice = group.places.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
      on_lattice.at (axis) = static_cast<std::uint16_t> (std::lround (steps[axis]));
  }
  return group;
}

/** \brief Three bytes, the last in the lowest bits, as four letters (RFC 4648). */
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

/** \brief Six bytes for each point, the lower of each number first. */
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
groupPoints (const std::vector<std::uint32_t>& labels,
             std::size_t planes,
             const PlaceOf& place,
             std::size_t max_points)
{
  std::vector<Turns> turns = turnsOf (labels, planes, place);
  const Quota quota (turns, max_points);
  std::vector<PointGroup> groups;
  for (Turns& of_group : turns) {
    const std::size_t all = of_group.size();
    keepFirst (of_group, quota.of (all), place);
    groups.push_back (onLattice (of_group, place));
    groups.back().all = all;
  }
  return groups;
}

void
savePage (const std::string& file,
          const std::string& description,
          const std::vector<PointGroup>& groups,
          const Eigen::Vector3d& shift)
{
  // In JSON only strings have it, and a page would end its script at one's "</script>".
  const std::string safe = boost::replace_all_copy (description, "<", "\\u003c");
  const std::string page = viewer_html;
  writeFile (file, [&] (std::ostream& stream) {
    // Before all else: streams whose file is full throw at it.
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
