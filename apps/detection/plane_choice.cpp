// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_choice.h"

#include <cli/command_line.h>
#include <cli/errors.h>
#include <detection/plane_list.h>
#include <numbers/angles.h>

#include <algorithm>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief The names that --only takes, for messages. */
constexpr const char* names_of_only = "horizontal, vertical or other (how a plane "
                                      "lies); floor, ceiling, wall, slab, roof, "
                                      "ramp or table (what it is); or largest";

/** \brief Returns the parts of a list that commas separate. */
std::vector<std::string>
namesIn (const std::string& list)
{
  std::vector<std::string> names;
  std::istringstream parts (list);
  for (std::string part; std::getline (parts, part, ',');)
    names.push_back (part);
  return names;
}

/** \brief Checks the value of --only.
 * \throws UsageError if it is no list of known names, or has "largest" and others */
void
checkOnly (const std::string& list)
{
  const std::vector<std::string> names = namesIn (list);
  for (const std::string& name : names) {
    if (!orientationCalled (name) && !kindCalled (name) && name != "largest")
      throw UsageError ("--only",
                        "'" + name + "' is unknown; give some of " + names_of_only);
    if (name == "largest" && names.size() > 1)
      throw UsageError ("--only", "largest goes with no other; give --max-planes 1");
  }
  if (names.empty() || list.back() == ',')
    throw UsageError ("--only", "'" + list + "' is no list; give wall,roof");
}

/** \brief Whether a plane has one of the named orientations or kinds. The name "other"
 * is an orientation, not a kind. */
bool
isNamed (const std::vector<std::string>& names,
         const PlaneSegment& plane,
         const std::optional<PlaneKind>& kind)
{
  return std::any_of (names.begin(), names.end(), [&] (const std::string& name) {
    if (const auto orientation = orientationCalled (name))
      return plane.orientation == *orientation;
    return kind && kindCalled (name) == kind;
  });
}

/** \brief What an option was set to and what it did. */
struct OptionReport {
  /** \brief Its name without "--". */
  const char* option;
  /** \brief Its value. */
  Settings setting;
  /** \brief Number of planes that it dropped. */
  std::size_t dropped;
};

/** \brief Returns a report on each option, in the order in which they drop planes. An
 * exception is --only largest: it comes first, but drops planes last.
 * \param[in] by_condition how many planes the filter dropped by each condition
 * \param[in] not_named number of planes that --only does not name */
std::vector<OptionReport>
reportsOn (const PlaneChoice& choice,
           const DroppedPlanes& by_condition,
           std::size_t not_named)
{
  const PlaneFilter& filter = choice.filter;
  // For "largest" the number of planes of the filter is 1 (filterOf).
  const std::size_t not_largest = choice.only == "largest" ? by_condition.by_number : 0;
  return {
      {"only", choice.only, not_named + not_largest},
      {"direction",
       filter.direction.value_or (Eigen::Vector3d::Zero()),
       by_condition.by_direction},
      {"within", choice.within, 0},
      {"slope", choice.slope.value_or (std::array<double, 2>()), by_condition.by_slope},
      {"min-points", filter.min_points, by_condition.by_points},
      {"min-area", filter.min_area, by_condition.by_area},
      {"min-width", filter.min_width, by_condition.by_width},
      {"max-area", filter.max_area.value_or (0.0), by_condition.by_max_area},
      {"max-width", filter.max_width.value_or (0.0), by_condition.by_max_width},
      {"size", filter.size.value_or (std::array<double, 3>()), by_condition.by_size},
      {"max-planes",
       filter.max_planes.value_or (0),
       by_condition.by_number - not_largest}};
}

/** \brief Declares an option that takes a list of numbers.
 * \param[in] usage such as "slope MIN,MAX"
 * \param[out] target gets the numbers when the command line is parsed
 * \param[in] range allowed values of each number */
template <std::size_t count>
Option&
addNumbers (CommandLine& line,
            const std::string& usage,
            std::optional<std::array<double, count>>& target,
            const Range& range)
{
  return line.add (usage, [=, &target] (const std::string& text) {
    const std::string name = nameOf (usage);
    target = parseNumbers<double, count> (
        "--" + name,
        text,
        range,
        text + " is not " + usage.substr (name.size() + 1) + "; give just that");
  });
}

/** \brief Returns Detected::advice for a choice that dropped all planes found. */
std::string
adviceOnChoice (const PlaneChoice& choice, const Dropped& dropped)
{
  const std::string found = std::to_string (dropped.found);
  const Dropped::ByOption& first = dropped.by_option.front();
  if (first.option == "only" && first.planes == dropped.found)
    return "none of the " + found + " planes found is " +
           boost::replace_all_copy (choice.only, ",", " or ") +
           ": leave out --only, or change --up or --angle-tolerance";
  return "all " + found + " planes found are dropped, " + dropped.reasons() +
         ": leave an option out or ask for less";
}

} // namespace

bool
PlaneChoice::namesKinds() const
{
  const std::vector<std::string> names = namesIn (only);
  return std::any_of (names.begin(), names.end(), [] (const std::string& name) {
    return !orientationCalled (name) && kindCalled (name);
  });
}

std::string
Dropped::reasons() const
{
  std::string text;
  for (const auto& [option, planes] : by_option)
    text += (text.empty() ? "" : ", ") + std::to_string (planes) + " by --" + option;
  return text;
}

void
declareChoice (CommandLine& line, PlaneChoice& choice)
{
  constexpr double right_angle = 90; // [degree]
  PlaneFilter& filter = choice.filter;
  line.beginGroup (title_of_choice);
  line.add ("only WHICH",
            [&choice] (const std::string& text) {
              checkOnly (text);
              choice.only = text;
            })
      .help ("horizontal, vertical, other; wall, roof ...; or largest");
  line.add ("direction x,y,z",
            [&filter] (const std::string& text) {
              filter.direction = parseDirection ("--direction", text).cast<double>();
            })
      .help ("planes whose normal points along it, or against it");
  line.add ("within DEG", choice.within, from (0).upTo (right_angle))
      .help ("largest angle of a normal to --direction (10)");
  addNumbers (line, "slope MIN,MAX", choice.slope, from (0).upTo (right_angle))
      .help ("angles to the horizontal from MIN to MAX degrees");
  const Range not_negative = from (0);
  line.add ("min-points N", filter.min_points, not_negative).help ("fewest points");
  line.add ("min-area M2", filter.min_area, not_negative)
      .help ("smallest area inside the outline");
  line.add ("min-width M", filter.min_width, not_negative)
      .help ("smallest width of the rectangle around it");
  line.add ("max-area M2", filter.max_area, not_negative).help ("largest area");
  line.add ("max-width M", filter.max_width, not_negative).help ("largest width");
  addNumbers (line, "size W,H,TOLERANCE", filter.size, not_negative)
      .help ("rectangles of W by H, each within TOLERANCE");
  line.add ("max-planes N", filter.max_planes, from (1))
      .help ("the N largest of those the others leave");
}

void
finishChoice (const CommandLine& line, PlaneChoice& choice)
{
  const PlaneFilter& filter = choice.filter;
  if (filter.max_area && *filter.max_area < filter.min_area)
    throw UsageError ("--max-area", "is below --min-area; raise it");
  if (filter.max_width && *filter.max_width < filter.min_width)
    throw UsageError ("--max-width", "is below --min-width; raise it");
  const bool has_reversed_slope =
      choice.slope && (*choice.slope)[1] < (*choice.slope)[0];
  if (has_reversed_slope)
    throw UsageError ("--slope", "ends below where it begins; give MIN,MAX");
  if (line.isGiven ("within") && !line.isGiven ("direction"))
    throw UsageError ("--within", "is about --direction x,y,z; give it, too");
  // Nothing is dropped yet: of the reports only names and values are used.
  for (const OptionReport& report : reportsOn (choice, {}, 0)) {
    const std::string option = report.option;
    // The value of --within is reported whenever --direction is given.
    if (line.isGiven (option == "within" ? "direction" : option))
      choice.given[keyOf (option)] = report.setting;
  }
}

namespace {

/** \brief Returns PlaneChoice::filter with what it takes from other options: the up
 * axis, and what --only, --within and --slope say, in radians. */
PlaneFilter
filterOf (const PlaneChoice& choice, const Eigen::Vector3d& up)
{
  PlaneFilter filter = choice.filter;
  filter.up_axis = up;
  if (choice.only == "largest")
    filter.max_planes = 1;
  filter.direction_tolerance = toRadians (choice.within);
  if (choice.slope)
    filter.slope = {toRadians ((*choice.slope)[0]), toRadians ((*choice.slope)[1])};
  return filter;
}

} // namespace

std::vector<std::size_t>
chosenOf (const PlaneChoice& choice,
          const std::vector<PlaneSegment>& planes,
          const std::vector<PlaneKind>& kinds,
          const Eigen::Vector3d& up,
          const ExtentOfPlane& extent_of,
          Dropped& dropped)
{
  const std::vector<std::string> names =
      choice.only == "largest" ? std::vector<std::string>() : namesIn (choice.only);
  std::vector<PlaneSegment> named;
  std::vector<std::size_t> index_of_named;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::optional<PlaneKind> kind =
        kinds.empty() ? std::nullopt : std::optional<PlaneKind> (kinds[i]);
    if (names.empty() || isNamed (names, planes[i], kind)) {
      named.push_back (planes[i]);
      index_of_named.push_back (i);
    }
  }
  // keptPlanes passes elements of named: their address tells their index.
  const auto extent_of_named = [&] (const PlaneSegment& plane) {
    return extent_of (planes[index_of_named[std::size_t (&plane - named.data())]]);
  };
  DroppedPlanes by_filter;
  std::vector<std::size_t> kept =
      keptPlanes (named, filterOf (choice, up), extent_of_named, by_filter);
  for (std::size_t& index : kept)
    index = index_of_named[index];
  dropped = {planes.size(), {}};
  const std::size_t not_named = planes.size() - named.size();
  for (const OptionReport& report : reportsOn (choice, by_filter, not_named))
    if (report.dropped > 0)
      dropped.by_option.push_back ({report.option, report.dropped});
  return kept;
}

Dropped
keepChosen (const PlaneChoice& choice,
            const ExtentOfPlane& extent_of,
            Detected& detected)
{
  Dropped dropped;
  std::vector<PlaneSegment> kept;
  std::vector<std::size_t> lies_on;
  std::vector<PlaneKind> kinds;
  std::vector<PlaneExtent> extents;
  std::vector<PlaneMove> moves;
  detected.settings.update (choice.given);
  for (const std::size_t i : chosenOf (choice,
                                       detected.planes,
                                       detected.kinds,
                                       detected.up.cast<double>(),
                                       extent_of,
                                       dropped)) {
    kept.push_back (std::move (detected.planes[i]));
    if (!detected.kinds.empty())
      kinds.push_back (detected.kinds[i]);
    if (!detected.extents.empty())
      extents.push_back (std::move (detected.extents[i]));
    if (!detected.moves.empty())
      moves.push_back (detected.moves[i]);
    if (!detected.lies_on.empty())
      lies_on.push_back (detected.lies_on[i]);
  }
  detected.planes = std::move (kept);
  detected.kinds = std::move (kinds);
  detected.extents = std::move (extents);
  detected.moves = std::move (moves);
  detected.lies_on = std::move (lies_on);
  if (detected.planes.empty() && dropped.found > 0)
    detected.advice = adviceOnChoice (choice, dropped);
  return dropped;
}

nlohmann::ordered_json
toObject (const Dropped& dropped)
{
  nlohmann::ordered_json object;
  object["of"] = dropped.found;
  for (const auto& [option, planes] : dropped.by_option)
    object["by"][keyOf (option)] = planes;
  return object;
}

} // namespace pcl_ops::apps
