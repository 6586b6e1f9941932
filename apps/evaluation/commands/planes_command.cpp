// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/program.h>
#include <detection/plane_json.h>
#include <evaluation/report/answer.h>
#include <numbers/angles.h>
#include <pcl_ops/plane_matching.h>

#include <algorithm>
#include <map>

namespace pcl_ops::evaluation {

namespace {

/** Matched about the middle of the first result: the error of a rotation is about
 * zero. */
PlaneMatches
matchAboutMiddle (std::vector<PlaneSegment> first,
                  std::vector<PlaneSegment> second,
                  const PlaneMatchingParameters& parameters)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const PlaneSegment& plane : first)
    sum += plane.centroid;
  for (auto* planes : {&first, &second})
    for (PlaneSegment& plane : *planes)
      plane.moveBy (-sum / double (std::max<std::size_t> (1, first.size())));
  return matchPlanes (first, second, Eigen::Isometry3d::Identity(), parameters);
}

/** What two results have in common. Angles and offsets are those of the planes as they
 * are. */
Answer
comparePlanes (const apps::PlaneList& first,
               const apps::PlaneList& second,
               const PlaneMatchingParameters& parameters)
{
  const PlaneMatches matches =
      matchAboutMiddle (first.planes, second.planes, parameters);
  std::map<std::size_t, std::size_t> partner_of;
  Answer matched = Answer::array(), only_a = matched, only_b = matched;
  for (std::size_t i = 0; i < second.planes.size(); ++i)
    if (matches.previous[i] == no_plane)
      only_b.push_back (second.ids[i]);
    else
      partner_of[std::size_t (matches.previous[i])] = i;
  for (std::size_t i = 0; i < first.planes.size(); ++i) {
    const auto partner = partner_of.find (i);
    if (partner == partner_of.end()) {
      only_a.push_back (first.ids[i]);
      continue;
    }
    const PlaneSegment &one = first.planes[i], &other = second.planes[partner->second];
    matched.push_back ({{"a", first.ids[i]},
                        {"b", second.ids[partner->second]},
                        {"orientation", toString (one.orientation)},
                        {"angle", apps::toDegrees (angleBetween (one, other))},
                        {"offset", one.plane().distance (other.centroid)},
                        {"points_a", std::size_t (one.moments.count)},
                        {"points_b", std::size_t (other.moments.count)}});
  }
  const double angle = Eigen::AngleAxisd (matches.pose.linear()).angle();
  return {{"planes_a", first.planes.size()},
          {"planes_b", second.planes.size()},
          {"matched", matched},
          {"only_a", only_a},
          {"only_b", only_b},
          {"angle_of_b", apps::toDegrees (angle)},
          {"shift_of_b", matches.pose.translation().norm()}};
}

} // namespace

int
planesCommand (int argc, const char* const* argv)
{
  std::string first, second;
  PlaneMatchingParameters matching;
  double rotation_error = apps::toDegrees (matching.rotation_error);
  bool json = false;
  apps::CommandLine line (
      "pcl_ops_evaluate planes",
      "Tells which planes of two results are one, and how far they are apart. The\n"
      "results are those of clouds in one frame: --planes FILE.json of "
      "pcl_ops_segment\n"
      "or planes.json of pcl_ops_tiles.",
      PCL_OPS_VERSION);
  line.addArgument ("A", first, "planes, .json");
  line.addArgument ("B", second, "planes, .json");
  line.addNumber ("rotation-error",
                  "DEG",
                  apps::Range::from (0).upTo (90),
                  rotation_error,
                  "how far one frame may be turned against the other (" +
                      decimal (rotation_error, 0) + ")");
  line.addNumber ("translation-error",
                  "M",
                  apps::Range::from (0),
                  matching.translation_error,
                  "how far it may be moved (" +
                      decimal (matching.translation_error, 2) + ")");
  line.addNumber ("min-overlap",
                  "X",
                  apps::Range::from (0).upTo (1),
                  matching.min_overlap,
                  "share of the smaller plane that has to lie over the other (" +
                      decimal (matching.min_overlap, 1) + ")");
  line.addFlag ("json", json, "print JSON instead of text");
  if (!line.parse (argc, argv))
    return apps::ExitCode::done;
  matching.rotation_error = apps::toRadians (rotation_error);
  const apps::PlaneList planes = apps::loadPlaneList (first);
  print (comparePlanes (planes, apps::loadPlaneList (second), matching), json);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
