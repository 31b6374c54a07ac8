/// \file
/// Processes that work together, as mpirun starts them, and messages between them. Who uses it knows no MPI.
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace brdfplot {

/// The processes of a run, of which this is one; by itself it is the only one. Every call is the main thread's.
class Ranks {
public:
  struct Message {
    int from = 0;
    std::string bytes{};
  };

  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  virtual int rank() const { return 0; }
  virtual int count() const { return 1; }
  /// How many of them share this machine, this one among them.
  virtual int on_this_machine() const { return 1; }
  /// Returns at once; messages to one rank arrive in their order.
  virtual void send(int /*to*/, std::string /*bytes*/) {}
  /// A message that has arrived; nothing when there is none.
  virtual std::optional<Message> receive() { return std::nullopt; }
  /// Once what was sent has arrived and all ranks call this.
  virtual void end() {}
};

/// What a launcher of MPI says in the environment (Open MPI's mpirun, and those of the PMI of MPICH and Slurm).
struct Launched {
  bool by_mpirun = false;
  int rank = 0;
  int count = 1;
};
Launched launched();

} // namespace brdfplot
