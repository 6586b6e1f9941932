// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/program.h>
#include <detection/plane_json.h>
#include <evaluation/report/text_table.h>
#include <nlohmann/json.hpp>
#include <numbers/angles.h>
#include <pcl_ops/plane_matching.h>

#include <algorithm>
#include <iostream>

namespace pcl_ops::evaluation {

namespace {

struct PlanesOptions {
  std::string first_file, second_file;
  /** \brief [degree] */
  double rotation_error = apps::toDegrees (PlaneMatchingParameters().rotation_error);
  PlaneMatchingParameters matching;
  bool json = false;
};

/** A plane of one result and the plane of the other that is the same. */
struct MatchedPlanes {
  /** Positions in the two results. */
  std::size_t first, second;
  /** Between the normals, whichever way they point [degree]. */
  double angle;
  /** Height of the second's middle over the first, along the first's normal [m]. */
  double offset;
};

using Ids = std::vector<std::uint64_t>;

/** What two results have in common. Angles and offsets are those of the planes as they
 * are. */
struct PlaneComparison {
  /** In the order of the first result. */
  std::vector<MatchedPlanes> matched;
  /** Planes without a partner. */
  Ids only_first, only_second;
  /** The motion of the second result after which matched planes agree best: its angle
   * [degree], and how far it moves the middle of the first result [m]. */
  double angle = 0.0, shift = 0.0;
};

bool
readOptions (int argc, const char* const* argv, PlanesOptions& options)
{
  apps::CommandLine line (
      "pcl_ops_evaluate planes",
      "Tells which planes of two results are one, and how far they are apart. The\n"
      "results are those of clouds in one frame: --planes FILE.json of "
      "pcl_ops_segment\n"
      "or planes.json of pcl_ops_tiles.",
      PCL_OPS_VERSION);
  constexpr double right_angle = 90;
  line.addArgument ("A", options.first_file, "planes, .json");
  line.addArgument ("B", options.second_file, "planes, .json");
  line.addNumber ("rotation-error",
                  "DEG",
                  apps::Range::from (0).upTo (right_angle),
                  options.rotation_error,
                  "how far one frame may be turned against the other (" +
                      decimal (options.rotation_error, 0) + ")");
  line.addNumber ("translation-error",
                  "M",
                  apps::Range::from (0),
                  options.matching.translation_error,
                  "how far it may be moved (" +
                      decimal (options.matching.translation_error, 2) + ")");
  line.addNumber ("min-overlap",
                  "X",
                  apps::Range::from (0).upTo (1),
                  options.matching.min_overlap,
                  "share of the smaller plane that has to lie over the other (" +
                      decimal (options.matching.min_overlap, 1) + ")");
  line.addFlag ("json", options.json, "print JSON instead of a table");
  const bool is_read = line.parse (argc, argv);
  options.matching.rotation_error = apps::toRadians (options.rotation_error);
  return is_read;
}

/** Matched about the middle of the first result: the error of a rotation is about
 * zero. */
PlaneMatches
matchAboutMiddle (std::vector<PlaneSegment> first,
                  std::vector<PlaneSegment> second,
                  const PlaneMatchingParameters& parameters)
{
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const PlaneSegment& plane : first)
    middle += plane.centroid;
  if (!first.empty())
    middle /= static_cast<double> (first.size());
  for (auto* planes : {&first, &second})
    for (PlaneSegment& plane : *planes)
      plane.moveBy (-middle);
  return matchPlanes (first, second, Eigen::Isometry3d::Identity(), parameters);
}

PlaneComparison
comparePlanes (const apps::PlaneList& first,
               const apps::PlaneList& second,
               const PlaneMatchingParameters& parameters)
{
  const PlaneMatches matches =
      matchAboutMiddle (first.planes, second.planes, parameters);
  PlaneComparison comparison;
  std::vector<std::int32_t> partners (first.planes.size(), no_plane);
  for (std::size_t i = 0; i < second.planes.size(); ++i) {
    if (matches.previous[i] == no_plane)
      comparison.only_second.push_back (second.ids[i]);
    else
      partners[static_cast<std::size_t> (matches.previous[i])] =
          static_cast<std::int32_t> (i);
  }
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (partners[i] == no_plane) {
      comparison.only_first.push_back (first.ids[i]);
      continue;
    }
    const auto j = static_cast<std::size_t> (partners[i]);
    const PlaneSegment &one = first.planes[i], &other = second.planes[j];
    comparison.matched.push_back ({i,
                                   j,
                                   apps::toDegrees (angleBetween (one, other)),
                                   one.plane().distance (other.centroid)});
  }
  comparison.angle =
      apps::toDegrees (Eigen::AngleAxisd (matches.pose.linear()).angle());
  comparison.shift = matches.pose.translation().norm();
  return comparison;
}

void
printJson (const apps::PlaneList& first,
           const apps::PlaneList& second,
           const PlaneComparison& comparison)
{
  nlohmann::ordered_json json{{"planes_a", first.planes.size()},
                              {"planes_b", second.planes.size()},
                              {"matched", nlohmann::ordered_json::array()},
                              {"only_a", comparison.only_first},
                              {"only_b", comparison.only_second},
                              {"angle_of_b", comparison.angle},
                              {"shift_of_b", comparison.shift}};
  for (const MatchedPlanes& pair : comparison.matched)
    json["matched"].push_back ({{"a", first.ids[pair.first]},
                                {"b", second.ids[pair.second]},
                                {"angle", pair.angle},
                                {"offset", pair.offset}});
  std::cout << json.dump (2) << '\n';
}

void
printRest (const std::string& file, const Ids& ids)
{
  std::cout << "only in " << file << ':';
  for (const std::uint64_t id : ids)
    std::cout << ' ' << id;
  std::cout << (ids.empty() ? " none\n" : "\n");
}

void
printTable (const PlanesOptions& options,
            const apps::PlaneList& first,
            const apps::PlaneList& second,
            const PlaneComparison& comparison)
{
  TextTable table{
      "Planes in A and B",
      {"A", "B", "orientation", "angle [deg]", "offset [m]", "points A", "points B"},
      {}};
  for (const MatchedPlanes& pair : comparison.matched) {
    const PlaneSegment& one = first.planes[pair.first];
    const PlaneSegment& other = second.planes[pair.second];
    table.rows.push_back ({std::to_string (first.ids[pair.first]),
                           std::to_string (second.ids[pair.second]),
                           toString (one.orientation),
                           decimal (pair.angle, 3),
                           decimal (pair.offset, 4),
                           decimal (one.moments.count, 0),
                           decimal (other.moments.count, 0)});
  }
  std::cout << table;
  printRest (options.first_file, comparison.only_first);
  printRest (options.second_file, comparison.only_second);
  std::cout << "planes agree best with B turned by " << decimal (comparison.angle, 3)
            << " degrees and moved by " << decimal (comparison.shift, 4) << " m\n";
}

} // namespace

int
planesCommand (int argc, const char* const* argv)
{
  PlanesOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  const apps::PlaneList first = apps::loadPlaneList (options.first_file);
  const apps::PlaneList second = apps::loadPlaneList (options.second_file);
  const PlaneComparison comparison = comparePlanes (first, second, options.matching);
  options.json ? printJson (first, second, comparison)
               : printTable (options, first, second, comparison);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
