// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input_file.h"

#include <cli/errors.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

void
checkReadable (const std::string& file, const std::string& kind)
{
  std::error_code error;
  const fs::file_status status = fs::status (file, error);
  if (error == std::errc::filename_too_long)
    throw WorkError (file, "has a name that is too long; check it");
  if (!fs::exists (status))
    throw WorkError (file, "does not exist; check the name");
  if (fs::is_directory (status))
    throw WorkError (file, "is a folder; give " + kind);
  if (!fs::is_regular_file (status))
    throw WorkError (file, "is no regular file; give " + kind);
}

std::string
readTextFile (const std::string& file, const std::string& kind)
{
  checkReadable (file, kind);
  std::ifstream stream (file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char> (stream),
                   std::istreambuf_iterator<char>()};
  if (!stream)
    throw WorkError (file, "cannot be read; check its permissions");
  return text;
}

} // namespace pcl_ops::apps
