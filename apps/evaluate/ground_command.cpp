// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// The command ground: compares planes taken for the ground with true classes of points.
#include <pcl/common/point_tests.h>

#include "answer.h"
#include "commands.h"
#include "labeled_clouds.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/plane_extent.h>

#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

/** Numbers of classes of points, such as road or building. */
using Classes = std::set<std::uint32_t>;

/** Returns the texts between the commas of a list. An empty list, and a comma at the
 * end of a list, give an empty text. */
std::vector<std::string>
partsOf (const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream text (list + ",");
  for (std::string part; std::getline (text, part, ',');)
    parts.push_back (part);
  return parts;
}

/** \param[in] list class numbers, separated by commas
 * \throw UsageError that names the option if the list has anything else */
Classes
classesIn (const std::string& option, const std::string& list)
{
  Classes classes;
  for (const std::string& part : partsOf (list))
    classes.insert (parseNumber<std::uint32_t> (option, part, from (0)));
  return classes;
}

/** \param[in] list names of kinds of planes, separated by commas
 * \throw UsageError if a name is unknown, or is there twice */
std::set<PlaneKind>
kindsIn (const std::string& list)
{
  std::set<PlaneKind> kinds;
  for (const std::string& part : partsOf (list)) {
    bool is_new_kind = false;
    for (int kind = 0; kind <= int (PlaneKind::Other); ++kind)
      if (part == toString (PlaneKind (kind)))
        is_new_kind = kinds.insert (PlaneKind (kind)).second;
    if (!is_new_kind)
      throw UsageError ("--kinds",
                        "'" + part +
                            "' is no kind, or there twice; give some of floor, ramp, "
                            "slab, table, roof, ceiling, wall and other");
  }
  return kinds;
}

/** What counts as ground, in the truth and in the result. */
struct GroundRules {
  // Defaults are the classes of SemanticKITTI as they are used for Patchwork++ (Lee,
  // Lim & Myung, IROS 2022, section IV-A).
  /** True classes of the ground: road, parking, sidewalk, other ground, lane marking,
   * terrain. */
  Classes ground = {40, 44, 48, 49, 60, 72};
  /** True classes whose points do not count: unlabeled, outlier, vegetation. */
  Classes ignored = {0, 1, 70};
  /** Kinds of planes of the result that are taken for the ground. */
  std::set<PlaneKind> kinds = {PlaneKind::Floor, PlaneKind::Ramp};
  /** Direction against gravity, a unit vector. */
  Vector3d up = Vector3d::UnitZ();
};

/** Returns for each point whether it is on a plane of one of GroundRules::kinds. */
std::vector<bool>
groundFound (const LabeledCloud& result, const GroundRules& rules)
{
  const PlaneIds ids = planeIds (result.labels);
  const std::vector<PlaneSegment> planes = planesOf (*result.cloud, ids, {rules.up});
  std::vector<PlaneExtent> extents;
  for (const PlaneSegment& plane : planes)
    extents.push_back (planeExtent (*result.cloud, plane));
  const std::vector<PlaneKind> kinds = planeKinds (planes, extents, rules.up);
  std::vector<bool> is_ground;
  for (const std::uint32_t id : ids.of_point)
    is_ground.push_back (id != PlaneIds::none && rules.kinds.count (kinds[id]) > 0);
  return is_ground;
}

/** Numbers of points of a true class. */
struct ClassCounts {
  std::size_t points = 0;
  /** Points on planes that are taken for the ground. */
  std::size_t as_ground = 0;
};

using CountsByClass = std::map<std::uint32_t, ClassCounts>;

/** Counts the finite points.
 * \param[in] is_ground for each point, whether the result has it on the ground */
CountsByClass
countsByClass (const LabeledCloud& truth, const std::vector<bool>& is_ground)
{
  CountsByClass counts;
  for (std::size_t i = 0; i < is_ground.size(); ++i) {
    if (!pcl::isXYZFinite ((*truth.cloud)[i]))
      continue;
    ClassCounts& of_class = counts[truth.labels[i]];
    ++of_class.points;
    of_class.as_ground += is_ground[i] ? 1 : 0;
  }
  return counts;
}

/** Returns part / whole; NaN, which is printed as -, if whole is 0. */
double
shareOf (std::size_t part, std::size_t whole)
{
  return whole > 0 ? double (part) / double (whole)
                   : std::numeric_limits<double>::quiet_NaN();
}

Answer
answerOf (const CountsByClass& counts, const GroundRules& rules)
{
  ClassCounts ground;
  ClassCounts other;
  ClassCounts ignored;
  Answer by_class = Answer::array();
  for (const auto& [number, of_class] : counts) {
    const bool is_ignored = rules.ignored.count (number) > 0;
    const bool is_ground = rules.ground.count (number) > 0;
    ClassCounts& sum = is_ignored ? ignored : is_ground ? ground : other;
    sum.points += of_class.points;
    sum.as_ground += of_class.as_ground;
    by_class.push_back ({{"class", number},
                         {"truth",
                          is_ignored  ? "ignored"
                          : is_ground ? "ground"
                                      : "other"},
                         {"points", of_class.points},
                         {"as_ground", shareOf (of_class.as_ground, of_class.points)}});
  }
  const std::size_t result_ground = ground.as_ground + other.as_ground;
  return {{"points", ground.points + other.points},
          {"points_ignored", ignored.points},
          {"truth_ground", ground.points},
          {"result_ground", result_ground},
          {"precision", shareOf (ground.as_ground, result_ground)},
          {"recall", shareOf (ground.as_ground, ground.points)},
          {"f_score", shareOf (2 * ground.as_ground, result_ground + ground.points)},
          {"iou", shareOf (ground.as_ground, ground.points + other.as_ground)},
          {"by_class", by_class}};
}

/** Declares the options for classes and kinds. */
void
declareRules (CommandLine& line, GroundRules& rules)
{
  line.add ("classes LIST",
            [&rules] (const std::string& list) {
              rules.ground = classesIn ("--classes", list);
            })
      .help ("true classes that are the ground (40,44,48,49,60,72)");
  line.add ("ignore LIST",
            [&rules] (const std::string& list) {
              rules.ignored = classesIn ("--ignore", list);
            })
      .help ("true classes that do not count (0,1,70)");
  line.add ("kinds LIST",
            [&rules] (const std::string& list) { rules.kinds = kindsIn (list); })
      .help ("kinds of planes taken for the ground (floor,ramp)");
}

} // namespace

int
groundCommand (int argc, const char* const* argv)
{
  std::string truth_file;
  std::string result_file;
  GroundRules rules;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  bool prints_json = false;
  CommandLine line (
      "pcl_ops_evaluate ground",
      "Tells how well the ground is found: points of the true classes of the ground\n"
      "beside those on planes that are floors or ramps by their kind.",
      PCL_OPS_VERSION);
  line.addArgument ("TRUTH", truth_file, "the true classes, field label");
  line.addArgument (
      "RESULT", result_file, "planes found in the same points, field label");
  declareRules (line, rules);
  line.addUpAxis (up).help ("direction against gravity; camera: 0,-1,0 (0,0,1)");
  line.add ("json", prints_json).help ("print JSON instead of text");
  if (!line.parse (argc, argv))
    return ExitCode::done;
  rules.up = up.cast<double>().normalized();
  constexpr std::size_t min_class_points = 1; // keeps all classes
  const auto [truth, result] =
      loadLabeledClouds (truth_file, result_file, min_class_points);
  const Answer answer =
      answerOf (countsByClass (truth, groundFound (result, rules)), rules);
  if (answer.at ("truth_ground") == 0)
    throw WorkError (truth_file,
                     "has no point of the classes of the ground that --ignore lets "
                     "count; name some of its own by --classes");
  print (answer, prints_json);
  return ExitCode::done;
}

} // namespace pcl_ops::evaluation
