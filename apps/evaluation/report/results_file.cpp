// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "results_file.h"

#include <cli/errors.h>
#include <detection/methods.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

/** A cell of RFC 4180: quoted where it has to be. A name's line break becomes a space,
 * so that a row is always a line. */
std::string
quoted (std::string text)
{
  std::replace (text.begin(), text.end(), '\n', ' ');
  if (text.find_first_of (",\"") == std::string::npos)
    return text;
  std::string cell = "\"";
  for (const char character : text)
    cell += character == '"' ? std::string ("\"\"") : std::string (1, character);
  return cell + '"';
}

/** What a row begins with. */
std::string
cellsOf (const ResultKey& key)
{
  return quoted (key.data_set) + ',' + quoted (key.cloud) + ',' + quoted (key.truth) +
         ',' + quoted (key.configuration) + ',' + std::to_string (key.seed) + ',';
}

std::string
headerLine ()
{
  std::string line = "data_set,cloud,truth,configuration,seed";
  for (const auto& named : namedValues (compareLabels ({}, {}, {}), {}))
    line += ',' + named.first;
  return line;
}

} // namespace

NamedValues
namedValues (const Metrics& metrics, const DetectorRun& run)
{
  NamedValues values{{"points", double (metrics.points)},
                     {"truth_planes", double (metrics.truth_planes)},
                     {"result_planes", double (metrics.result_planes)},
                     {"planes_before_merging", double (run.planes_before_merging)}};
  values.insert (values.end(), metrics.named.begin(), metrics.named.end());
  for (const auto& [stage, duration] : apps::detection_stages)
    values.emplace_back (std::string (stage) + "_ms", run.durations.*duration);
  values.emplace_back (off_planes_name, metrics.points_off_planes_called_planes);
  for (const auto& named : namedCounts (metrics))
    values.push_back (named);
  return values;
}

ResultsFile::ResultsFile (const std::string& file) : file_ (file)
{
  std::ifstream before (file, std::ios::binary);
  const std::string text (std::istreambuf_iterator<char> (before), {});
  const std::size_t complete = text.rfind ('\n') + 1; // 0 where there is no line
  if (complete < text.size())
    fs::resize_file (file, complete);
  std::istringstream rows (text.substr (0, complete));
  std::string line;
  if (std::getline (rows, line) && line != headerLine())
    throw apps::WorkError (
        file, "has other columns than this version writes; give another output folder");
  while (std::getline (rows, line))
    lines_.insert (line);
  stream_.open (file, std::ios::app);
  if (complete == 0)
    stream_ << headerLine() << '\n';
  if (!stream_.flush())
    throw apps::OutputError (file, "cannot be written; give another output folder");
}

bool
ResultsFile::has (const ResultKey& key) const
{
  const std::string cells = cellsOf (key);
  const std::lock_guard<std::mutex> lock (mutex_);
  const auto line = lines_.lower_bound (cells);
  return line != lines_.end() && line->rfind (cells, 0) == 0;
}

void
ResultsFile::add (const ResultKey& key, const NamedValues& values)
{
  constexpr int digits = 7;
  std::ostringstream numbers;
  numbers.precision (digits);
  for (const auto& named : values)
    numbers << (numbers.tellp() > 0 ? "," : "") << named.second;
  const std::string line = cellsOf (key) + numbers.str();
  const std::lock_guard<std::mutex> lock (mutex_);
  const std::uintmax_t size = fs::file_size (file_);
  if (!(stream_ << line + '\n') || !stream_.flush()) {
    stream_.close();
    std::error_code ignored;
    fs::resize_file (file_, size, ignored); // without the part of a row that had room
    throw apps::OutputError (
        file_,
        "cannot be written; make room and run it again, which goes on from here");
  }
  lines_.insert (line);
}

} // namespace pcl_ops::evaluation
