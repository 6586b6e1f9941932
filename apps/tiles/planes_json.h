// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "plane_joining.h"
#include "plane_sample.h"
#include <detection/plane_choice.h>
#include <detection/plane_list.h>
#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/result_warnings.h>

namespace pcl_ops::apps {

/** \brief Returns the text of planes.json, without warnings.
 * \param[in] plan of the run (Plan), no floor plan
 * \param[in] tiles number of tiles that have points */
std::string
toJson (const Plan& plan, std::size_t tiles, const std::vector<JoinedPlane>& planes);

/** \brief An option that names an output file, and the file. */
struct RequestedFile {
  std::string option;
  std::string name;
};

/** \brief Options for the files that are written from the list of planes. */
struct PlanesOutput {
  /** \brief File of a list of planes, .json, .csv, .geojson or .gpkg; empty for none.
   */
  std::string planes;
  /** \brief A picture of the planes, .png; empty for none. */
  std::string image;
  /** \brief A page for a browser, .html; empty for none. */
  std::string view;
  /** \brief A floor plan, .dxf, .svg, .geojson or .gpkg; empty for none. */
  std::string floor_plan;
  FloorPlanParameters of_floor_plan;
  /** \brief Which planes to write. */
  PlaneChoice choice;
  MapOptions map;

  /** \brief Returns the files that are not empty, in the order above. */
  std::vector<RequestedFile>
  files () const
  {
    std::vector<RequestedFile> requested;
    for (const RequestedFile& file : {RequestedFile{"--planes", planes},
                                      {"--image", image},
                                      {"--view", view},
                                      {"--floor-plan", floor_plan}})
      if (!file.name.empty())
        requested.push_back (file);
    return requested;
  }
};

/** \brief Messages about the planes of a run and the files written from them. */
struct PlaneMessages {
  /** \brief How many planes were found, and how many were written, in words. */
  std::string counts;
  /** \brief Contents of files: "plan.dxf: 12 walls, 3 rooms, 41.2 m2". */
  std::vector<std::string> file_notes;
  /** \brief The warnings of the list, and one on the floor plan. */
  std::vector<ResultWarning> warnings;
};

/** \brief Writes the requested files from the planes of a run.
 * \param[in] list_file the list of all planes
 * \param[in] for_each_point visits all points; labels are the ids of the planes
 * \throws WorkError if the list cannot be read or a file cannot be written */
PlaneMessages
saveChosenPlanes (const std::string& list_file,
                  const ForEachLabeledPoint& for_each_point,
                  const PlanesOutput& output);

} // namespace pcl_ops::apps
