// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "labelled_cloud.h"

#include "colors.h"
#include <io/cloud_fields.h>

namespace pcl_ops::apps {

void
saveLabelledCloud (const std::string& file,
                   FileCloud cloud,
                   const std::vector<std::uint32_t>& labels,
                   bool keeps_color)
{
  setLabels (cloud, labels);
  if (!keeps_color || !(hasField (cloud, "rgb") || hasField (cloud, "rgba"))) {
    std::vector<pcl::RGB> colors;
    colors.reserve (labels.size());
    for (const std::uint32_t label : labels)
      colors.push_back (colorOfLabel (label));
    setColors (cloud, colors);
  }
  saveCloud (file, cloud);
}

} // namespace pcl_ops::apps
