// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "labeled_clouds.h"

#include <pcl/common/common.h>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

#include <cli/errors.h>
#include <cli/program.h>
#include <io/cloud_file.h>

#include <cmath>
#include <limits>

namespace pcl_ops::evaluation {

using namespace apps;

std::vector<double>
labelNumbersIn (const pcl::PCLPointCloud2& cloud,
                const std::string& file,
                const std::string& name)
{
  const int index = pcl::getFieldIndex (cloud, name);
  if (index < 0)
    throw WorkError (file, "has no field " + name + "; give a cloud with labels");
  const pcl::PCLPointField& field = cloud.fields[std::size_t (index)];
  const NumberType& type = numberType (field.datatype);
  // Columns of text files are read as doubles, which are allowed, too.
  const bool is_integer = type.kind != 'F' && type.size <= 4;
  if (!is_integer && field.datatype != pcl::PCLPointField::FLOAT64)
    throw WorkError (file,
                     "its " + name + " is no integer of up to 4 bytes; convert it");
  std::vector<double> numbers (sizeOf (cloud));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = type.read (&cloud.data[i * cloud.point_step + field.offset]);
  return numbers;
}

PlaneLabels
labelsIn (const pcl::PCLPointCloud2& cloud,
          const std::string& file,
          const std::string& name)
{
  constexpr double largest = std::numeric_limits<std::uint32_t>::max();
  const std::vector<double> numbers = labelNumbersIn (cloud, file, name);
  PlaneLabels labels (numbers.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double label = numbers[i];
    if (!(label >= 0.0 && label <= largest && label == std::floor (label)))
      throw WorkError (file,
                       "point " + std::to_string (i) + ": its " + name +
                           " is no whole number from 0 on; 0 means " +
                           (name == "label" ? "no plane" : "that it counts"));
    labels[i] = std::uint32_t (label);
  }
  return labels;
}

LabeledCloud
loadLabeledCloud (const std::string& file, WithoutLabels without_labels)
{
  return inMemory (file, "give a smaller cloud", [&] {
    const FileCloud cloud = loadCloud (file);
    PlaneLabels labels;
    if (without_labels == WithoutLabels::Refuse || hasField (cloud, "label"))
      labels = labelsIn (cloud.points, file);
    const LabeledCloud labeled{shiftedCloudOf (cloud), labels};
    const std::string damage = damageOf (labeled);
    if (!damage.empty())
      warn (file + ": " + damage);
    return labeled;
  });
}

namespace {

/** \throws WorkError unless both clouds have the same points in the same order. Points
 * that are not finite in one of them are not compared. */
void
checkSamePoints (const LabeledCloud& truth,
                 const LabeledCloud& result,
                 const std::string& result_file)
{
  if (truth.cloud->size() != result.cloud->size())
    throw WorkError (result_file,
                     "has " + std::to_string (result.cloud->size()) +
                         " points, the truth " + std::to_string (truth.cloud->size()) +
                         "; give two labelings of the same cloud");
  const Vector3d shift = result.shift - truth.shift;
  // Rounding in a text file may move a point by up to this share of the diagonal of the
  // bounding box. It is chosen by hand; swaps of points that are nearer to each other
  // are not noticed.
  constexpr double max_rounding = 1e-3;
  pcl::PointXYZ lowest;
  pcl::PointXYZ highest;
  pcl::getMinMax3D (*truth.cloud, lowest, highest);
  const Eigen::Vector3f diagonal = highest.getVector3fMap() - lowest.getVector3fMap();
  const double tolerance = max_rounding * diagonal.cast<double>().norm();
  for (std::size_t i = 0; i < truth.cloud->size(); ++i) {
    const pcl::PointXYZ& expected = (*truth.cloud)[i];
    const pcl::PointXYZ& found = (*result.cloud)[i];
    const Vector3d difference =
        (found.getVector3fMap() - expected.getVector3fMap()).cast<double>() + shift;
    const bool both_finite = pcl::isXYZFinite (expected) && pcl::isXYZFinite (found);
    if (both_finite && difference.norm() > tolerance)
      throw WorkError (result_file,
                       "point " + std::to_string (i) +
                           " lies elsewhere than in the truth; give two labelings of "
                           "the same cloud");
  }
}

} // namespace

TruthAndResult
loadLabeledClouds (const std::string& truth_file,
                   const std::string& result_file,
                   std::size_t min_plane_points)
{
  TruthAndResult clouds{loadLabeledCloud (truth_file, WithoutLabels::Refuse),
                        loadLabeledCloud (result_file, WithoutLabels::Refuse)};
  checkSamePoints (clouds.truth, clouds.result, result_file);
  dropSmallPlanes (clouds.truth.labels, min_plane_points);
  return clouds;
}

} // namespace pcl_ops::evaluation
