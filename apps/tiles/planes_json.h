// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "plane_joining.h"
#include <detection/plane_choice.h>
#include <detection/plane_list.h>

namespace pcl_ops::apps {

std::string
toJson (const Plan& plan, std::size_t tiles, const std::vector<JoinedPlane>& planes);

struct PlanesOutput {
  /** \brief .json, .csv or .geojson; empty for nowhere. */
  std::string file;
  /** \brief A picture of them, .png; empty for nowhere. */
  std::string image;
  PlaneChoice choice;
  MapOptions map;
};

/** \brief Writes the planes of --planes, if there is such a file.
 * \param[in] list_file the list of all planes
 * \return how many there are, and how many of them were written, in words
 * \throws WorkError if the list cannot be read or the file cannot be written */
std::string
saveChosenPlanes (const std::string& list_file, const PlanesOutput& output);

} // namespace pcl_ops::apps
