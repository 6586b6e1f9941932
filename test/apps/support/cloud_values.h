// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>

#include <io/cloud_file.h>
#include <support/temporary_folder.h>
#include <support/text.h>

#include <charconv>

/** \brief The value of a field at each point; throws if the cloud has no such field. */
inline std::vector<double>
valuesOf (const pcl_ops::apps::FileCloud& cloud, const std::string& name)
{
  const pcl::PCLPointCloud2& points = cloud.points;
  const auto index = std::size_t (pcl::getFieldIndex (points, name));
  const pcl::PCLPointField& field = points.fields.at (index);
  std::vector<double> values;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    values.push_back (pcl_ops::apps::numberType (field.datatype)
                          .read (&points.data[i * points.point_step + field.offset]));
  return values;
}

/** \brief The name and the values of each field as text, such as "x 1 4; y 2 5", and
 * the height of a cloud of more than one row. */
inline std::string
textOf (const pcl_ops::apps::FileCloud& cloud)
{
  std::string text;
  for (const pcl::PCLPointField& field : cloud.points.fields) {
    text += (text.empty() ? "" : "; ") + field.name;
    for (const double value : valuesOf (cloud, field.name)) {
      char digits[32];
      char* const end = std::to_chars (digits, digits + sizeof (digits), value).ptr;
      text.append (" ").append (digits, end);
    }
  }
  const std::uint32_t height = cloud.points.height;
  return text + (height > 1 ? "; height " + std::to_string (height) : "");
}

/** \brief A folder for files of clouds whose bytes a test gives. */
class CloudFolder : public testing::Test {
protected:
  /** \brief Writes a file of that name and content and loads it. */
  pcl_ops::apps::FileCloud
  load (const std::string& name, const std::string& content) const
  {
    return pcl_ops::apps::loadCloud (folder_.write (name, content));
  }

  /** \return the one-line message that loading fails with, without the path of the
   * file; empty if loading succeeds */
  std::string
  complaintAbout (const std::string& file) const
  {
    const std::string text = complaintOf ([&] { pcl_ops::apps::loadCloud (file); });
    EXPECT_EQ (lines (text), 0u);
    const std::string begin = file + ": ";
    return text.substr (text.find (file) == 0 ? begin.size() : 0);
  }

  std::string
  complaintAbout (const std::string& name, const std::string& content) const
  {
    return complaintAbout (folder_.write (name, content));
  }

  TemporaryFolder folder_;
};
