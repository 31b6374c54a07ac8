/// \file
/// Work divided among ranks: rank 0 hands out pieces and takes what comes of them in their order, so that the result is
/// that of one process; what has been finished is kept for the next run.
#pragma once

#include "base/errors.hpp"
#include "base/kept.hpp"
#include "base/threads/executor.hpp"
#include "base/threads/ranks.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot {

/// The ranks of a run. All of them read the same input and call begin(); then rank 0 calls map(), as often as it likes,
/// and the others serve(); at last all call end(). All calls are the main thread's.
class Team {
public:
  /// Ends the process with an error that is to be told, or (null) without a word. Does not return.
  using Leave = std::function<void(const Error*)>;

  Team(std::unique_ptr<Ranks> ranks, Leave leave);

  bool leads() const { return ranks_->rank() == 0; }
  int count() const { return ranks_->count(); }
  int on_this_machine() const { return ranks_->on_this_machine(); }
  /// Threads of all ranks, once it has begun.
  int threads() const;

  /// `key` defines all numbers, and has to be the same for every rank. Finished pieces are kept in the folder, unless
  /// it is empty. \throws InputError where another rank has another key, and Error with what another rank could not
  /// read
  void begin(const std::string& key, const std::string& folder, int threads);

  /// Rank 0: computes the pieces, in groups of `group` that a rank should rather have to itself, and calls
  /// take(k, numbers) in ascending order of k. \throws the failure of the batch that was handed out first among those
  /// that failed, which of one group is that of the smallest piece; Interrupted when this is the only rank
  void map(const std::vector<Numbers>& pieces, std::size_t group, const Compute& compute,
           const std::function<void(std::size_t, Numbers)>& take);
  /// The others: computes what they are sent, until rank 0 ends.
  void serve(const Compute& compute);

  /// All has been computed and written: there is nothing to keep for the next run.
  void forget() { kept_.remove(); }

  /// The others: tells rank 0 what went wrong here. Then end().
  void report(const Failure& failure);
  /// At the end of every rank, well or not.
  void end();
  /// After SIGTERM, which is what mpirun does to all when one has died, and SIGINT: says who has died, or that the run
  /// was interrupted, and leaves. It has the second that mpirun gives.
  [[noreturn]] void leave_interrupted();

private:
  class Distribution;

  struct Mate {
    bool ready = false;   ///< has begun with the same key
    bool leaving = false; ///< was interrupted, and lives
    bool ended = false;   ///< sends nothing any more
    int threads = 1;
  };

  void receive(Distribution* distribution);
  void handle(const Ranks::Message& message, Distribution* distribution);
  void send_all(char what);

  std::unique_ptr<Ranks> ranks_;
  Leave leave_;
  std::vector<Mate> mates_;
  std::optional<std::pair<int, Failure>> reported_; ///< by another rank
  std::uint64_t digest_ = 0;
  KeptPieces kept_;
  bool over_ = false; ///< rank 0 has said that it ends
  std::size_t batches_ = 0;
};

} // namespace brdfplot
