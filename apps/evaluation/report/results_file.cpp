// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "results_file.h"

#include <cli/errors.h>
#include <detection/methods.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t text_columns = 5;
constexpr int digits_of_value = 7;

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

std::vector<std::string>
cellsOf (const std::string& line)
{
  std::vector<std::string> cells (1);
  bool in_quotes = false;
  for (const char character : line) {
    if (character == '"') {
      // The second quote of a pair inside quotes stands for one.
      if (!in_quotes && !cells.back().empty())
        cells.back() += '"';
      in_quotes = !in_quotes;
    }
    else if (character == ',' && !in_quotes)
      cells.emplace_back();
    else
      cells.back() += character;
  }
  return cells;
}

/** The columns behind the texts and the seed, in order. */
std::vector<std::pair<std::string, double>>
namedValues (const Metrics& metrics, const DetectorRun& run)
{
  std::vector<std::pair<std::string, double>> values{
      {"points", double (metrics.points)},
      {"truth_planes", double (metrics.truth_planes)},
      {"result_planes", double (metrics.result_planes)},
      {"planes_before_merging", double (run.planes_before_merging)}};
  for (const auto& named : namedMetrics (metrics))
    values.push_back (named);
  for (const auto& [stage, duration] : apps::detection_stages)
    values.emplace_back (std::string (stage) + "_ms", run.durations.*duration);
  values.emplace_back (off_planes_name, metrics.points_off_planes_called_planes);
  for (const auto& named : namedCounts (metrics))
    values.push_back (named);
  return values;
}

std::string
headerLine ()
{
  std::string line = "data_set,cloud,truth,configuration,seed";
  for (const std::string& column : valueColumns())
    line += ',' + column;
  return line;
}

std::string
lineOf (const ResultRow& row)
{
  std::ostringstream line;
  line.precision (digits_of_value);
  line << quoted (row.data_set) << ',' << quoted (row.cloud) << ','
       << quoted (row.truth) << ',' << quoted (row.configuration) << ',' << row.seed;
  for (const double value : row.values)
    line << ',' << value;
  return line.str();
}

/** \throw std::exception for a line that is no row */
ResultRow
rowOf (const std::string& line)
{
  const std::vector<std::string> cells = cellsOf (line);
  if (cells.size() != text_columns + valueColumns().size())
    throw std::invalid_argument ("wrong number of cells");
  ResultRow row{cells[0], cells[1], cells[2], cells[3], 0, {}};
  row.seed = static_cast<std::uint32_t> (std::stoul (cells[4]));
  for (std::size_t i = text_columns; i < cells.size(); ++i)
    row.values.push_back (std::stod (cells[i]));
  return row;
}

} // namespace

double
ResultRow::value (const std::string& column) const
{
  const std::vector<std::string>& columns = valueColumns();
  const auto found = std::find (columns.begin(), columns.end(), column);
  if (found == columns.end())
    throw std::out_of_range ("no column " + column);
  return values[static_cast<std::size_t> (found - columns.begin())];
}

const std::vector<std::string>&
valueColumns ()
{
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> names;
    for (const auto& named : namedValues ({}, {}))
      names.push_back (named.first);
    return names;
  }();
  return columns;
}

std::vector<double>
valuesOf (const Metrics& metrics, const DetectorRun& run)
{
  std::vector<double> values;
  for (const auto& named : namedValues (metrics, run))
    values.push_back (named.second);
  return values;
}

ResultsFile::ResultsFile (const std::string& file) : file_ (file)
{
  std::ifstream before (file, std::ios::binary);
  const std::string text (std::istreambuf_iterator<char> (before), {});
  const std::size_t complete = text.rfind ('\n') + 1; // 0 where there is no line
  if (complete < text.size())
    fs::resize_file (file, complete);
  readRows (text.substr (0, complete));
  stream_.open (file, std::ios::app);
  if (complete == 0)
    stream_ << headerLine() << '\n';
  if (!stream_.flush())
    throw apps::OutputError (file, "cannot be written; give another output folder");
}

void
ResultsFile::readRows (const std::string& text)
{
  std::istringstream stream (text);
  std::string line;
  if (std::getline (stream, line) && line != headerLine())
    throw apps::WorkError (file_,
                           "has other columns than this version writes; give another "
                           "output folder");
  for (std::size_t number = 2; std::getline (stream, line); ++number)
    try {
      rows_.push_back (rowOf (line));
      keys_.insert (rows_.back().key());
    }
    catch (const std::exception&) {
      throw apps::WorkError (file_,
                             "line " + std::to_string (number) +
                                 " is no row of results; remove it");
    }
}

bool
ResultsFile::has (const ResultRow::Key& key) const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return keys_.count (key) > 0;
}

void
ResultsFile::add (const ResultRow& row)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  const std::uintmax_t size = fs::file_size (file_);
  if (!(stream_ << lineOf (row) + '\n') || !stream_.flush()) {
    stream_.close();
    std::error_code ignored;
    fs::resize_file (file_, size, ignored); // without the part of a row that had room
    throw apps::OutputError (
        file_,
        "cannot be written; make room and run it again, which goes "
        "on from here");
  }
  rows_.push_back (row);
  keys_.insert (row.key());
}

} // namespace pcl_ops::evaluation
