// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/result_warnings.h>

#include <string>
#include <vector>

using namespace pcl_ops;

namespace {

/** \brief Points of surfaces with the planes that a detector finds in these. */
struct LabelledPlaneScene {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  std::vector<PlaneSegment> planes;
  RandomGenerator generator = RandomGenerator (seedOfTest());

  /** \brief Adds a surface with so many points, a plane of its own unless it is none.
   */
  LabelledPlaneScene&
  add (const Surface& surface, std::size_t points, double noise, bool is_plane = true)
  {
    PlaneSegment plane;
    plane.centroid = plane.moments.origin = surface.center();
    plane.normal = surface.normal();
    for (std::size_t i = 0; i < points; ++i) {
      const Eigen::Vector3d point = drawPointOf (surface, noise, generator);
      const Eigen::Vector3d offset = point - plane.centroid;
      plane.moments.add (offset.x(), offset.y(), offset.z());
      plane.inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
      cloud.push_back (toPoint (point));
    }
    plane.noise = noise;
    plane.orientation =
        orientationOf (plane.normal, Eigen::Vector3d::UnitZ(), paper_angle_tolerance);
    if (is_plane)
      planes.push_back (plane);
    return *this;
  }

  std::vector<ResultWarning>
  warnings (const ResultContext& context = ResultContext()) const
  {
    return resultWarnings (cloud, planes, context);
  }

  /** \brief "thick-planes unit" */
  std::string
  codes (const ResultContext& context = ResultContext()) const
  {
    std::string codes;
    for (const ResultWarning& warning : warnings (context))
      codes += (codes.empty() ? "" : " ") + warning.code;
    return codes;
  }
};

const Surface floor_of_room = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
const Surface wall_of_room = {{0, 3, 0}, {4, 0, 0}, {0, 0, 2.5}};

LabelledPlaneScene
roomOfTwoPlanes ()
{
  return LabelledPlaneScene()
      .add (floor_of_room, 3000, 2_mm)
      .add (wall_of_room, 2500, 2_mm);
}

} // namespace

TEST (ResultWarnings, AreNoneOfAnOrdinaryRoom)
{
  EXPECT_EQ (roomOfTwoPlanes().codes(), "");
}

TEST (ResultWarnings, AreNoneOfNoPoints)
{
  EXPECT_TRUE (resultWarnings ({}, {}).empty());
}

TEST (ResultWarnings, SayThatPlanesAreThickerThanThreeNoises)
{
  LabelledPlaneScene hill;
  hill.add ({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, 3000, 1.0);
  hill.planes[0].noise = 0.06;
  ASSERT_EQ (hill.codes(), "thick-planes");
  const std::string text = hill.warnings()[0].text;
  EXPECT_NE (text.find ("100 % of the points on planes"), std::string::npos) << text;
  EXPECT_NE (text.find ("; for thinner planes give --threshold 0.18"),
             std::string::npos)
      << text;
}

TEST (ResultWarnings, NameParametersAsPythonDoes)
{
  LabelledPlaneScene hill;
  hill.add ({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, 3000, 1.0);
  hill.planes[0].noise = 0.06;
  ResultContext context;
  context.names = ParameterNames::Python;
  ASSERT_EQ (hill.codes (context), "thick-planes");
  const std::string text = hill.warnings (context)[0].text;
  EXPECT_NE (text.find ("give distance_threshold=0.18"), std::string::npos) << text;
}
