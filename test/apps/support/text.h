// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

inline std::size_t
lines (const std::string& text)
{
  return static_cast<std::size_t> (std::count (text.begin(), text.end(), '\n'));
}

/** \brief Whether a text has a part; a failure shows the text. */
inline testing::AssertionResult
contains (const std::string& text, const std::string& part)
{
  return testing::AssertionResult (text.find (part) != std::string::npos)
         << "the text: " << text;
}

/** \brief What some work says that it fails for; empty where it succeeds. */
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
