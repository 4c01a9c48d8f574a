#include "ranks.hpp"

#ifdef ALATE_WITH_MPI
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <mutex>
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
  int threads = 0;
  if (!under_mpirun() || MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &threads) != MPI_SUCCESS) return;
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

/// A number in the memory of the first rank that others change where it lies.
struct SharedCounter::Window {
  Window() {
    MPI_Win_allocate(sizeof(std::uint64_t), sizeof(std::uint64_t), MPI_INFO_NULL, MPI_COMM_WORLD,
                     static_cast<void*>(&number), &window);
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, own_rank(), 0, window);
    *number = 0;
    MPI_Win_unlock(own_rank(), window);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  ~Window() { MPI_Win_free(&window); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  static int own_rank() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
  }

  std::uint64_t next() {
    const std::lock_guard lock(mutex);
    const std::uint64_t one = 1;
    std::uint64_t before = 0;
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window);
    MPI_Fetch_and_op(&one, &before, MPI_UINT64_T, 0, 0, MPI_SUM, window);
    MPI_Win_unlock(0, window);
    return before;
  }

  MPI_Win window = MPI_WIN_NULL;
  std::uint64_t* number = nullptr;
  std::mutex mutex;  ///< Threads may call MPI one after another.
};

SharedCounter::SharedCounter(const Ranks& ranks) {
  if (ranks.count() > 1) window_ = std::make_unique<Window>();
}

std::size_t SharedCounter::next() { return window_ ? window_->next() : own_++; }

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
bool Ranks::all(bool mine) const { return mine; }
void Ranks::abort(int /*code*/) const {}

struct SharedCounter::Window {};
SharedCounter::SharedCounter(const Ranks& /*ranks*/) {}
std::size_t SharedCounter::next() { return own_++; }

#endif

SharedCounter::~SharedCounter() = default;

}  // namespace alate::cli
