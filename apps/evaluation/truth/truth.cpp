// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth.h"

#include <io/output_file.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

/** Change it with the algorithm: truth grown by an older one is then grown anew. */
constexpr std::uint64_t algorithm_version = 1;

/** FNV-1a, 64 bits (Fowler, Noll & Vo). */
class Hash {
public:
  template <typename T>
  void
  add (const T& value)
  {
    const auto* const bytes = reinterpret_cast<const unsigned char*> (&value);
    for (std::size_t i = 0; i < sizeof (T); ++i)
      value_ = (value_ ^ bytes[i]) * 0x100000001b3u;
  }

  std::string
  hex () const
  {
    std::ostringstream text;
    text << std::hex << std::setfill ('0') << std::setw (16) << value_;
    return text.str();
  }

private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

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
  Hash hash;
  hash.add (algorithm_version);
  hash.add (parameters.neighbors);
  hash.add (parameters.distance_threshold);
  hash.add (parameters.angle_threshold);
  hash.add (parameters.min_points);
  for (const pcl::PointXYZ& point : cloud) {
    hash.add (point.x);
    hash.add (point.y);
    hash.add (point.z);
  }
  return hash.hex();
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
