// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "chosen_planes.h"

#include <cli/errors.h>
#include <detection/plane_json.h>
#include <io/inputs.h>
#include <io/output_file.h>
#include <picture/map_picture.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace pcl_ops::apps {

namespace {

using List = nlohmann::ordered_json;

Eigen::Vector3d
vectorIn (const List& numbers)
{
  return {numbers.at (0).get<double>(),
          numbers.at (1).get<double>(),
          numbers.at (2).get<double>()};
}

/** \brief As far as it can be chosen by. */
PlaneSegment
segmentIn (const List& plane)
{
  PlaneSegment segment;
  segment.normal = vectorIn (plane.at ("normal"));
  segment.centroid = vectorIn (plane.at ("centroid"));
  segment.moments.count = plane.at ("points").get<double>();
  for (const Orientation known :
       {Orientation::Horizontal, Orientation::Vertical, Orientation::Other})
    if (plane.at ("orientation") == toString (known))
      segment.orientation = known;
  return segment;
}

PlaneExtent
extentIn (const List& plane)
{
  PlaneExtent extent;
  extent.area = plane.at ("area").get<double>();
  extent.length = plane.at ("extent").at ("length").get<double>();
  extent.width = plane.at ("extent").at ("width").get<double>();
  return extent;
}

/** \brief Leaves the chosen planes in a list. */
Dropped
choosePlanes (const PlaneChoice& choice, List& list)
{
  const List all = std::move (list.at ("planes"));
  std::vector<PlaneSegment> segments;
  for (const List& plane : all)
    segments.push_back (segmentIn (plane));
  Settings settings;
  Dropped dropped;
  List chosen = List::array();
  for (const std::size_t i : chosenOf (
           choice,
           segments,
           Eigen::Vector3d::UnitZ(),
           [&] (const PlaneSegment& segment) {
             return extentIn (
                 all[static_cast<std::size_t> (&segment - segments.data())]);
           },
           settings,
           dropped))
    chosen.push_back (all[i]);
  if (!dropped.by_option.empty())
    list["dropped"] = toObject (dropped);
  list["planes"] = std::move (chosen);
  return dropped;
}

void
saveImage (const std::string& file, const List& planes)
{
  std::vector<MapShape> shapes;
  for (const List& plane : planes) {
    const PlaneSegment segment = segmentIn (plane);
    shapes.push_back ({plane.at ("id").get<std::uint32_t>(),
                       segment.orientation,
                       segment.centroid.z(),
                       {}});
    for (Rings& rings : polygonsIn (plane))
      std::move (rings.begin(), rings.end(), std::back_inserter (shapes.back().rings));
  }
  savePng (file, mapPicture (std::move (shapes)));
}

std::string
numberOf (std::size_t planes)
{
  return std::to_string (planes) + (planes == 1 ? " plane" : " planes");
}

} // namespace

std::string
saveChosenPlanes (const std::string& list_file, const TilesOptions& options)
try {
  List list = List::parse (readTextFile (list_file, "planes.json"));
  if (options.planes.empty() && options.image.empty())
    return numberOf (list.at ("planes").size());
  const Dropped dropped = choosePlanes (options.choice, list);
  if (!options.image.empty())
    saveImage (options.image, list.at ("planes"));
  if (!options.planes.empty())
    writeTextFile (options.planes, planesFor (options.planes, list, options.map));
  const std::string reasons = dropped.reasons();
  return numberOf (dropped.found) + "; " +
         (options.planes.empty() ? options.image : options.planes) + ": " +
         numberOf (list.at ("planes").size()) +
         (reasons.empty() ? "" : ", dropped " + reasons);
}
catch (const List::exception&) {
  throw WorkError (list_file, "is no list of planes; remove it and run it again");
}

} // namespace pcl_ops::apps
