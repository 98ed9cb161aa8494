# SPDX-License-Identifier: BSD-3-Clause
"""A study of several kinds, each of several runs, whose figures stand beside what is expected of them."""

from cohesion_studies import expected, program, study_table
from cohesion_studies.job_pool import carry_out, require_ours
from cohesion_studies.lammps_run import MARK


def carry_out_study(jobs, args, out, expectations):
    """Runs `jobs` as many at a time as --together says and leaves their table in the folder `out`; `expectations`: a
    file as expected.rows() reads it. Raises RunError."""
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    program.leave_table(out, study_table.side_by_side(kinds) + "\n\n"
                        + expected.text(expectations, study_table.means_of(kinds)))
