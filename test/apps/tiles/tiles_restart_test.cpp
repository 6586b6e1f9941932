// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <support/answers.h>

namespace {

#ifndef PCL_OPS_MPIEXEC
#define PCL_OPS_MPIEXEC ""
#endif

/** \brief A folder with the programs of restart.tsv. */
class TilesRestart : public AnswersFolder {
protected:
  TilesRestart() : AnswersFolder (PCL_OPS_TILES_PROGRAM)
  {
    addScript ("killed_at",
               "exec env LD_PRELOAD='" PCL_OPS_FAILING_CALLS
               "' KILLED_AT_WRITE=$first \"$@\"");
    // A run that is killed late enough to go on is killed early again: else it may end
    // before it is seen to have written the file.
    addScript (
        "stopped_once",
        "files () { find out -type f ! -name '.*' 2>/dev/null | sort; }\n"
        "n=1; until [ -e $first ]; do before=$(files); "
        "./killed_at $n \"$@\" && exit 1; [ $n -lt 200 ] || exit 1; "
        "if [ \"$before\" = \"$(files)\" ]; then n=$((n + 1)); else n=1; fi; done");
    addScript ("ranks",
               "exec env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
               "'" PCL_OPS_MPIEXEC "' --oversubscribe -n $first \"$@\"");
    const Outcome whole =
        shell ("pcl_ops_simulate town --scene town --points 20000 --tiles 4 && "
               "pcl_ops_tiles town --output-dir whole --tile 40");
    EXPECT_EQ (whole.exit_code, 0) << whole.err;
  }

private:
  /** \param[in] script gets its first argument as $first, the others as "$@" */
  void
  addScript (const std::string& name, const std::string& script) const
  {
    namespace fs = std::filesystem;
    folder_.write (name, "#!/bin/sh\nfirst=$1\nshift\n" + script + "\n");
    fs::permissions (folder_ / name, fs::perms::owner_exec, fs::perm_options::add);
  }
};

INSTANTIATE_TEST_SUITE_P (All,
                          TilesRestart,
                          testing::ValuesIn (answersIn (PCL_OPS_ANSWERS)),
                          nameOfAnswers);

} // namespace

TEST_P (TilesRestart, IsAsTheTableSays)
{
  expectAnswers ({{"with MPI:", *PCL_OPS_MPIEXEC != '\0'}});
}
