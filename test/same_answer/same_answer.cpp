// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Prints a hash of the labels that each detector gives the points of simulated clouds,
// a line each: what two builds are to agree on (scripts/check). It fails if labels
// depend on the number of threads, or if there are none.
#include <evaluation/data/data_sets.h>
#include <evaluation/detectors/detectors.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>

namespace {

using namespace pcl_ops;
using evaluation::PlaneLabels;
using evaluation::XyzCloud;

/** \brief FNV-1a of numbers without gaps between them. */
template <typename Numbers>
std::uint64_t
hashOf (const Numbers& numbers)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*> (numbers.data());
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (std::size_t i = 0; i < numbers.size() * sizeof (*numbers.data()); ++i)
    hash = (hash ^ bytes[i]) * 0x100000001B3u;
  return hash;
}

void
printLine (const std::string& cloud,
           const std::string& what,
           std::size_t number,
           std::uint64_t hash)
{
  std::cout << std::left << std::setw (16) << cloud << std::setw (12) << what
            << std::right << std::dec << std::setw (8) << number << ' ' << std::hex
            << std::setfill ('0') << std::setw (16) << hash << std::setfill (' ')
            << std::endl;
}

/** \param[in,out] all_planes their number is added
 * \return whether they are the same on one thread and on three */
template <typename Detector>
bool
check (const std::string& name,
       typename Detector::Parameters parameters,
       const std::string& cloud_name,
       const XyzCloud::ConstPtr& cloud,
       std::size_t& all_planes)
{
  const auto labels_with = [&] (unsigned threads) {
    parameters.threads = threads;
    return evaluation::runDetector<Detector> (parameters, cloud).labels;
  };
  const PlaneLabels labels = labels_with (3);
  const std::uint32_t planes = *std::max_element (labels.begin(), labels.end());
  printLine (cloud_name, name, planes, hashOf (labels));
  all_planes += planes;
  if (labels == labels_with (1))
    return true;
  std::cerr << cloud_name << ", " << name << ": other planes on one thread\n";
  return false;
}

/** \brief The same of all detectors, by default and as in their papers. */
bool
checkAll (const std::string& name, const XyzCloud::ConstPtr& cloud)
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
  using Kht = KernelHoughTransform<pcl::PointXYZ>;
  printLine (name, "points", cloud->size(), hashOf (cloud->points));
  std::size_t planes = 0;
  const std::array<bool, 6> checks{
      check<Ops> ("ops", {}, name, cloud, planes),
      check<Ops> ("ops paper", Ops::Parameters::paper(), name, cloud, planes),
      check<Fspf> ("fspf", {}, name, cloud, planes),
      check<Fspf> ("fspf paper", Fspf::Parameters::paper(), name, cloud, planes),
      check<Kht> ("kht", {}, name, cloud, planes),
      check<Kht> ("kht paper", Kht::Parameters::paper(), name, cloud, planes)};
  if (planes == 0)
    std::cerr << name << ": no planes\n";
  return planes > 0 &&
         std::all_of (checks.begin(), checks.end(), [] (bool same) { return same; });
}

} // namespace

int
main ()
{
  bool is_good = true;
  for (const char* text : {"rooms:401-403",
                           "rooms-raw:404",
                           "furniture:1",
                           "shapes:1",
                           "survey:1",
                           "simulated:200000"})
    for (const evaluation::CloudSource& source :
         evaluation::dataSetOf (text, Eigen::Vector3d::UnitZ()))
      is_good = checkAll (source.name, source.load().cloud) && is_good;
  return is_good ? 0 : 1;
}
