// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "results_file.h"

#include <cli/errors.h>
#include <detection/methods.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iterator>
#include <limits>
#include <sstream>
#include <vector>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

namespace fs = std::filesystem;

/** Returns the columns of size classes: the number of true planes in each class, and
 * the numbers of those that were found at an intersection over union of 0.5 and of
 * 0.75. */
std::vector<std::string>
columnsOfSizeClasses ()
{
  std::vector<std::string> columns;
  for (const char* size_class : {"by_points_below_200",
                                 "by_points_below_500",
                                 "by_points_below_1000",
                                 "by_points_below_3000",
                                 "by_points_below_10000",
                                 "by_points_from_10000",
                                 "by_width_below_0.03",
                                 "by_width_below_0.06",
                                 "by_width_below_0.12",
                                 "by_width_below_0.25",
                                 "by_width_below_1",
                                 "by_width_from_1"})
    for (const char* count : {"planes_", "found_", "found_75_"})
      columns.push_back (std::string (count) + size_class);
  return columns;
}

/** Returns the columns of numbers in results.csv, in their order. */
std::vector<std::string>
columnsOfNumbers ()
{
  std::vector<std::string> columns{"points",
                                   "truth_planes",
                                   "result_planes",
                                   "planes_before_merging",
                                   "classification_accuracy",
                                   "segmentation_accuracy",
                                   "segmentation_accuracy_all"};
  for (const char* iou_suffix : {"", "_75"})
    for (const char* metric : {"precision",
                               "recall",
                               "f_score",
                               "mean_iou",
                               "panoptic_quality",
                               "over_segmentation",
                               "under_segmentation",
                               "noise",
                               "missed"})
      columns.push_back (std::string (metric) + iou_suffix);
  for (const auto& [stage, duration] : detection_stages)
    columns.push_back (std::string (stage) + "_ms");
  for (const char* metric : {"points_off_planes_called_planes",
                             "variation_of_information",
                             "rand_index",
                             "segmentation_covering"})
    columns.emplace_back (metric);
  for (const std::string& column : columnsOfSizeClasses())
    columns.push_back (column);
  for (const char* thickness : {"on_planes_share",
                                "thick_factor_share",
                                "thick_length_share",
                                "thick_length",
                                "rms_largest"})
    columns.emplace_back (thickness);
  for (const CloudChange& change : cloud_changes)
    columns.push_back (agreementColumn (change));
  return columns;
}

std::string
headerLine ()
{
  std::string line = "data_set,cloud,truth,configuration,seed";
  for (const std::string& column : columnsOfNumbers())
    line += ',' + column;
  return line;
}

} // namespace

std::string
agreementColumn (const CloudChange& change)
{
  return std::string ("agreement_") + change.name;
}

std::string
csvCell (std::string text)
{
  std::replace (text.begin(), text.end(), '\n', ' ');
  std::ostringstream cell;
  if (text.find_first_of (",\"") == std::string::npos)
    cell << text << ',';
  else
    cell << std::quoted (text, '"', '"') << ',';
  return cell.str();
}

ResultsFile::ResultsFile (const std::string& file) : file_ (file)
{
  std::ifstream before (file, std::ios::binary);
  const std::string text (std::istreambuf_iterator<char> (before), {});
  // Size of all complete lines [byte]; 0 if there is none, as npos + 1 is 0.
  const std::size_t complete_size = text.rfind ('\n') + 1;
  if (complete_size < text.size())
    fs::resize_file (file, complete_size);
  std::istringstream rows (text.substr (0, complete_size));
  std::string line;
  if (std::getline (rows, line) && line != headerLine())
    throw WorkError (
        file, "has other columns than this version writes; give another output folder");
  while (std::getline (rows, line))
    lines_.insert (line);
  stream_.open (file, std::ios::app);
  if (complete_size == 0)
    stream_ << headerLine() << '\n';
  if (!stream_.flush())
    throw OutputError (file, "cannot be written; give another output folder");
}

bool
ResultsFile::has (const std::string& first_cells) const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  // The set is sorted: a line that begins with the cells is not less than they are.
  const auto line = lines_.lower_bound (first_cells);
  return line != lines_.end() && line->rfind (first_cells, 0) == 0;
}

void
ResultsFile::add (const std::string& first_cells, const RowNumbers& numbers)
{
  constexpr int significant_digits = 7;
  std::ostringstream line;
  line.precision (significant_digits);
  line << first_cells;
  const char* separator = "";
  for (const std::string& column : columnsOfNumbers()) {
    const auto number = numbers.find (column);
    line << separator
         << (number == numbers.end() ? std::numeric_limits<double>::quiet_NaN()
                                     : number->second);
    separator = ",";
  }
  const std::lock_guard<std::mutex> lock (mutex_);
  const std::uintmax_t size_before = fs::file_size (file_);
  if (!(stream_ << line.str() + '\n') || !stream_.flush()) {
    stream_.close();
    std::error_code ignored;
    fs::resize_file (file_, size_before, ignored); // removes a partly written row
    throw OutputError (
        file_,
        "cannot be written; make room and run it again, which goes on from here");
  }
  lines_.insert (line.str());
}

} // namespace pcl_ops::evaluation
