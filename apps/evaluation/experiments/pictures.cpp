// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"

#include <evaluation/labels/labels.h>
#include <evaluation/metrics/metrics.h>
#include <picture/picture.h>

#include <cctype>
#include <filesystem>

namespace pcl_ops::evaluation {

namespace {

/** A cloud's name as part of a file name. */
std::string
fileNameOf (std::string name)
{
  for (char& character : name)
    if (std::isalnum (static_cast<unsigned char> (character)) == 0)
      character = '_';
  return name;
}

void
drawLabels (const EvaluationCloud& cloud, PlaneLabels labels, const std::string& file)
{
  sortBySize (labels); // so that a label is the position of its plane, plus 1
  ClassParameters classes;
  classes.up = cloud.up;
  apps::savePicture (file,
                     *cloud.cloud,
                     labels,
                     planesOf (*cloud.cloud, planeIds (labels), classes),
                     cloud.up.cast<float>());
}

} // namespace

TextTable
writePictures (const EvaluationCloud& cloud,
               const std::string& name,
               const PlaneLabels& truth,
               const std::vector<Configuration>& configurations,
               std::uint32_t seed,
               const std::string& folder)
{
  TextTable table{
      name, {"method", "class. %", "segm. %", "planes (left), classes (right)"}, {}};
  const auto add = [&] (const std::string& method, const PlaneLabels& labels) {
    const std::string file = fileNameOf (name) + "-" + method + ".png";
    drawLabels (cloud, labels, (std::filesystem::path (folder) / file).string());
    ClassParameters classes;
    classes.up = cloud.up;
    const Metrics metrics = compareLabels (*cloud.cloud, truth, labels, classes);
    table.rows.push_back ({method,
                           percent (metrics.classification_accuracy),
                           percent (metrics.segmentation_accuracy),
                           "![" + method + "](" + file + ")"});
  };
  add ("truth", truth);
  for (const Configuration& configuration : configurations)
    add (configuration.name, configuration.run (cloud.cloud, cloud.up, seed).labels);
  return table;
}

} // namespace pcl_ops::evaluation
