// SPDX-License-Identifier: GPL-2.0-only
#include "hard_spheres/hard_event_record.h"

#include <algorithm>
#include <cinttypes>
#include <numeric>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace cohesion::hard_sphere;

namespace {

struct RecordLine {
  EventKey key;
  int kind;
  bool elastic;
};

}  // namespace

HardEventRecord::HardEventRecord(LAMMPS* lammps, const std::string& file)
    : Pointers(lammps), enabled_(!file.empty()), file_(nullptr) {
  if (!enabled_ || comm->me != 0) return;
  file_ = fopen(file.c_str(), "w");
  if (!file_)
    error->one(FLERR, "pair_style hard/squarewell: cannot open file '{}' of keyword record: {}",
               file, utils::getsyserror());
}

HardEventRecord::~HardEventRecord() {
  if (file_) fclose(file_);
}

void HardEventRecord::write(const EventSimulation& simulation) {
  if (!enabled_) return;
  std::vector<RecordLine> mine;
  for (const Event& event : simulation.events)
    if (event.i < atom->nlocal)
      mine.push_back({event.key, static_cast<int>(event.impact.kind), event.elastic});

  const int bytes = static_cast<int>(mine.size() * sizeof(RecordLine));
  std::vector<int> sizes(comm->nprocs), starts(comm->nprocs, 0);
  MPI_Gather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, world);
  std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
  std::vector<RecordLine> all(file_ ? (starts.back() + sizes.back()) / sizeof(RecordLine) : 0);
  MPI_Gatherv(mine.data(), bytes, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, 0,
              world);
  if (!file_) return;
  std::stable_sort(all.begin(), all.end(),
                   [](const RecordLine& a, const RecordLine& b) { return a.key < b.key; });
  for (const RecordLine& line : all)
    fprintf(file_, BIGINT_FORMAT " %.17g %s%s %" PRId64 " %" PRId64 "\n", update->ntimestep,
            (line.key.time - simulation.start()) / update->dt, line.key.tag_j < 0 ? "wall_" : "",
            line.elastic ? "elastic" : event_kind_names[line.kind], line.key.tag_i, line.key.tag_j);
  fflush(file_);
}
