// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_page.h"

#include "page.h"
#include <detection/methods.h>
#include <detection/plane_list.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/visibility.h>
#include <picture/colors.h>
#include <picture/view.h>

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

/** \brief Returns the "planes" of the description. */
Json
coloredPlanes (const PlanePage& page)
{
  Json planes = page.objects;
  for (Json& plane : planes)
    plane["color"] = webColor (colorOfLabel (plane.at ("id").get<std::uint32_t>()));
  return planes;
}

/** \brief Returns the "edges" of the description. */
Json
edgesOf (const PlanePage& page)
{
  const ShiftedCloud& shifted = page.shifted;
  Json edges = Json::array();
  for (const PlaneEdge& edge :
       findPlaneEdges (*shifted.cloud, page.planes, {}, shifted.shift).edges)
    edges.push_back ({{"from", edge.from}, {"to", edge.to}});
  return edges;
}

/** \brief Returns the description that \ref savePage takes. */
Json
descriptionOf (const PlanePage& page)
{
  // Of the view only its direction is used, which does not depend on the size.
  constexpr int width = 4, height = 3;
  const XyzCloud& cloud = *page.shifted.cloud;
  const View view = chooseView (cloud, page.planes, page.up, width, height);
  const Eigen::Vector3d up = page.up.cast<double>().normalized();
  const Eigen::Vector3d to_eye = -view.axes.row (2).transpose().cast<double>();
  Json description;
  description["title"] = page.title;
  description["up"] = up;
  description["view"] = to_eye;
  // Where no position of a sensor is known, normals do not tell which side was seen:
  // then planes are shown from behind, too.
  description["backs"] = !page.samples.empty() || !isSeenFromItsOrigin (cloud);
  description["planes"] = coloredPlanes (page);
  description["edges"] = edgesOf (page);
  return description;
}

} // namespace

Json
planeObjects (const std::vector<PlaneSegment>& planes,
              const std::vector<PlaneExtent>& extents,
              const std::vector<PlaneKind>& kinds,
              const std::vector<std::uint32_t>& ids,
              const Eigen::Vector3f& up)
{
  const Eigen::Vector3d upwards = up.cast<double>().normalized();
  Json objects = Json::array();
  for (std::size_t i = 0; i < planes.size(); ++i)
    objects.push_back (planeObject (ids[i], planes[i], extents[i], kinds[i], upwards));
  return objects;
}

void
savePlanePage (const std::string& file, const PlanePage& page)
{
  // The title may be a file name that is not UTF-8.
  const std::string description =
      descriptionOf (page).dump (-1, ' ', false, Json::error_handler_t::replace);
  if (!page.samples.empty())
    return savePage (
        file, description, toGroups (page.samples), Eigen::Vector3d::Zero());
  const XyzCloud& cloud = *page.shifted.cloud;
  const auto position_of = [&] (std::size_t i) -> Eigen::Vector3d {
    return cloud[i].getVector3fMap().cast<double>();
  };
  savePage (file,
            description,
            groupPoints (
                labelsOf (page.planes, cloud.size()), page.planes.size(), position_of),
            page.shifted.shift);
}

} // namespace pcl_ops::apps
