// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "segment_program.h"

#include <cmath>

namespace {

/** \brief The floor and the wall with a second wall at y = 2 m, x becoming up: the
 * sensor looks along the longest side. */
InputCloud
roomLyingOnItsSide ()
{
  InputCloud cloud;
  const auto add = [&] (float x, float y, float z) {
    // What was up, z, is x now.
    cloud.push_back ({z, x, y, static_cast<float> (cloud.size())});
  };
  constexpr float step = 0.04f;
  for (float x = 0; x < 4; x += step)
    for (float y = 0; y < 2; y += step)
      add (x, y, 0);
  for (float x = 0; x < 4; x += step)
    for (float z = step; z < 1.6f; z += step)
      add (x, 2, z);
  for (float y = 0; y < 2; y += step)
    for (float z = step; z < 1.6f; z += step)
      add (4, y, z);
  cloud.sensor_origin_ = Eigen::Vector4f (1.3f, -1.0f, 0.8f, 0.0f);
  return cloud;
}

/** \brief A run that looks for the up axis, with what it wrote to planes.json. */
struct UpRun {
  Outcome outcome;
  nlohmann::json json;

  Eigen::Vector3d
  up () const
  {
    const auto numbers = json["parameters"]["up"].get<std::vector<double>>();
    return Eigen::Vector3d (numbers[0], numbers[1], numbers[2]);
  }
};

class SegmentUp : public Segment {
protected:
  UpRun
  findUp (const InputCloud& cloud, const std::string& options = "") const
  {
    pcl::io::savePCDFileBinary (folder_ / "cloud.pcd", cloud);
    const Outcome done =
        expectDone ("cloud.pcd --up auto --planes planes.json " + options);
    return {done, jsonIn ("planes.json")};
  }
};

} // namespace

TEST_F (SegmentUp, IsFoundAndNamesThePlanes)
{
  const UpRun run = findUp (roomLyingOnItsSide());
  EXPECT_GE (run.up().x(), 0.999) << run.outcome.out;
  EXPECT_GE (run.json["parameters"]["up_confidence"], 0.7);
  EXPECT_TRUE (contains (run.outcome.out, "Up axis: 1,"));
  EXPECT_TRUE (contains (run.outcome.out, "confidence"));
  for (const auto& plane : run.json["planes"]) {
    const bool is_floor = std::abs (plane["normal"][0].get<double>()) > 0.9;
    EXPECT_EQ (plane["orientation"], is_floor ? "horizontal" : "vertical");
  }
}

TEST_F (SegmentUp, IsTheSameForEveryMethodAndPreset)
{
  for (const char* options :
       {"--preset paper", "--method fspf", "--method kht", "--threads 2"})
    EXPECT_EQ (findUp (roomLyingOnItsSide(), options).up(),
               findUp (roomLyingOnItsSide()).up())
        << options;
}

TEST_F (SegmentUp, SaysWhenThePlanesCannotTell)
{
  InputCloud wall;
  for (int x = 0; x < 60; ++x)
    for (int y = 0; y < 60; ++y)
      wall.push_back (
          {0.04f * static_cast<float> (x), 0.04f * static_cast<float> (y), 2.0f, 0.0f});
  const UpRun run = findUp (wall);
  EXPECT_EQ (run.up(), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE (run.json["parameters"]["up_confidence"].is_null());
  EXPECT_TRUE (contains (run.outcome.out, "cannot tell, 0,0,1 is used"));
}

TEST_F (SegmentUp, IsNotGuessedWhereTheViewpointIsNotTheSensors)
{
  // From below the floor, which then stands before all the rest.
  InputCloud cloud = roomLyingOnItsSide();
  cloud.sensor_origin_ = Eigen::Vector4f (-2.0f, 2.0f, 1.0f, 0.0f);
  const UpRun run = findUp (cloud);
  EXPECT_EQ (run.up(), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE (run.json["parameters"]["up_confidence"].is_null());
  EXPECT_TRUE (contains (run.outcome.out, "not seen from its VIEWPOINT"));
}

TEST_F (SegmentUp, IsSuggestedWhereThePlanesAreSureOfAnother)
{
  const std::string hint = "planes suggest that up is 1.00, 0.00, 0.00: --up auto";
  const auto says_so = [&] (const std::string& options) {
    return contains (expectDone ("cloud.pcd " + options).out, hint);
  };
  pcl::io::savePCDFileBinary (folder_ / "cloud.pcd", roomLyingOnItsSide());
  const auto suggested = jsonOf ("cloud.pcd --planes p.json")["suggested_up"];
  EXPECT_NEAR (suggested[0].get<double>(), 1.0, 0.01);
  EXPECT_FALSE (
      jsonOf ("cloud.pcd --up 1,0,0 --planes p.json").contains ("suggested_up"));
  EXPECT_TRUE (says_so (""));
  EXPECT_TRUE (says_so ("--output-dir planes"));
  EXPECT_FALSE (says_so ("--up 0,0,1"));
  EXPECT_FALSE (says_so ("--up camera"));
  EXPECT_FALSE (says_so ("--up auto"));
  EXPECT_FALSE (says_so ("--method kht"));
}

TEST_F (SegmentUp, IsNotSuggestedWhereItIsTheOneUsedOrNobodyKnows)
{
  InputCloud upright = roomLyingOnItsSide();
  for (pcl::PointXYZI& point : upright)
    point.getVector3fMap() = Eigen::Vector3f (point.y, point.z, point.x);
  upright.sensor_origin_ = Eigen::Vector4f (-1.0f, 0.8f, 1.3f, 0.0f);
  InputCloud elsewhere = roomLyingOnItsSide();
  elsewhere.sensor_origin_ = Eigen::Vector4f (-2.0f, 2.0f, 1.0f, 0.0f);
  for (const InputCloud& cloud : {upright, elsewhere}) {
    pcl::io::savePCDFileBinary (folder_ / "cloud.pcd", cloud);
    EXPECT_FALSE (contains (expectDone ("cloud.pcd").out, "suggest"));
  }
}

TEST_F (SegmentUp, IsNotLookedForUnlessAsked)
{
  const auto json = jsonOf ("in.pcd --planes planes.json", "planes.json");
  EXPECT_FALSE (json["parameters"].contains ("up_confidence"));
}
