#include "ranks.hpp"

#ifdef ALATE_WITH_MPI
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#endif

namespace alate::cli {

#ifdef ALATE_WITH_MPI

namespace {

/// Open MPI, and MPICH with its relatives.
bool under_mpirun() {
  constexpr std::array kMarks{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
  return std::ranges::any_of(kMarks, [](const char* name) { return std::getenv(name) != nullptr; });
}

}  // namespace

Ranks::Ranks() {
  if (!under_mpirun() || MPI_Init(nullptr, nullptr) != MPI_SUCCESS) return;
  started_ = true;
  int rank = 0;
  int count = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  rank_ = static_cast<std::size_t>(rank);
  count_ = static_cast<std::size_t>(count);
}

Ranks::~Ranks() {
  if (started_) MPI_Finalize();
}

bool Ranks::all(bool mine) const {
  if (!started_) return mine;
  const int given = mine ? 1 : 0;
  int least = given;
  MPI_Allreduce(&given, &least, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return least == 1;
}

void Ranks::abort(int code) const {
  if (count_ > 1) MPI_Abort(MPI_COMM_WORLD, code);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
bool Ranks::all(bool mine) const { return mine; }
void Ranks::abort(int /*code*/) const {}

#endif

}  // namespace alate::cli
