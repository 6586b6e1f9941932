// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "warnings/parameter_text.h"

using namespace pcl_ops::internal;

TEST (RoundedUpLength, IsTheNextNumberAboveWithOneDigit)
{
  EXPECT_EQ (roundedUpLength (0.25), "0.3");
  for (int tenths = 1; tenths < 9; ++tenths)
    EXPECT_EQ (roundedUpLength (tenths / 10.0), "0." + std::to_string (tenths + 1))
        << "not the number itself";
  EXPECT_EQ (roundedUpLength (0.9), "1");
}
