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

std::string
toJson (const Plan& plan, std::size_t tiles, const std::vector<JoinedPlane>& planes);

struct PlanesOutput {
  /** \brief A list of planes, .json, .csv, .geojson or .gpkg; empty for none. */
  std::string file;
  /** \brief A picture of the planes, .png; empty for none. */
  std::string image;
  /** \brief A page for a browser, .html; empty for none. */
  std::string view;
  /** \brief A floor plan, .dxf, .svg, .geojson or .gpkg; empty for none. */
  std::string floor_plan;
  FloorPlanParameters of_plan;
  PlaneChoice choice;
  MapOptions map;

  /** \brief The requested files, each as a pair of its option and its name. */
  std::vector<std::pair<std::string, std::string>>
  files () const
  {
    std::vector<std::pair<std::string, std::string>> asked_for;
    for (const auto& [option, name] : {std::pair ("--planes", &file),
                                       {"--image", &image},
                                       {"--view", &view},
                                       {"--floor-plan", &floor_plan}})
      if (!name->empty())
        asked_for.emplace_back (option, *name);
    return asked_for;
  }
};

/** \brief Messages about the planes of a run and the files written from them. */
struct PlanesSaid {
  /** \brief Text: how many planes were found, and how many were written. */
  std::string counts;
  /** \brief "plan.dxf: 12 walls, 3 rooms, 41.2 m2" */
  std::vector<std::string> written;
  std::vector<ResultWarning> warnings;
};

/** \brief Writes the requested files from the planes of a run.
 * \param[in] list_file the list of all planes
 * \param[in] points all points with their labels, which are the ids of the planes
 * \throws WorkError if the list cannot be read or the file cannot be written */
PlanesSaid
saveChosenPlanes (const std::string& list_file,
                  const LabelledPoints& points,
                  const PlanesOutput& output);

} // namespace pcl_ops::apps
