// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <support/answers.h>

namespace {

namespace fs = std::filesystem;

/** The programs of the lab, and the files of inputs. */
class LabProgram : public AnswersFolder {
protected:
  LabProgram() : AnswersFolder (PCL_OPS_EVALUATE_PROGRAM)
  {
    fs::copy (PCL_OPS_LAB "/inputs", folder_.path(), fs::copy_options::recursive);
  }
};

INSTANTIATE_TEST_SUITE_P (All,
                          LabProgram,
                          testing::ValuesIn (answersIn (PCL_OPS_LAB "/answers.tsv")),
                          nameOfAnswers);

TEST_P (LabProgram, IsAsTheTableSays)
{
  ::setenv ("PYTHON", PCL_OPS_PYTHON3, 1);
  ::setenv ("REPORT", PCL_OPS_REPORT, 1);
  expectAnswers ({{"report", fs::exists (PCL_OPS_PYTHON3)}});
}

} // namespace
