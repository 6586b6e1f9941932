// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "standard_input.h"

#include "spool.h"
#include <cli/errors.h>
#include <cli/interruption.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>

namespace pcl_ops::apps {

namespace {

/** \brief Fills the buffer as far as the input reaches. \return bytes read */
std::size_t
readInput (std::vector<char>& buffer)
{
  std::size_t filled = 0;
  while (filled < buffer.size()) {
    const ssize_t count =
        ::read (STDIN_FILENO, buffer.data() + filled, buffer.size() - filled);
    stopIfInterrupted();
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      throw WorkError (standard_input,
                       std::string ("cannot be read (") + std::strerror (errno) +
                           "); pipe a PCD into the program");
    if (count == 0)
      break;
    filled += static_cast<std::size_t> (count);
  }
  return filled;
}

constexpr std::size_t start_length = 64;

/** \param[in] start the first bytes of a cloud */
std::string
extensionOfContent (const std::string& start)
{
  const auto begins_with = [&] (const std::string& text) {
    return start.compare (0, text.size(), text) == 0;
  };
  const std::string utf8_mark = "\xef\xbb\xbf";
  if (begins_with (utf8_mark))
    return extensionOfContent (start.substr (utf8_mark.size()));
  if (begins_with ("LASF"))
    return ".las";
  if (begins_with ("ply"))
    return ".ply";
  // A PCD begins with a word or a comment, which a text may, too.
  const std::size_t first = start.find_first_not_of (" \t\r\n");
  const bool is_number =
      first != std::string::npos &&
      std::string ("+-.0123456789").find (start[first]) != std::string::npos;
  return is_number || begins_with ("//") ? ".xyz" : ".pcd";
}

} // namespace

FileCloud
loadStandardInput ()
{
  constexpr std::size_t buffer_size = 1U << 20U;
  if (::isatty (STDIN_FILENO) == 1)
    throw UsageError (standard_input, "is the terminal; pipe a PCD into the program");
  std::vector<char> buffer (buffer_size);
  std::size_t count = readInput (buffer);
  const Spool spool (
      extensionOfContent (std::string (buffer.data(), std::min (count, start_length))),
      standard_input);
  spool.fill ([&] (std::ostream& stream) {
    for (; count > 0 && stream; count = readInput (buffer))
      stream.write (buffer.data(), static_cast<std::streamsize> (count));
  });
  try {
    return loadCloud (spool.name());
  }
  catch (const WorkError& error) {
    throw WorkError (standard_input, error.problem);
  }
}

} // namespace pcl_ops::apps
