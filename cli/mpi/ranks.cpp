/// \file
/// The only file that knows MPI. Without BRDFPLOT_MPI it knows that there is none.

#include "start_ranks.hpp"

#include "base/errors.hpp"

#ifdef BRDFPLOT_MPI

// Bindings for C++ that MPI itself has withdrawn.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <deque>
#include <limits>
#include <stdexcept>
#include <utility>

namespace brdfplot::cli {

namespace {

class MpiRanks final : public Ranks {
public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    if (provided < MPI_THREAD_FUNNELED) throw InputError("MPI", "it was built without threads");
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &here_);
    MPI_Comm_free(&machine);
  }

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  int on_this_machine() const override { return here_; }

  void send(int to, std::string bytes) override {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw std::length_error("a message of 2 GiB and more");
    forget_arrived();
    Sent& sent = sent_.emplace_back();
    sent.bytes = std::move(bytes);
    MPI_Isend(sent.bytes.data(), static_cast<int>(sent.bytes.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD, &sent.request);
  }

  std::optional<Message> receive() override {
    forget_arrived();
    int arrived = 0, size = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &arrived, &status);
    if (arrived == 0) return std::nullopt;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

  void end() override {
    for (Sent& sent : sent_) MPI_Wait(&sent.request, MPI_STATUS_IGNORE);
    MPI_Finalize();
  }

private:
  struct Sent {
    std::string bytes{};
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void forget_arrived() {
    for (int arrived = 1; !sent_.empty(); sent_.pop_front()) {
      MPI_Test(&sent_.front().request, &arrived, MPI_STATUS_IGNORE);
      if (arrived == 0) return;
    }
  }

  int rank_ = 0, count_ = 1, here_ = 1;
  std::deque<Sent> sent_; // not moved: MPI reads the bytes where they are
};

} // namespace

std::unique_ptr<Ranks> start_ranks() {
  if (launched().count == 1) return std::make_unique<Ranks>();
  return std::make_unique<MpiRanks>();
}

} // namespace brdfplot::cli

#else

namespace brdfplot::cli {

std::unique_ptr<Ranks> start_ranks() {
  const int count = launched().count;
  if (count > 1)
    throw InputError("mpirun", "found " + std::to_string(count) +
                                   " ranks, accepted: 1; this brdfplot was built without BRDFPLOT_MPI");
  return std::make_unique<Ranks>();
}

} // namespace brdfplot::cli

#endif
