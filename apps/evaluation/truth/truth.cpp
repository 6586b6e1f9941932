// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth.h"

#include <boost/functional/hash.hpp>

#include <io/output_file.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

/** Change it with the algorithm: truth grown by an older one is then grown anew. */
constexpr std::size_t algorithm_version = 1;

/** Nothing if there is no such file or it is not one of so many points. */
std::optional<PlaneLabels>
readLabels (const std::string& file, std::size_t points)
{
  std::ifstream stream (file, std::ios::binary);
  const std::string bytes (std::istreambuf_iterator<char> (stream), {});
  PlaneLabels labels (points);
  if (bytes.size() != points * sizeof (labels[0]))
    return std::nullopt;
  std::memcpy (labels.data(), bytes.data(), bytes.size());
  return labels;
}

void
writeLabels (const std::string& file, const PlaneLabels& labels)
{
  apps::writeTextFile (file,
                       {reinterpret_cast<const char*> (labels.data()),
                        labels.size() * sizeof (labels[0])});
}

PlaneLabels
grownTruth (const XyzCloud& cloud, const TruthParameters& parameters)
{
  if (parameters.cache_folder.empty())
    return growRegions (cloud, parameters.growing);
  std::error_code ignored;
  fs::create_directories (parameters.cache_folder, ignored);
  const std::string file = (fs::path (parameters.cache_folder) /
                            (truthKey (cloud, parameters.growing) + ".labels"))
                               .string();
  if (const std::optional<PlaneLabels> cached = readLabels (file, cloud.size()))
    return *cached;
  const PlaneLabels labels = growRegions (cloud, parameters.growing);
  writeLabels (file, labels);
  return labels;
}

} // namespace

std::string
truthKey (const XyzCloud& cloud, const RegionGrowingParameters& parameters)
{
  std::size_t hash = algorithm_version;
  boost::hash_combine (hash, parameters.neighbors);
  boost::hash_combine (hash, parameters.distance_threshold);
  boost::hash_combine (hash, parameters.angle_threshold);
  boost::hash_combine (hash, parameters.min_points);
  for (const pcl::PointXYZ& point : cloud)
    for (const float coordinate : {point.x, point.y, point.z})
      boost::hash_combine (hash, coordinate);
  return std::to_string (hash);
}

PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters)
{
  PlaneLabels labels =
      cloud.truth ? *cloud.truth : grownTruth (*cloud.cloud, parameters);
  dropSmallPlanes (labels, parameters.min_points);
  return labels;
}

std::string
truthName (const EvaluationCloud& cloud, const TruthParameters& parameters)
{
  if (cloud.truth)
    return exact_truth;
  return "grown-k" + std::to_string (parameters.growing.neighbors);
}

} // namespace pcl_ops::evaluation
