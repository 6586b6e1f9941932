// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <Eigen/Eigenvalues>

#include "paper/oriented_points.h"
#include "scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Angle by which rounding to single precision may turn a normal [rad]. */
constexpr double max_angle_by_rounding = 1e-5;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief \ref orientSamples with the neighbors of PCL's kd-tree over the cloud.
 * \param[in] sample indices of points of the cloud
 * \param[in] k number of neighbors
 * \param[in] sigma of the weights [m]; not given: the distance to the k-th neighbor */
OrientedSamples
orient (const Cloud::ConstPtr& cloud,
        const Indices& sample,
        int k = 30,
        std::optional<double> sigma = std::nullopt)
{
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud);
  pcl_ops::detail::NeighborSearch search;
  search.nearest =
      [&] (pcl::index_t point, int number, auto& neighbors, auto& squared_distances) {
        tree.nearestKSearch ((*cloud)[point], number, neighbors, squared_distances);
      };
  const pcl_ops::CloudView view (*cloud);
  const Points points = finitePoints (view, one_thread);
  return orientSamples (view, points, sample, search, k, sigma);
}

/** \brief The matrix M_i of the paper for one sample, see \ref orientSamples, over its
 * k nearest points: found by sorting all points by distance.
 * \param[in] given_sigma if there is none, sigma is the distance to the k-th nearest
 * point [m] */
Eigen::Matrix3d
scatterByBruteForce (const Cloud& cloud,
                     std::size_t sample,
                     std::size_t k,
                     std::optional<double> given_sigma)
{
  const Eigen::Vector3d p = cloud[sample].getVector3fMap().cast<double>();
  std::vector<Eigen::Vector3d> q; // all points relative to p, nearest first
  for (const pcl::PointXYZ& point : cloud)
    q.push_back (point.getVector3fMap().cast<double>() - p);
  std::sort (q.begin(), q.end(), [] (const auto& first, const auto& second) {
    return first.squaredNorm() < second.squaredNorm();
  });
  const double sigma = given_sigma.value_or (q[k].norm());
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (std::size_t j = 1; j <= k; ++j) // 0 is the sample itself
    m += std::exp (-q[j].squaredNorm() / (2 * sigma * sigma)) * q[j] *
         q[j].transpose() / q[j].squaredNorm();
  return m;
}

/** \brief Five points of a line, 1 m apart; the middle one, point 2, is not finite. */
struct LineOfPoints {
  LineOfPoints()
  {
    for (int i = 0; i < 5; ++i)
      cloud.push_back ({static_cast<float> (i), 0, 0});
    cloud[2].x = NAN;
    input.cloud = pcl_ops::CloudView (cloud);
    points = finitePoints (input.cloud, one_thread);
  }

  pcl::PointCloud<pcl::PointXYZ> cloud;
  /** \brief All points, without a search of the user. */
  pcl_ops::detail::DetectorInput input{{}, nullptr, Eigen::Vector3d::Zero(), nullptr};
  /** \brief The four finite points. */
  Points points;
};

} // namespace

TEST (DrawSample, DrawsTheGivenShareOfPointsInAscendingOrderAndEachOnce)
{
  for (const double rate : {0.001, 0.03, 0.5, 1.0}) {
    const Indices sample = drawSample (10000, rate, seedOfTest());
    EXPECT_EQ (sample.size(), static_cast<std::size_t> (10000 * rate));
    // By less_equal a list with two equal numbers is not sorted.
    EXPECT_TRUE (std::is_sorted (
        sample.begin(), sample.end(), std::less_equal<std::uint32_t>()));
    EXPECT_LT (sample.back(), 10000u);
  }
}

TEST (DrawSample, DrawsNothingFromNothingAndAllFromAll)
{
  EXPECT_TRUE (drawSample (0, 0.5, 1).empty());
  EXPECT_TRUE (drawSample (10, 0.01, 1).empty()) << "a tenth of a point";
  EXPECT_EQ (drawSample (3, 1.0, 1), (Indices{0, 1, 2}));
  EXPECT_EQ (drawSample (3, 2.0, 1), (Indices{0, 1, 2})) << "a rate above 1";
}

TEST (DrawSample, GivesEveryPointTheSameChance)
{
  constexpr double rate = 0.25;
  constexpr std::size_t points = 20;
  constexpr std::uint32_t samples = 10000;
  constexpr double expected = rate * samples;
  std::vector<int> times_drawn (points, 0);
  for (std::uint32_t seed = 0; seed < samples; ++seed)
    for (const std::uint32_t i : drawSample (points, rate, seed))
      ++times_drawn[i];
  double chi_square = 0.0;
  for (const int count : times_drawn)
    chi_square += (count - expected) * (count - expected) / (expected * (1.0 - rate));
  EXPECT_LT (chi_square, 43.8)
      << "the 99.9 % quantile of chi-square with 19 degrees of freedom";
}

TEST (OrientSamples, GivesTheNormalOfTheMatrixOfThePaper)
{
  const auto cloud = Scene().floor (1_m, 1_m).noise (1_cm).build().cloud;
  const Indices sample = drawSample (cloud->size(), 0.1, 1);
  constexpr int k = 20;
  for (const auto& sigma : {std::optional<double>(), {10_cm}}) {
    const OrientedSamples samples = orient (cloud, sample, k, sigma);
    ASSERT_EQ (samples.size(), sample.size());
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const Eigen::Matrix3d m = scatterByBruteForce (*cloud, sample[i], k, sigma);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> ascending (m);
      const Eigen::Vector3d expected = ascending.eigenvectors().col (0);
      EXPECT_LT (angleBetween (samples.normals[i], expected), max_angle_by_rounding);
    }
  }
}

TEST (OrientSamples, SkipsNeighborsEqualToTheSampleAndLeavesOutASampleOnALine)
{
  const auto cloud = Scene().floor (1_m, 1_m).build().cloud;
  constexpr std::uint32_t on_floor = 0; // and five points that are equal to it
  cloud->insert (cloud->end(), 5, pcl::PointXYZ (cloud->front()));
  const auto on_line = static_cast<std::uint32_t> (cloud->size() + 50);
  for (int i = 0; i < 100; ++i) // a line far from the floor
    cloud->push_back ({10.0f + 0.01f * i, 20.0f + 0.02f * i, 30.0f - 0.03f * i});
  const OrientedSamples samples = orient (cloud, {on_floor, on_line}, 20);
  ASSERT_EQ (samples.size(), 1u) << "the one on the floor";
  EXPECT_LT (angleBetween (samples.normals[0], Eigen::Vector3d::UnitZ()),
             max_angle_by_rounding);
}

TEST (OrientSamples, UsesAllPointsOfACloudWithFewerThanK)
{
  const auto cloud = pcl::make_shared<Cloud>();
  for (const float x : {0.0f, 1.0f})
    for (const float y : {0.0f, 1.0f})
      cloud->push_back ({x, y, 5});
  for (const int k : {30, std::numeric_limits<int>::max()}) {
    const OrientedSamples samples = orient (cloud, {0, 1, 2, 3}, k);
    ASSERT_EQ (samples.size(), 4u);
    EXPECT_LT (angleBetween (samples.normals[0], Eigen::Vector3d::UnitZ()),
               max_angle_by_rounding);
  }
}

TEST (NormalOfScatter, IsZeroForAMatrixOfRankOneOrZero)
{
  const Eigen::Vector3d along_line (1.0 / 3.0, -0.7, 0.2);
  EXPECT_TRUE (normalOfScatter (Eigen::Matrix3d::Zero()).isZero());
  EXPECT_TRUE (normalOfScatter (along_line * along_line.transpose()).isZero());
  EXPECT_TRUE (normalOfScatter (1e12 * along_line * along_line.transpose()).isZero());
}

TEST (GroupByOrientation, PutsEverySampleIntoOneGroup)
{
  OrientedSamples samples;
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d (0, 0, 1),
                                        Eigen::Vector3d (1, 0, 0),
                                        Eigen::Vector3d (0.6, 0, 0.8), // 37 degrees
                                        Eigen::Vector3d (0, 0, -1)})
    samples.add ({0, 0, 0}, normal);
  const std::array<Indices, 3> groups =
      groupByOrientation (samples, Eigen::Vector3d::UnitZ(), 7_deg);
  EXPECT_EQ (groups[0], (Indices{0, 3})) << "horizontal";
  EXPECT_EQ (groups[1], (Indices{1})) << "vertical";
  EXPECT_EQ (groups[2], (Indices{2})) << "other";
}

TEST (SearchOver, FindsTheNearestAmongTheFinitePoints)
{
  const LineOfPoints line;
  pcl::Indices neighbors;
  std::vector<float> squared_distances;
  constexpr unsigned threads = 2;
  const NeighborSearch search = searchOver (line.input, line.points, threads);
  constexpr pcl::index_t point = 3;
  constexpr int number = 3;
  search.nearest (point, number, neighbors, squared_distances);
  std::sort (neighbors.begin(), neighbors.end());
  EXPECT_EQ (neighbors, (pcl::Indices{1, 3, 4})) << "not 2, which is not finite";
  EXPECT_EQ (search.threads, threads);
}

TEST (SearchOver, IsTheUsersSearchOverTheFinitePointsWhereThereIsOne)
{
  constexpr unsigned threads_of_user = 77; // tells the search of the user from others
  LineOfPoints line;
  pcl::Indices searched;
  line.input.search_over = [&] (const pcl::Indices& finite) {
    searched = finite;
    NeighborSearch search;
    search.threads = threads_of_user;
    return search;
  };
  EXPECT_EQ (searchOver (line.input, line.points, one_thread).threads, threads_of_user);
  EXPECT_EQ (searched, (pcl::Indices{0, 1, 3, 4}));
}
