// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <io/inputs.h>
#include <support/temporary_folder.h>

using namespace pcl_ops::apps;

TEST (ReadTextFile, ReturnsAllBytesOfFilesOfAnySize)
{
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 1u, 65535u, 65536u, 200000u}) {
    std::string text (size, 'a');
    if (size > 1)
      text[size / 2] = '\0';
    folder.write ("text", text);
    EXPECT_EQ (readTextFile (folder / "text", "a text"), text) << size;
  }
}

TEST (ReadTextFile, FailsWhereAReadFails)
{
  // On Linux a regular file whose first bytes cannot be read, elsewhere missing.
  EXPECT_THROW (readTextFile ("/proc/self/mem", "a text"), WorkError);
}
