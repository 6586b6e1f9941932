// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace pcl_ops::apps {

/** \brief A new file in the folder for temporary files ($TMPDIR), removed at the end of
 * its life: on its way into or out of what takes files only. */
class Spool {
public:
  /** \param[in] extension of the file, with its dot
   * \param[in] subject what complaints are about
   * \throws WorkError if there can be none */
  Spool (const std::string& extension, std::string subject);
  Spool (const Spool&) = delete;
  Spool&
  operator= (const Spool&) = delete;
  ~Spool();

  /** \brief Writes all of it.
   * \param[in] write need not look at the state of the stream
   * \throws WorkError if not all is there, and whatever \p write throws */
  void
  fill (const std::function<void (std::ostream& stream)>& write) const;

  const std::string&
  name () const
  {
    return name_;
  }

private:
  [[noreturn]] void
  fail () const;

  std::string subject_, name_;
};

} // namespace pcl_ops::apps
