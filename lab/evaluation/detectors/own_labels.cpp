// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "own_labels.h"

#include <boost/format.hpp>

#include <cli/errors.h>
#include <detection/methods.h>
#include <io/number_list.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

namespace fs = std::filesystem;

/** Returns the first file that exists of those that may have the labels of a cloud.
 * \throw WorkError if none exists */
std::string
fileOfLabels (const std::string& folder, const RunSettings& settings)
{
  const std::string& cloud = settings.cloud_name;
  std::vector<std::string> names = {cloud};
  if (hasCloudExtension (cloud))
    names.push_back (fs::path (cloud).replace_extension().string());
  for (const fs::path& parent :
       {fs::path (folder) / settings.data_set, fs::path (folder)})
    for (const std::string& name : names)
      for (const char* extension : {".npy", ".txt", ".pcd"}) {
        const fs::path file = parent / (name + extension);
        if (fs::is_regular_file (file))
          return file.string();
      }
  throw WorkError (folder,
                   "has neither " + settings.data_set + "/" + names.back() +
                       ".npy nor " + names.back() +
                       ".npy, nor such a .txt or .pcd; save the labels");
}

std::vector<double>
numbersIn (const std::string& file)
{
  const std::string extension = fs::path (file).extension().string();
  if (extension == ".npy")
    return readNpyNumbers (file);
  if (extension == ".txt")
    return readTextNumbers (file);
  return labelNumbersIn (loadCloud (file).points, file);
}

/** Returns labels from 1 on, by ascending number in the file; 0: no plane.
 * \throw WorkError if a number cannot be a label */
PlaneLabels
labelsOfNumbers (const std::vector<double>& numbers, const std::string& file)
{
  // The largest unsigned number would be a -1 that was stored in an unsigned type.
  constexpr double too_large = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!(std::abs (numbers[i]) < too_large && numbers[i] == std::floor (numbers[i])))
      throw WorkError (
          file,
          (boost::format ("point %1% has the label %2$.10g; give whole numbers below "
                          "4294967295, negative ones in a type with a sign") %
           i % numbers[i])
              .str());
  const bool has_negative = std::any_of (
      numbers.begin(), numbers.end(), [] (double number) { return number < 0.0; });
  const double lowest_plane_number = has_negative ? 0.0 : 1.0;
  std::map<double, std::uint32_t> label_of_number;
  for (const double number : numbers)
    if (number >= lowest_plane_number)
      label_of_number[number] = 0;
  std::uint32_t count = 0;
  for (auto& [number, label] : label_of_number)
    label = ++count;
  PlaneLabels labels (numbers.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (numbers[i] >= lowest_plane_number)
      labels[i] = label_of_number[numbers[i]];
  return labels;
}

/** Returns the labels of the finite points. A file has one for each of them or, if
 * there is an image, one for each pixel.
 * \param[in] points number of finite points
 * \param[in] image nullptr: there is none
 * \param[in] file for messages */
PlaneLabels
labelsOfFinitePoints (PlaneLabels labels,
                      std::size_t points,
                      const XyzCloud::ConstPtr& image,
                      const std::string& file)
{
  if (labels.size() == points)
    return labels;
  if (image && labels.size() == image->size())
    return selectLabels (labels, finitePointsOf (*image));
  throw WorkError (file,
                   "has " + std::to_string (labels.size()) + " labels, the cloud " +
                       std::to_string (points) +
                       " finite points; give one for each, in the order of truth.pcd");
}

/** Returns a run with these labels and without times. */
DetectorRun
runOf (const PlaneLabels& labels)
{
  DetectorRun run;
  run.labels = labels;
  run.planes_before_merging = planeIds (labels).size();
  for (const auto& [name, duration] : detection_stages)
    run.durations.*duration = std::numeric_limits<double>::quiet_NaN();
  return run;
}

/** \throw UsageError if the name is taken or not valid in tables and file names */
void
checkName (const std::string& name)
{
  const auto isForbidden = [] (char character) {
    const bool is_control = character >= 0 && character < ' ';
    return std::string (",/\\|\"").find (character) != std::string::npos || is_control;
  };
  if (name.empty() || std::any_of (name.begin(), name.end(), isForbidden))
    throw UsageError (
        "--results",
        "'" + name +
            "': a name has letters, and none of , / \\ | \"; give NAME=FOLDER");
  bool is_taken = name == "truth" || name == "all" || name == "none";
  for (const Configuration& known : allConfigurations())
    is_taken = is_taken || known.name == name || known.groups.count (name) > 0;
  if (is_taken)
    throw UsageError ("--results",
                      "'" + name + "' is a name of pcl_ops_evaluate; give another");
}

} // namespace

Configuration
ownLabels (const std::string& name_and_folder)
{
  const std::size_t equals = name_and_folder.find ('=');
  if (equals == std::string::npos || equals + 1 == name_and_folder.size())
    throw UsageError ("--results",
                      "'" + name_and_folder + "' has no folder; give NAME=FOLDER");
  const std::string name = name_and_folder.substr (0, equals);
  const std::string folder = name_and_folder.substr (equals + 1);
  checkName (name);
  std::error_code error;
  if (!fs::is_directory (folder, error))
    throw WorkError (folder, "is no folder; give that of the files of labels");
  Configuration configuration;
  configuration.name = name;
  configuration.is_own = true;
  configuration.run = [folder] (const auto& cloud, const RunSettings& settings) {
    const std::string file = fileOfLabels (folder, settings);
    const PlaneLabels labels = labelsOfNumbers (numbersIn (file), file);
    return runOf (labelsOfFinitePoints (labels, cloud->size(), settings.image, file));
  };
  return configuration;
}

} // namespace pcl_ops::evaluation
