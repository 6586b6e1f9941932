// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "spool.h"

#include <cli/errors.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

Spool::Spool (const std::string& extension, std::string subject)
: subject_ (std::move (subject))
{
  std::error_code error;
  const fs::path folder = fs::temp_directory_path (error);
  if (error)
    throw WorkError ("TMPDIR", "is no folder; set it to one for temporary files");
  name_ = (folder / ("pcl_ops_XXXXXX" + extension)).string();
  const int file = ::mkstemps (name_.data(), static_cast<int> (extension.size()));
  if (file < 0)
    fail();
  ::close (file);
}

Spool::~Spool() { ::unlink (name_.c_str()); }

void
Spool::fill (const std::function<void (std::ostream& stream)>& write) const
{
  std::ofstream stream (name_, std::ios::binary);
  write (stream);
  stream.close();
  if (!stream)
    fail();
}

void
Spool::fail() const
{
  throw WorkError (subject_,
                   "cannot be copied to " + name_ + " (" + std::strerror (errno) +
                       "); set TMPDIR to a folder with more space");
}

} // namespace pcl_ops::apps
