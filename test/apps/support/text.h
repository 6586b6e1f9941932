// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/** \brief Number of line ends in a text. */
inline std::size_t
lines (const std::string& text)
{
  return static_cast<std::size_t> (std::count (text.begin(), text.end(), '\n'));
}

/** \brief Whether a text has a part. A failed expectation shows the text. */
inline testing::AssertionResult
contains (const std::string& text, const std::string& part)
{
  return testing::AssertionResult (text.find (part) != std::string::npos)
         << "the text: " << text;
}

/** \brief Message of the std::runtime_error that \p work throws; empty if it throws
 * nothing. */
inline std::string
complaintOf (const std::function<void()>& work)
{
  try {
    work();
  }
  catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/** \brief Rows of a file of tab-separated columns, without comments (#) and empty
 * lines. A row may have fewer columns than others.
 * \throws std::runtime_error if the file cannot be read */
inline std::vector<std::vector<std::string>>
tableIn (const std::string& file)
{
  std::ifstream stream (file);
  if (!stream)
    throw std::runtime_error (file + ": cannot be read");
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline (stream, line);) {
    if (line.empty() || line[0] == '#')
      continue;
    std::istringstream columns (line);
    rows.emplace_back();
    for (std::string column; std::getline (columns, column, '\t');)
      rows.back().push_back (column);
  }
  return rows;
}

/** \brief The numbers of a text, separated by white space. Takes nan, inf and subnormal
 * numbers, too. */
inline std::vector<double>
numbersIn (const std::string& text)
{
  std::istringstream words (text);
  std::vector<double> numbers;
  for (std::string word; words >> word;)
    numbers.push_back (std::strtod (word.c_str(), nullptr));
  return numbers;
}
