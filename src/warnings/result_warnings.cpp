// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/parameter_text.h"
#include "warnings/plane_warnings.h"
#include <pcl_ops/result_warnings.h>

#include <utility>

namespace pcl_ops {

std::vector<ResultWarning>
resultWarnings (const CloudView& /*cloud*/,
                const std::vector<PlaneSegment>& planes,
                const ResultContext& context)
{
  const internal::ParameterText text{context.names};
  std::vector<ResultWarning> warnings;
  const auto add = [&] (std::optional<ResultWarning> warning) {
    if (warning && warnings.size() < context.max_warnings)
      warnings.push_back (*std::move (warning));
  };
  add (internal::warnOfThickPlanes (planes, text));
  return warnings;
}

} // namespace pcl_ops
