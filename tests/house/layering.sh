#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# layering.sh SOURCE_DIR: src/ is the physics alone. What it includes is there or in the standard
# library, and no header of an engine or of MPI. Errors of what is built for LIGGGHTS go through
# stop() and guarded(), which leave out the engine's jests (liggghts_api.h).
set -eu
cd "$1/src"
bad=0
for include in $(grep -rhoE '#include "[^"]+"' . | sed 's/#include "//; s/"//' | sort -u); do
  [ -e "$include" ] || { echo "src/ includes \"$include\", which is not in src/"; bad=1; }
done
if grep -rnE '#include <[^>]*(\.h|\.H|/)[^>]*>' .; then
  echo "src/ includes a header that is not of the C++ standard library"
  bad=1
fi
cd ..
if grep -rnE 'error->(all|one|fix_error|compute_error)\(' liggghts-styles lammps-package/common |
  grep -vE '^(liggghts-styles/liggghts_api|lammps-package/common/engine_api)\.h:'; then
  echo "an error that LIGGGHTS may follow by a jest; use stop() of common/message.h"
  bad=1
fi
exit $bad
