// SPDX-License-Identifier: GPL-2.0-or-later
#include "piece_exchange.h"

#include <algorithm>

#include "lmptype.h"

using namespace LAMMPS_NS;
using namespace cohesion::agglomerates;

static constexpr int PIECE = sizeof(Piece) / sizeof(double);
static_assert(PIECE == 7, "pieces are sent as plain numbers");

std::vector<Piece> LAMMPS_NS::whole_pieces(MPI_Comm world, const std::vector<Piece>& mine,
                                           std::vector<double>& sizes) {
  int ranks;
  MPI_Comm_size(world, &ranks);
  const auto home = [ranks](const Piece& p) {
    return static_cast<int>(static_cast<tagint>(p.label) % ranks);
  };
  std::vector<int> send(ranks, 0), receive(ranks), send_at(ranks, 0), receive_at(ranks, 0);
  for (const Piece& p : mine) send[home(p)]++;
  MPI_Alltoall(send.data(), 1, MPI_INT, receive.data(), 1, MPI_INT, world);
  for (int r = 1; r < ranks; r++) {
    send_at[r] = send_at[r - 1] + send[r - 1];
    receive_at[r] = receive_at[r - 1] + receive[r - 1];
  }
  std::vector<Piece> outgoing(mine.size()), incoming(receive_at.back() + receive.back());
  std::vector<int> next = send_at, where;
  for (const Piece& p : mine) {
    where.push_back(next[home(p)]++);
    outgoing[where.back()] = p;
  }
  MPI_Datatype piece;
  MPI_Type_contiguous(PIECE, MPI_DOUBLE, &piece);
  MPI_Type_commit(&piece);
  MPI_Alltoallv(outgoing.data(), send.data(), send_at.data(), piece, incoming.data(),
                receive.data(), receive_at.data(), piece, world);
  MPI_Type_free(&piece);

  const std::vector<Piece> whole = put_together(incoming);
  std::vector<double> answers, returned(mine.size());
  for (const Piece& p : incoming)
    answers.push_back(
        std::lower_bound(whole.begin(), whole.end(), p.label, [](const Piece& a, double b) {
          return a.label < b;
        })->count);
  MPI_Alltoallv(answers.data(), receive.data(), receive_at.data(), MPI_DOUBLE, returned.data(),
                send.data(), send_at.data(), MPI_DOUBLE, world);
  sizes.clear();
  for (const int k : where) sizes.push_back(returned[k]);
  return whole;
}
