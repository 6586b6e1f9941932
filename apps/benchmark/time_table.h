// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measure.h"
#include <evaluation/report/text_table.h>

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_ops::benchmark {

/** \brief Prints the times on a cloud, each row as soon as it is known. */
class TimeTable {
public:
  TimeTable (std::ostream& stream,
             const std::string& cloud,
             std::size_t points,
             const std::vector<Measure>& measures);

  void
  add (const BestTime& time);

  /** \brief No more rows will come. */
  void
  end ();

private:
  double points_;
  evaluation::GrowingTable lines_;
};

} // namespace pcl_ops::benchmark
