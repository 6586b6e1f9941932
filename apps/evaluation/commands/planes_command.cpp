// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes_command.h"

#include <cli/command_line.h>
#include <cli/program.h>
#include <detection/plane_list.h>
#include <evaluation/metrics/plane_comparison.h>
#include <evaluation/report/text_table.h>
#include <nlohmann/json.hpp>
#include <numbers/angles.h>

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

std::vector<std::uint64_t>
idsAt (const std::vector<std::size_t>& positions, const apps::PlaneList& list)
{
  std::vector<std::uint64_t> ids;
  for (const std::size_t position : positions)
    ids.push_back (list.ids[position]);
  return ids;
}

void
printJson (const apps::PlaneList& first,
           const apps::PlaneList& second,
           const PlaneComparison& comparison)
{
  nlohmann::ordered_json json{{"planes_a", first.planes.size()},
                              {"planes_b", second.planes.size()},
                              {"matched", nlohmann::ordered_json::array()},
                              {"only_a", idsAt (comparison.only_first, first)},
                              {"only_b", idsAt (comparison.only_second, second)},
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
printRest (const std::string& file,
           const std::vector<std::size_t>& positions,
           const apps::PlaneList& list)
{
  std::cout << "only in " << file << ':';
  for (const std::uint64_t id : idsAt (positions, list))
    std::cout << ' ' << id;
  std::cout << (positions.empty() ? " none\n" : "\n");
}

std::string
pointsOf (const PlaneSegment& plane)
{
  return decimal (plane.moments.count, 0);
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
    table.rows.push_back ({std::to_string (first.ids[pair.first]),
                           std::to_string (second.ids[pair.second]),
                           toString (one.orientation),
                           decimal (pair.angle, 3),
                           decimal (pair.offset, 4),
                           pointsOf (one),
                           pointsOf (second.planes[pair.second])});
  }
  std::cout << table;
  printRest (options.first_file, comparison.only_first, first);
  printRest (options.second_file, comparison.only_second, second);
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
  const PlaneComparison comparison =
      comparePlanes (first.planes, second.planes, options.matching);
  options.json ? printJson (first, second, comparison)
               : printTable (options, first, second, comparison);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
