// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/fragment_exchange.h"

#include <algorithm>

#include "lmptype.h"

using namespace LAMMPS_NS;
using namespace cohesion::agglomerates;

static constexpr int FRAGMENT = sizeof(Fragment) / sizeof(double);
static constexpr int EXTENT = sizeof(Extent) / sizeof(double);
static_assert(FRAGMENT == 7 && EXTENT == 2, "fragments and extents are sent as plain numbers");

static MPI_Datatype numbers(int count) {
  MPI_Datatype row;
  MPI_Type_contiguous(count, MPI_DOUBLE, &row);
  MPI_Type_commit(&row);
  return row;
}

std::vector<Fragment> LAMMPS_NS::merge_across_ranks(MPI_Comm world,
                                                    const std::vector<Fragment>& mine,
                                                    std::vector<Extent>& extents) {
  int ranks;
  MPI_Comm_size(world, &ranks);
  const auto home = [ranks](const Fragment& p) {
    return static_cast<int>(static_cast<tagint>(p.label) % ranks);
  };
  std::vector<int> send(ranks, 0), receive(ranks), send_at(ranks, 0), receive_at(ranks, 0);
  for (const Fragment& p : mine) send[home(p)]++;
  MPI_Alltoall(send.data(), 1, MPI_INT, receive.data(), 1, MPI_INT, world);
  for (int r = 1; r < ranks; r++) {
    send_at[r] = send_at[r - 1] + send[r - 1];
    receive_at[r] = receive_at[r - 1] + receive[r - 1];
  }
  std::vector<Fragment> outgoing(mine.size()), incoming(receive_at.back() + receive.back());
  std::vector<int> next = send_at, where;
  for (const Fragment& p : mine) {
    where.push_back(next[home(p)]++);
    outgoing[where.back()] = p;
  }
  MPI_Datatype fragment = numbers(FRAGMENT), of_whole = numbers(EXTENT);
  MPI_Alltoallv(outgoing.data(), send.data(), send_at.data(), fragment, incoming.data(),
                receive.data(), receive_at.data(), fragment, world);
  MPI_Type_free(&fragment);

  const std::vector<Fragment> whole = merge_fragments(incoming);
  std::vector<Extent> merged, returned(mine.size());
  for (const Fragment& p : incoming)
    merged.push_back(
        extent(*std::lower_bound(whole.begin(), whole.end(), p.label,
                                 [](const Fragment& a, double b) { return a.label < b; })));
  MPI_Alltoallv(merged.data(), receive.data(), receive_at.data(), of_whole, returned.data(),
                send.data(), send_at.data(), of_whole, world);
  MPI_Type_free(&of_whole);
  extents.clear();
  for (const int k : where) extents.push_back(returned[k]);
  return whole;
}
