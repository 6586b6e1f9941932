// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder.h"

#include <cli/errors.h>
#include <io/output_file.h>

#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Of what phases leave, in the order of the phases. */
constexpr const char* folders[] = {"cells", "planes", "labelled"};

} // namespace

std::string
RunFolder::output (const std::string& name) const
{
  return (fs::path (outputs) / name).string();
}

void
RunFolder::make() const
{
  makeFolder (outputs);
  for (const char* folder : folders)
    makeFolder (work (folder));
}

void
RunFolder::startAnew() const
{
  std::error_code error;
  fs::remove (end(), error);
  for (const char* folder : folders)
    if (!error)
      fs::remove_all (work (folder), error);
  if (error)
    throw WorkError (output ("work"),
                     "cannot be emptied (" + error.message() +
                         "); remove it or give another --output-dir");
  make();
}

void
RunFolder::clean() const
{
  std::error_code ignored;
  for (const char* folder : folders)
    fs::remove_all (work (folder), ignored);
}

bool
isThere (const std::string& file)
{
  std::error_code error;
  return fs::exists (file, error);
}

} // namespace pcl_ops::apps
