#include "base/threads/team.hpp"

#include "base/hash.hpp"
#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string_view>
#include <thread>
#include <utility>

namespace brdfplot {

namespace {

using namespace std::chrono_literals;

/// The first byte of a message. Of rank 0: work, over, leaving. Of the others: the rest, and leaving.
namespace kind {
constexpr char ready = 'r', report = 'e', work = 'w', events = 'd', over = 's', ended = 'x', leaving = 'g';
} // namespace kind

/// How often the main thread looks for messages while there is nothing to do.
constexpr auto patience = 1ms;
/// mpirun kills a second after SIGTERM.
constexpr auto to_answer = 300ms;
/// A message longer than this is sent before more is added.
constexpr std::size_t long_message = std::size_t{1} << 20;

class Writer {
public:
  explicit Writer(char first) : bytes_(1, first) {}
  template <class Number>
  Writer& add(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
    return *this;
  }
  Writer& add(const Numbers& numbers) {
    add(numbers.size());
    if (!numbers.empty()) bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    return *this;
  }
  Writer& add(const std::string& text) {
    add(text.size());
    bytes_ += text;
    return *this;
  }
  std::size_t size() const { return bytes_.size(); }
  std::string take() { return std::move(bytes_); }

private:
  std::string bytes_;
};

/// Reads what a Writer of another rank, of the same program, wrote.
class Reader {
public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  template <class Number>
  Number number() {
    Number number{};
    std::memcpy(&number, bytes_.data(), sizeof number);
    bytes_.remove_prefix(sizeof number);
    return number;
  }
  Numbers numbers() {
    Numbers numbers(number<std::size_t>());
    if (!numbers.empty()) std::memcpy(numbers.data(), bytes_.data(), numbers.size() * sizeof(double));
    bytes_.remove_prefix(numbers.size() * sizeof(double));
    return numbers;
  }
  std::string text() {
    const auto size = number<std::size_t>();
    std::string text(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
    return text;
  }
  bool done() const { return bytes_.empty(); }

private:
  std::string_view bytes_;
};

std::string name_of(int rank) { return "rank " + std::to_string(rank); }

} // namespace

/// Which rank computes what, and what has come of it.
class Team::Distribution {
public:
  Distribution(Team& team, const std::vector<Numbers>& pieces, std::size_t group,
               const std::function<void(std::size_t, Numbers)>& take)
      : team_(team), pieces_(pieces), take_(take), ranks_(static_cast<std::size_t>(team.count())) {
    for (std::size_t first = 0; first < pieces.size(); first += group) {
      Group one;
      for (std::size_t k = first; k < std::min(first + group, pieces.size()); ++k) {
        if (const Numbers* known = team_.kept_.find(pieces[k]))
          results_.emplace(k, *known);
        else
          one.left.push_back(k);
      }
      std::ranges::reverse(one.left); // taken from its end
      groups_.push_back(std::move(one));
    }
    take_results();
  }

  bool is_done() const { return next_ == pieces_.size(); }
  bool has_failed() const { return failure_ && (lots_.empty() || lots_.begin()->first > failure_->first); }
  const Failure& failure() const { return failure_->second; }

  /// Gives a rank two batches at most: one to compute, one that waits.
  template <class Send>
  void hand_out(int rank, const Send& send) {
    Rank& to = ranks_[static_cast<std::size_t>(rank)];
    while (to.lots < 2 && !failure_) {
      std::vector<std::size_t> lot = next_lot(rank);
      if (lot.empty()) return;
      std::vector<Numbers> pieces;
      for (const std::size_t k : lot) pieces.push_back(pieces_[k]);
      ++to.lots;
      lots_[team_.batches_] = {rank, std::move(lot)};
      send(team_.batches_++, std::move(pieces));
    }
  }

  void handle(Executor::Event event) {
    const auto lot = lots_.find(event.batch);
    if (lot == lots_.end()) return; // of work that has failed
    if (event.kind == Executor::Event::Kind::piece) {
      const std::size_t k = lot->second.pieces[event.piece];
      team_.kept_.add(pieces_[k], event.numbers);
      results_.emplace(k, std::move(event.numbers));
      return take_results();
    }
    --ranks_[static_cast<std::size_t>(lot->second.rank)].lots;
    if (event.kind == Executor::Event::Kind::failed && (!failure_ || event.batch < failure_->first))
      failure_ = {event.batch, std::move(event.failure)};
    lots_.erase(lot);
  }

private:
  struct Group {
    std::vector<std::size_t> left{}; ///< the first one last
    bool begun = false;
  };
  struct Rank {
    std::size_t group = 0;
    bool has_group = false;
    int lots = 0;
  };
  struct Lot {
    int rank = 0;
    std::vector<std::size_t> pieces{};
  };

  void take_results() {
    for (auto first = results_.begin(); first != results_.end() && first->first == next_; first = results_.begin()) {
      take_(next_++, std::move(first->second));
      results_.erase(first);
    }
  }

  /// Its own group; else one that nobody has; else the one of which most is left.
  Group* group_for(Rank& rank) {
    if (rank.has_group && !groups_[rank.group].left.empty()) return &groups_[rank.group];
    auto found = std::ranges::find_if(groups_, [](const Group& one) { return !one.begun && !one.left.empty(); });
    if (found == groups_.end())
      found = std::ranges::max_element(groups_, {}, [](const Group& one) { return one.left.size(); });
    if (found == groups_.end() || found->left.empty()) return nullptr;
    found->begun = true;
    rank.group = static_cast<std::size_t>(found - groups_.begin());
    rank.has_group = true;
    return &*found;
  }

  /// A quarter of each one's share of what is left, so that the last ones are small; none idles a thread.
  std::vector<std::size_t> next_lot(int number) {
    Group* group = group_for(ranks_[static_cast<std::size_t>(number)]);
    if (group == nullptr) return {};
    const auto at = static_cast<std::size_t>(group - groups_.data());
    const auto sharing =
        groups_.size() == 1
            ? static_cast<std::ptrdiff_t>(ranks_.size())
            : std::ranges::count_if(ranks_, [&](const Rank& r) { return r.has_group && r.group == at; });
    const auto threads = static_cast<std::size_t>(team_.mates_[static_cast<std::size_t>(number)].threads);
    const std::size_t share = group->left.size() / (4 * static_cast<std::size_t>(sharing));
    const std::size_t size = std::min(std::max(share, threads), group->left.size());
    std::vector<std::size_t> lot;
    for (std::size_t k = 0; k < size; ++k) {
      lot.push_back(group->left.back());
      group->left.pop_back();
    }
    return lot;
  }

  Team& team_;
  const std::vector<Numbers>& pieces_;
  const std::function<void(std::size_t, Numbers)>& take_;
  std::vector<Rank> ranks_;
  std::vector<Group> groups_;
  std::map<std::size_t, Lot> lots_; ///< that are out, by their batch
  std::map<std::size_t, Numbers> results_;
  std::size_t next_ = 0; ///< to be taken
  std::optional<std::pair<std::size_t, Failure>> failure_;
};

Team::Team(std::unique_ptr<Ranks> ranks, Leave leave)
    : ranks_(std::move(ranks)), leave_(std::move(leave)), mates_(static_cast<std::size_t>(ranks_->count())) {}

int Team::threads() const {
  int sum = 0;
  for (const Mate& mate : mates_) sum += mate.threads;
  return sum;
}

void Team::send_all(char what) {
  for (int rank = 1; rank < count(); ++rank) ranks_->send(rank, std::string(1, what));
}

void Team::handle(const Ranks::Message& message, Distribution* distribution) {
  Mate& mate = mates_[static_cast<std::size_t>(message.from)];
  Reader reader(std::string_view(message.bytes).substr(1));
  switch (message.bytes[0]) {
  case kind::ready: {
    mate.threads = reader.number<int>();
    mate.ready = reader.number<std::uint64_t>() == digest_;
    if (!mate.ready && !reported_) reported_ = {message.from, Failure{2, "its input is not that of rank 0"}};
    return;
  }
  case kind::report: {
    const int code = reader.number<int>();
    if (!reported_) reported_ = {message.from, Failure{code, reader.text()}};
    return;
  }
  case kind::events:
    while (!reader.done()) {
      Executor::Event event;
      event.kind = reader.number<Executor::Event::Kind>();
      event.batch = reader.number<std::size_t>();
      event.piece = reader.number<std::size_t>();
      event.numbers = reader.numbers();
      event.failure.code = reader.number<int>();
      event.failure.text = reader.text();
      if (distribution != nullptr) distribution->handle(std::move(event));
    }
    return;
  case kind::over: over_ = true; return;
  case kind::ended: mate.ended = true; return;
  case kind::leaving: mate.leaving = true; return;
  default: return;
  }
}

void Team::receive(Distribution* distribution) {
  while (const auto message = ranks_->receive()) handle(*message, distribution);
  if (count() == 1) return throw_if_interrupted();
  if (interrupted() || std::ranges::any_of(mates_, &Mate::leaving)) leave_interrupted();
  // Before it was ready, or at work. Between these rank 0 does the same, and tells what is wrong for all.
  if (!reported_ || (distribution == nullptr && mates_[static_cast<std::size_t>(reported_->first)].ready)) return;
  const auto [rank, failure] = *reported_;
  if (failure.code < 0) failure.raise();
  throw Error(failure.code, name_of(rank), failure.text);
}

void Team::begin(const std::string& key, const std::string& folder, int threads) {
  digest_ = hash(key);
  mates_[static_cast<std::size_t>(ranks_->rank())].threads = threads;
  if (!leads()) return ranks_->send(0, Writer(kind::ready).add(threads).add(digest_).take());
  mates_[0].ready = true;
  for (receive(nullptr); !std::ranges::all_of(mates_, &Mate::ready); receive(nullptr))
    std::this_thread::sleep_for(patience);
  kept_ = KeptPieces(folder, key);
}

void Team::map(const std::vector<Numbers>& pieces, std::size_t group, const Compute& compute,
               const std::function<void(std::size_t, Numbers)>& take) {
  Distribution distribution(*this, pieces, group, take);
  Executor executor(compute);
  while (!distribution.is_done() && !distribution.has_failed()) {
    // The others first: a message takes longer.
    for (int rank = count() - 1; rank >= 0; --rank)
      distribution.hand_out(rank, [&](std::size_t batch, std::vector<Numbers> given) {
        if (rank == 0) return executor.add(batch, std::move(given));
        Writer writer(kind::work);
        writer.add(batch);
        for (const Numbers& piece : given) writer.add(piece);
        ranks_->send(rank, writer.take());
      });
    for (Executor::Event& event : executor.events(patience)) distribution.handle(std::move(event));
    receive(&distribution);
  }
  if (!distribution.is_done()) distribution.failure().raise();
}

void Team::serve(const Compute& compute) {
  Executor executor(compute);
  while (!over_) {
    while (const auto message = ranks_->receive()) {
      if (message->bytes[0] != kind::work) {
        handle(*message, nullptr);
        continue;
      }
      Reader reader(std::string_view(message->bytes).substr(1));
      const auto batch = reader.number<std::size_t>();
      std::vector<Numbers> pieces;
      while (!reader.done()) pieces.push_back(reader.numbers());
      executor.add(batch, std::move(pieces));
    }
    if (interrupted() || mates_[0].leaving) leave_interrupted();
    Writer writer(kind::events);
    for (const Executor::Event& event : executor.events(patience)) {
      writer.add(event.kind).add(event.batch).add(event.piece).add(event.numbers);
      writer.add(event.failure.code).add(event.failure.text);
      if (writer.size() > long_message) ranks_->send(0, std::exchange(writer, Writer(kind::events)).take());
    }
    if (writer.size() > 1) ranks_->send(0, writer.take());
  }
}

void Team::report(const Failure& failure) {
  ranks_->send(0, Writer(kind::report).add(failure.code).add(failure.text).take());
}

void Team::end() {
  if (count() == 1) return;
  const auto wait = [&](const auto& until) {
    for (;; std::this_thread::sleep_for(patience)) {
      while (const auto message = ranks_->receive()) handle(*message, nullptr);
      if (interrupted() || std::ranges::any_of(mates_, &Mate::leaving)) leave_interrupted();
      if (until()) return;
    }
  };
  if (leads()) {
    send_all(kind::over);
    wait([&] { return std::all_of(mates_.begin() + 1, mates_.end(), [](const Mate& mate) { return mate.ended; }); });
  } else {
    wait([&] { return over_; });
    ranks_->send(0, std::string(1, kind::ended));
  }
  ranks_->end();
}

void Team::leave_interrupted() {
  if (leads())
    send_all(kind::leaving);
  else
    ranks_->send(0, std::string(1, kind::leaving));
  const auto all_here = [&] {
    if (!leads()) return mates_[0].leaving;
    return std::all_of(mates_.begin() + 1, mates_.end(), [](const Mate& mate) { return mate.leaving || mate.ended; });
  };
  const auto began = std::chrono::steady_clock::now();
  while (!all_here() && std::chrono::steady_clock::now() - began < to_answer) {
    while (const auto message = ranks_->receive()) handle(*message, nullptr);
    std::this_thread::sleep_for(patience);
  }
  const std::string kept = kept_ ? "; what was finished is kept for the next run" : "";
  const Interrupted interrupted_all;
  if (!leads()) {
    const Error error(3, name_of(0), "it has died");
    leave_(ranks_->rank() == 1 && !all_here() ? &error : nullptr);
  } else if (all_here()) {
    leave_(&interrupted_all);
  } else {
    const auto dead =
        std::find_if(mates_.begin() + 1, mates_.end(), [](const Mate& m) { return !m.leaving && !m.ended; });
    const Error error(3, name_of(static_cast<int>(dead - mates_.begin())), "it has died" + kept);
    leave_(&error);
  }
  std::abort(); // leave_ does not return
}

} // namespace brdfplot
