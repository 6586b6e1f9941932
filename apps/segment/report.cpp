// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <boost/format.hpp>

#include <cli/text.h>
#include <detection/warning_lines.h>
#include <numbers/angles.h>
#include <numbers/statistics.h>

#include <cmath>
#include <ostream>
#include <set>

namespace pcl_ops::apps {

namespace {

/** \brief Returns how many percent of \p whole \p part is; 0 if \p whole is 0. */
double
percentage (std::size_t part, std::size_t whole)
{
  constexpr double percent = 100.0;
  return percent * fraction (part, whole, 0.0);
}

/** \brief Prints a header, a row for each of the largest planes, and one for the points
 * on no plane. */
void
printPlanes (const Report& report, std::ostream& stream)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const std::vector<PlaneKind>& kinds = report.detected.kinds;
  constexpr std::size_t max_rows = 20; // so that the table fits on a screen
  const std::vector<std::uint32_t> plane_ids = report.planeIdsOfPieces();
  stream << "  id" << (plane_ids.empty() ? "" : " plane")
         << "  orientation  kind       points      %       rms"
            "         a         b         c         d\n";
  std::size_t on_no_plane = report.points;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::size_t size = planes[i].inliers.size();
    on_no_plane -= size; // also for planes without a row
    if (i >= max_rows)
      continue;
    const auto [normal, offset] = planes[i].plane();
    stream << boost::format ("%4d") % report.ids[i];
    if (!plane_ids.empty())
      stream << boost::format (" %5d") % plane_ids[i];
    stream << boost::format (
                  "  %-11s  %-7s %9d %6.1f %9.4f %9.4f %9.4f %9.4f %9.4f\n") %
                  toString (planes[i].orientation) % toString (kinds[i]) % size %
                  percentage (size, report.points) % planes[i].rms() % normal.x() %
                  normal.y() % normal.z() % offset;
  }
  if (planes.size() > max_rows)
    stream << "      and " << planes.size() - max_rows
           << " smaller ones: --planes FILE.json has them all\n";
  stream << boost::format ("      %sno plane             %9d %6.1f\n") %
                (plane_ids.empty() ? "" : "      ") % on_no_plane %
                percentage (on_no_plane, report.points);
}

/** \brief Returns the numbers of points and planes: "900 points, 12 pieces of 5
 * planes".
 */
std::string
countsOf (const Report& report)
{
  const std::size_t planes = report.detected.planes.size();
  const std::string points = counted (report.points, "point") + ", ";
  if (report.detected.lies_on.empty())
    return points + counted (planes, "plane");
  const std::set<std::size_t> whole_planes (report.detected.lies_on.begin(),
                                            report.detected.lies_on.end());
  return points + counted (planes, "piece") + " of " +
         counted (whole_planes.size(), "plane");
}

/** \brief Returns the voxel size and the threshold that were used, with the names of
 * their options; empty if there are none. */
std::string
lengthsOf (const UsedLengths& used)
{
  std::string lengths;
  const auto add = [&] (const char* name, const std::optional<double>& length) {
    if (length)
      lengths += str (boost::format (" %s %.4g") % name % *length);
  };
  add ("voxel-size", used.voxel_size);
  add ("threshold", used.distance_threshold);
  return lengths;
}

/** \brief Returns lines on dropped planes, advice and hints; empty if there are none.
 */
std::vector<std::string>
remarksOn (const Report& report)
{
  const Detected& detected = report.detected;
  const std::size_t kept = detected.planes.size();
  const std::size_t found = report.dropped.found;
  std::vector<std::string> remarks;
  if (kept > 0 && !report.dropped.by_option.empty())
    remarks.push_back ("Dropped " + std::to_string (found - kept) + " of " +
                       std::to_string (found) + " planes: " + report.dropped.reasons() +
                       ".");
  if (kept == 0)
    remarks.push_back ("No plane found: " + detected.advice + ".");
  else if (!detected.advice.empty())
    remarks.push_back ("Hardly any point is on a plane: " + detected.advice + ".");
  remarks.insert (remarks.end(), detected.hints.begin(), detected.hints.end());
  return remarks;
}

/** \brief Returns a line on regularized planes: how many were moved, and the largest
 * angle [degrees] and distance [unit of the cloud] by which one was. */
std::string
noteOnMoves (const std::vector<PlaneMove>& moves)
{
  std::size_t moved = 0;
  double max_angle = 0.0;
  double max_distance = 0.0;
  for (const PlaneMove& move : moves)
    if (move.is_moved) {
      ++moved;
      max_angle = std::max (max_angle, move.angle);
      max_distance = std::max (max_distance, std::abs (move.offset));
    }
  return str (boost::format ("Regularized %1% of %2% planes: turned by %3$.2g degrees "
                             "and moved by %4$.2g at most") %
              moved % moves.size() % toDegrees (max_angle) % max_distance);
}

/** \brief Returns PlaneMove::displacement; null if it is infinite, as for a moved plane
 * of rms 0, since JSON has no infinity. */
nlohmann::ordered_json
displacementOf (const PlaneMove& move)
{
  if (!std::isfinite (move.displacement))
    return nullptr;
  return move.displacement;
}

} // namespace

void
printTable (const Report& report, std::ostream& stream)
{
  stream << report.input << ": " << countsOf (report) << " (" << report.method << ")\n";
  if (!report.detected.planes.empty())
    printPlanes (report, stream);
  if (!report.detected.up_note.empty())
    stream << report.detected.up_note << "\n";
  if (!report.detected.moves.empty())
    stream << noteOnMoves (report.detected.moves) << "\n";
  for (const std::string& line : remarksOn (report))
    stream << line << "\n";
  if (const std::string lengths = lengthsOf (report.detected.used); !lengths.empty())
    stream << "Used:" << lengths << "\n";
  stream << "Times [ms]:";
  for (const auto& [name, duration] : detection_stages)
    stream << boost::format (" %s %.1f") % name % (report.detected.timing.*duration);
  stream << boost::format (" (wall), %.1f of the processor\n") %
                report.detected.processor_time;
}

std::string
summaryOf (const Report& report)
{
  std::string summary = countsOf (report);
  for (const std::string& line : remarksOn (report))
    summary += (summary.back() == '.' ? " " : ". ") + line;
  return summary;
}

nlohmann::ordered_json
toJson (const Report& report)
{
  const Detected& detected = report.detected;
  nlohmann::ordered_json json;
  json["points"] = report.points;
  json["method"] = report.method;
  json["parameters"] = detected.settings;
  for (const auto& [name, duration] : detection_stages)
    json["timing_ms"][name] = detected.timing.*duration;
  json["timing_ms"]["processor"] = detected.processor_time;
  if (!report.damage.empty())
    json["warning"] = report.damage;
  if (!detected.advice.empty())
    json["advice"] = detected.advice;
  if (!report.warnings.empty())
    json["warnings"] = warningsToJson (report.warnings);
  if (detected.suggested_up)
    json["suggested_up"] = *detected.suggested_up;
  if (!report.dropped.by_option.empty())
    json["dropped"] = toObject (report.dropped);
  json["planes"] = nlohmann::ordered_json::array();
  const Eigen::Vector3d up = detected.up.cast<double>().normalized();
  const std::vector<std::uint32_t> plane_ids = report.planeIdsOfPieces();
  for (std::size_t i = 0; i < detected.planes.size(); ++i) {
    nlohmann::ordered_json& object = json["planes"].emplace_back (planeObject (
        report.ids[i], detected.planes[i], report.extents[i], detected.kinds[i], up));
    if (!plane_ids.empty())
      object["plane"] = plane_ids[i];
    if (!detected.moves.empty())
      object["moved"] = {{"angle", toDegrees (detected.moves[i].angle)},
                         {"distance", detected.moves[i].offset},
                         {"displacement", displacementOf (detected.moves[i])},
                         {"direction", detected.moves[i].direction},
                         {"level", detected.moves[i].level}};
  }
  return json;
}

} // namespace pcl_ops::apps
