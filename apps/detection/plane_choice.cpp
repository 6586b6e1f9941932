// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_choice.h"

#include <cli/command_line.h>
#include <cli/errors.h>
#include <detection/plane_json.h>
#include <numbers/angles.h>
#include <pcl_ops/orientation.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief An option of a length or an area. */
struct SizeOption {
  const char *name, *placeholder;
  std::optional<double> PlaneChoice::*size;
  const char* help;
};

constexpr SizeOption sizes[] = {
    {"min-area", "M2", &PlaneChoice::min_area, "smallest area inside the outline"},
    {"min-width",
     "M",
     &PlaneChoice::min_width,
     "smallest width of the rectangle around it"},
    {"max-area", "M2", &PlaneChoice::max_area, "largest area"},
    {"max-width", "M", &PlaneChoice::max_width, "largest width"}};

/** \brief An option as keys of reports are called. */
std::string
underscored (std::string option)
{
  std::replace (option.begin(), option.end(), '-', '_');
  return option;
}

PlaneFilter
filterOf (const PlaneChoice& choice, const Eigen::Vector3d& up)
{
  PlaneFilter filter;
  filter.up_axis = up;
  filter.orientation = orientationCalled (choice.only);
  filter.max_planes = choice.max_planes;
  if (choice.only == "largest")
    filter.max_planes = 1;
  if (choice.direction)
    filter.direction = choice.direction->cast<double>();
  filter.direction_tolerance = toRadians (choice.within);
  filter.min_points = choice.min_points.value_or (filter.min_points);
  filter.min_area = choice.min_area.value_or (filter.min_area);
  filter.min_width = choice.min_width.value_or (filter.min_width);
  filter.max_area = choice.max_area;
  filter.max_width = choice.max_width;
  filter.size = choice.size;
  if (choice.slope)
    filter.slope = {toRadians ((*choice.slope)[0]), toRadians ((*choice.slope)[1])};
  return filter;
}

/** \brief Adds numbers that were given as one option. */
template <std::size_t count>
void
addSetting (const char* name,
            const std::optional<std::array<double, count>>& numbers,
            Settings& settings)
{
  if (numbers)
    settings[name] = *numbers;
}

/** \brief Adds what the planes were chosen by. */
void
addSettings (const PlaneChoice& choice, const PlaneFilter& filter, Settings& settings)
{
  if (!choice.only.empty())
    settings["only"] = choice.only;
  if (filter.direction) {
    settings["direction"] = *filter.direction;
    settings["within"] = choice.within;
  }
  addSetting ("slope", choice.slope, settings);
  if (choice.min_points)
    settings["min_points"] = filter.min_points;
  for (const auto& [name, placeholder, size, help] : sizes)
    if (choice.*size)
      settings[underscored (name)] = *(choice.*size);
  addSetting ("size", choice.size, settings);
  if (choice.max_planes)
    settings["max_planes"] = *choice.max_planes;
}

Dropped
droppedOf (const PlaneChoice& choice, std::size_t found, const DroppedPlanes& dropped)
{
  Dropped result{found, {}};
  const bool is_largest = choice.only == "largest";
  const std::vector<std::pair<std::string, std::size_t>> counts = {
      {"only", dropped.by_orientation + (is_largest ? dropped.by_number : 0)},
      {"direction", dropped.by_direction},
      {"slope", dropped.by_slope},
      {"min-points", dropped.by_points},
      {"min-area", dropped.by_area},
      {"min-width", dropped.by_width},
      {"max-area", dropped.by_max_area},
      {"max-width", dropped.by_max_width},
      {"size", dropped.by_size},
      {"max-planes", is_largest ? 0 : dropped.by_number}};
  for (const auto& [option, count] : counts)
    if (count > 0)
      result.by_option.emplace_back (option, count);
  return result;
}

/** \brief Declares an option of several numbers in a range. */
template <std::size_t count>
void
addNumbers (CommandLine& line,
            const std::string& name,
            const std::string& placeholder,
            const Range& range,
            std::optional<std::array<double, count>>& target,
            const std::string& help)
{
  line.addValue (name, placeholder, help, [=, &target] (const std::string& text) {
    const std::string option = "--" + name;
    std::array<double, count> numbers{};
    std::istringstream parts (text + ",");
    std::string part;
    for (double& number : numbers) {
      if (!std::getline (parts, part, ','))
        throw UsageError (option, text + " is not " + placeholder + "; give just that");
      number = parseNumber<double> (option, part, range);
    }
    if (std::getline (parts, part))
      throw UsageError (option, text + " is not " + placeholder + "; give just that");
    target = numbers;
  });
}

std::string
adviceOn (const PlaneChoice& choice, const Dropped& dropped)
{
  const std::string found = std::to_string (dropped.found);
  const auto& [option, count] = dropped.by_option.front();
  if (option == "only" && count == dropped.found)
    return "none of the " + found + " planes found is " + choice.only +
           ": leave out --only, or change --up or --angle-tolerance";
  return "all " + found + " planes found are dropped, " + dropped.reasons() +
         ": leave an option out or ask for less";
}

} // namespace

std::string
Dropped::reasons() const
{
  std::string text;
  for (const auto& [option, count] : by_option)
    text += (text.empty() ? "" : ", ") + std::to_string (count) + " by --" + option;
  return text;
}

void
declareChoice (CommandLine& line, PlaneChoice& choice)
{
  constexpr double right_angle = 90;
  line.beginGroup (title_of_choice);
  line.addChoice ("only",
                  {"horizontal", "vertical", "other", "largest"},
                  choice.only,
                  "horizontal, vertical, other or largest only",
                  "WHICH");
  line.addDirection ("direction",
                     choice.direction,
                     "planes whose normal points along it, or against it");
  line.addNumber ("within",
                  "DEG",
                  Range::from (0).upTo (right_angle),
                  choice.within,
                  "largest angle of a normal to --direction (10)");
  addNumbers (line,
              "slope",
              "MIN,MAX",
              Range::from (0).upTo (right_angle),
              choice.slope,
              "angles to the horizontal from MIN to MAX degrees");
  line.addNumber (
      "min-points", "N", Range::from (0), choice.min_points, "fewest points");
  for (const auto& [name, placeholder, size, help] : sizes)
    line.addNumber (name, placeholder, Range::from (0), choice.*size, help);
  addNumbers (line,
              "size",
              "W,H,TOLERANCE",
              Range::from (0),
              choice.size,
              "rectangles of W by H, each within TOLERANCE");
  line.addNumber ("max-planes",
                  "N",
                  Range::from (1),
                  choice.max_planes,
                  "the N largest of those the others leave");
}

void
checkChoice (const CommandLine& line, const PlaneChoice& choice)
{
  if (choice.max_area && *choice.max_area < choice.min_area.value_or (0.0))
    throw UsageError ("--max-area", "is below --min-area; raise it");
  if (choice.max_width && *choice.max_width < choice.min_width.value_or (0.0))
    throw UsageError ("--max-width", "is below --min-width; raise it");
  if (choice.slope && (*choice.slope)[1] < (*choice.slope)[0])
    throw UsageError ("--slope", "ends below where it begins; give MIN,MAX");
  if (line.isGiven ("within") && !line.isGiven ("direction"))
    throw UsageError ("--within", "is about --direction x,y,z; give it, too");
}

std::vector<std::size_t>
chosenOf (const PlaneChoice& choice,
          const std::vector<PlaneSegment>& planes,
          const Eigen::Vector3d& up,
          const ExtentOfPlane& extent_of,
          Settings& settings,
          Dropped& dropped)
{
  const PlaneFilter filter = filterOf (choice, up);
  addSettings (choice, filter, settings);
  DroppedPlanes counts;
  std::vector<std::size_t> kept = keptPlanes (planes, filter, extent_of, counts);
  dropped = droppedOf (choice, planes.size(), counts);
  return kept;
}

Dropped
keepChosen (const PlaneChoice& choice,
            const ExtentOfPlane& extent_of,
            Detected& detected)
{
  Dropped dropped;
  std::vector<PlaneSegment> kept;
  for (const std::size_t i : chosenOf (choice,
                                       detected.planes,
                                       detected.up.cast<double>(),
                                       extent_of,
                                       detected.settings,
                                       dropped))
    kept.push_back (std::move (detected.planes[i]));
  detected.planes = std::move (kept);
  if (detected.planes.empty() && dropped.found > 0)
    detected.advice = adviceOn (choice, dropped);
  return dropped;
}

nlohmann::ordered_json
toObject (const Dropped& dropped)
{
  nlohmann::ordered_json object;
  object["of"] = dropped.found;
  for (const auto& [option, count] : dropped.by_option)
    object["by"][underscored (option)] = count;
  return object;
}

} // namespace pcl_ops::apps
