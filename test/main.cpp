// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <iostream>
#include <string>

/** \brief A GoogleTest filter for the tests of a source file; empty if this program
 * has no test of that file.
 * \param[in] file name of the source file, without folders */
static std::string
testsOf (const std::string& file)
{
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite (i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo (j);
      const std::string path = test.file();
      if (path.substr (path.find_last_of ("/\\") + 1) == file)
        filter += std::string (test.test_suite_name()) + "." + test.name() + ":";
    }
  }
  return filter;
}

/** \brief Runs all tests, or only those of a source file, e.g. plane_test.cpp, whatever
 * --gtest_filter says. */
int
main (int argc, char** argv)
{
  testing::InitGoogleTest (&argc, argv);
  if (argc > 1) {
    const std::string filter = testsOf (argv[1]);
    if (filter.empty()) {
      std::cerr << argv[1] << ": no test of this program is in such a file\n";
      return 2;
    }
    testing::GTEST_FLAG (filter) = filter;
  }
  return RUN_ALL_TESTS();
}
