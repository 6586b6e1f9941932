// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include <benchmark/measures.h>
#include <simulation/scenes.h>

namespace {

using namespace pcl_ops::benchmark;
using Eigen::Vector3d;
using pcl_ops::apps::Random;
using pcl_ops::simulation::scanDensely;
using pcl_ops::simulation::Scene;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr std::size_t points = 10'000; // of each cloud, where no other number is said

Cloud::Ptr
scanOf (const Scene& scene, double noise_scale, std::size_t number = points)
{
  const Cloud::Ptr cloud (new Cloud);
  pcl::copyPointCloud (scanDensely (scene, number, noise_scale, 1).cloud, *cloud);
  return cloud;
}

/** A measure that takes these times, one after the other [ms]. */
Measure
measureTaking (const std::string& name, std::vector<double> times)
{
  const std::size_t runs = times.size();
  return {name, runs, [times, next = std::size_t (0)] () mutable {
            pcl_ops::StageDurations durations;
            durations.detection = times[next++];
            return durations;
          }};
}

TEST (Measures, TakeTurnsAndTheShortestRunCounts)
{
  std::string told;
  const std::vector<Measure> measured = measureInTurns (
      {measureTaking ("a", {5.0, 2.0, 4.0}),
       measureTaking ("b", {7.0, 7.0}),
       measureTaking ("c", {2.0 * max_repeated_time, 1.0})}, // too long for more
      [&] (const std::string& what) { told += what; });
  EXPECT_EQ (told, "abcaba");
  EXPECT_EQ (measured[0].shortest.detection, 2.0);
  EXPECT_EQ (measured[0].runs, 3u);
  EXPECT_EQ (measured[2].runs, 1u);
}

TEST (Boards, EachIsAPlaneOfItsOwn)
{
  const auto scan = scanDensely (makeBoards (10), 5000, 0.0, 1);
  EXPECT_EQ (scan.planes.size(), 10u);
  const auto isOfLast = [] (const auto& point) { return point.label == 10; };
  EXPECT_EQ (std::count_if (scan.cloud.begin(), scan.cloud.end(), isOfLast), 500);
}

/** Draws a point in a cube around the origin. */
Vector3d
inCube (Random& random, double edge)
{
  const Vector3d half = Vector3d::Constant (0.5 * edge);
  return random.inBox (-half, half);
}

template <typename Draw>
Cloud::Ptr
cloudOf (const Draw& draw)
{
  Random random (1);
  const Cloud::Ptr cloud (new Cloud);
  for (std::size_t i = 0; i < points; ++i) {
    const Vector3d point = draw (random, i);
    cloud->emplace_back().getVector3fMap() = point.cast<float>();
  }
  return cloud;
}

/** Returns points in cubes of all sizes.
 * \param[in] lowest, highest decimal logarithms of half the edge of a cube [m] */
Cloud::Ptr
logUniform (double lowest, double highest)
{
  return cloudOf ([=] (Random& random, std::size_t) -> Vector3d {
    return std::pow (10.0, random.between (lowest, highest)) * inCube (random, 2.0);
  });
}

/** Clouds that may be slow: noise, planes without noise, very many planes, points on
 * all scales, and equal points. */
std::vector<std::pair<const char*, Cloud::Ptr>>
worstClouds ()
{
  constexpr double width = 4.0; // of a room [m]
  const auto noise =
      cloudOf ([] (Random& random, std::size_t) { return inCube (random, width); });
  return {{"noise in a cube", noise},
          {"exact plane", // tilted, so that no voxel has a face along it
           cloudOf ([] (Random& random, std::size_t) -> Vector3d {
             const Vector3d p = inCube (random, width);
             return {p.x(), p.y(), 0.3 * p.x() + 0.2 * p.y() + 1.0};
           })},
          {"10 exact planes", scanOf (makeBoards (10), 0.0)},
          {"lattice", cloudOf ([] (Random&, std::size_t i) -> Vector3d {
             constexpr std::size_t edge = 22; // points along each axis
             const Vector3d cell (
                 double (i % edge), double (i / edge % edge), double (i / edge / edge));
             return width / edge * cell;
           })},
          {"1000 planes", scanOf (makeBoards (1000), 1.0)},
          {"log-uniform points", logUniform (-6.0, 6.0)},
          {"log-uniform, apart", logUniform (1.0, 12.0)},
          {"points in one voxel", // eight far points make the voxels wide
           cloudOf ([] (Random& random, std::size_t i) -> Vector3d {
             return i < 8 ? 1e6 * Vector3d (i & 1, i >> 1 & 1, i >> 2 & 1)
                          : inCube (random, 0.01);
           })},
          {"equal points",
           cloudOf ([] (Random&, std::size_t) { return Vector3d (1, 2, 3); })},
          {"equal by the hundred", cloudOf ([&] (Random&, std::size_t i) -> Vector3d {
             return (*noise)[i / 100].getVector3fMap().cast<double>();
           })}};
}

/** \brief Returns a cloud with a change applied to each point. */
template <typename Change>
Cloud::Ptr
changed (const Cloud& cloud, const Change& change)
{
  const Cloud::Ptr other (new Cloud (cloud));
  for (std::size_t i = 0; i < other->size(); ++i)
    change (i, (*other)[i]);
  return other;
}

/** \brief Returns the processor time of all threads of a run [ms]. */
double
processorTimeOf (const Configuration& detector, const Cloud::Ptr& cloud)
{
  double time = 0.0;
  pcl_ops::evaluation::timed (
      time, [&] { detector.run (cloud, {}); }, CLOCK_PROCESS_CPUTIME_ID);
  return time;
}

// No cloud costs a detector more than 60 times the time or 10 times the memory of a
// simulated room of as many points.
TEST (WorstCases, TakeBoundedMultiplesOfTheTimeAndMemoryOfARoom)
{
  // Three times what the slowest takes, kht-80-800 on 10 exact planes, as other
  // programs run beside the tests.
  constexpr double time_bound = 60.0;
  constexpr double memory_bound = 10.0;
  const Cloud::Ptr room = scanOf (pcl_ops::simulation::makeRoom (1).scene, 1.0);
  const auto clouds = worstClouds();
  for (const auto& detector : pcl_ops::evaluation::selectConfigurations (
           "ops,ops-3-30,fspf,fspf-0.07-0.14,kht,kht-80-800")) {
    const auto measureOn = [&] (const Cloud::Ptr& cloud) {
      return Measure{"", 3, [&detector, cloud] {
                       pcl_ops::StageDurations durations;
                       durations.detection = processorTimeOf (detector, cloud);
                       return durations;
                     }};
    };
    const double room_bytes = peakMemoryOn (room, detector);
    EXPECT_GT (room_bytes, 4.0 * points); // labels of four bytes
    for (const auto& [name, cloud] : clouds) {
      SCOPED_TRACE (detector.name + " on " + name);
      const std::vector<Measure> measured = measureInTurns (
          {measureOn (room), measureOn (cloud)}, [] (const std::string&) {});
      EXPECT_LT (measured[1].shortest.detection,
                 time_bound * measured[0].shortest.detection);
      EXPECT_LT (peakMemoryOn (cloud, detector), memory_bound * room_bytes);
    }
  }
}

// Quadratic growth with the number of points does not show with few points.
TEST (WorstCases, DoNotGrowWithTheSquareOfTheNumberOfEqualOrFarPoints)
{
  constexpr double time_bound = 10.0;
  constexpr std::size_t many = 100'000;
  const Cloud::Ptr room = scanOf (pcl_ops::simulation::makeRoom (1).scene, 1.0, many);
  const auto scaled = [&] (float factor) {
    return changed (*room, [=] (std::size_t, pcl::PointXYZ& point) {
      point.getVector3fMap() *= factor;
    });
  };
  const pcl::PointXYZ position (1.0f, 2.0f, 3.0f);
  const std::pair<const char*, Cloud::Ptr> clouds[] = {
      {"half of them equal",
       changed (*room,
                [&] (std::size_t i, pcl::PointXYZ& point) {
                  if (i % 2 == 0)
                    point = position;
                })},
      {"all equal",
       changed (*room, [&] (std::size_t, pcl::PointXYZ& point) { point = position; })},
      {"squares beyond single precision", scaled (1e30f)},
      {"squares below single precision", scaled (1e-25f)}};
  for (const auto& detector : pcl_ops::evaluation::selectConfigurations ("ops-3-30")) {
    for (const auto& [name, cloud] : clouds) {
      const double of_room = processorTimeOf (detector, room);
      EXPECT_LT (processorTimeOf (detector, cloud), time_bound * of_room) << name;
    }
  }
}

} // namespace
