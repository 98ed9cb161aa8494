// SPDX-License-Identifier: GPL-3.0-or-later
// On 2 ranks: rank 1 expects three records of four numbers of rank 0, which sends what the word on
// the command line says. exchange_sizes.py knows the words.
#include <mpi.h>

#include <cstddef>
#include <string>
#include <vector>

#include "coupling/exchange/exchangeLists.H"
#include "coupling/exchange/neighbourSizes.H"

using namespace Foam;

namespace {

constexpr label expected = 3;
constexpr int numbers = 4;

/// Rank 0 sends `count` records of `length` numbers.
void send(label count, int length) {
  const int me = UPstream::myProcNo();
  std::vector<double> values(20, double(me));
  std::vector<Records> to(2), from(2);
  if (me == 0)
    to[1] = {values.data(), count};
  else
    from[0] = {values.data(), expected};
  exchangeRecords(to, from, sizeof(double) * std::size_t(me == 0 ? length : numbers));
  if (me == 1) Pout << "received " << values[0] << ' ' << values[expected * numbers - 1] << endl;
}

/// The number of what is to come is itself of other size.
void send_size(int bytes) {
  if (UPstream::myProcNo() == 0) {
    const char size[8] = {};
    MPI_Ssend(size, bytes, MPI_BYTE, 1, neighbourSizes::oddTag, MPI_COMM_WORLD);
  }
  neighbourSizes()(labelList(2, Zero));
  Pout << "received" << endl;
}

}  // namespace

int main(int argc, char** argv) {
  UPstream::init(argc, argv, false);
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "right") send(expected, numbers);
  if (what == "fewer") send(expected - 1, numbers);
  if (what == "more") send(expected + 1, numbers);
  if (what == "part") send(expected, numbers - 1);
  if (what == "size") send_size(sizeof(label) - 1);
  // Rank 0 is still in its run when rank 1 stops it, as in a gas step: mpirun may hang where one
  // rank aborts while another is in MPI_Finalize.
  MPI_Barrier(MPI_COMM_WORLD);
  UPstream::exit(0);
}
