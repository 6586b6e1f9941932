// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "warnings/parameter_text.h"

using namespace pcl_ops::internal;

TEST (RoundedUpLength, IsTheNextNumberAboveWithOneDigit)
{
  EXPECT_EQ (roundedUpLength (0.25), "0.3");
  for (int digit = 1; digit < 9; ++digit)
    EXPECT_EQ (roundedUpLength (digit / 10.0), "0." + std::to_string (digit + 1));
  EXPECT_EQ (roundedUpLength (0.9), "1");
}
