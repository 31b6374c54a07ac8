#include "base/threads/team.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <numeric>
#include <thread>

using namespace brdfplot;

namespace {

/// What has been sent to each rank, all of them threads of this process.
struct Mail {
  explicit Mail(int count) : boxes(static_cast<std::size_t>(count)) {}
  std::mutex mutex;
  std::vector<std::vector<Ranks::Message>> boxes;
};

class ThreadRanks final : public Ranks {
public:
  ThreadRanks(Mail& mail, int rank) : mail_(mail), rank_(rank) {}
  int rank() const override { return rank_; }
  int count() const override { return static_cast<int>(mail_.boxes.size()); }
  void send(int to, std::string bytes) override {
    const std::lock_guard lock(mail_.mutex);
    mail_.boxes[static_cast<std::size_t>(to)].push_back({rank_, std::move(bytes)});
  }
  std::optional<Message> receive() override {
    const std::lock_guard lock(mail_.mutex);
    auto& box = mail_.boxes[static_cast<std::size_t>(rank_)];
    if (box.empty()) return std::nullopt;
    Message first = std::move(box.front());
    box.erase(box.begin());
    return first;
  }

private:
  Mail& mail_;
  int rank_;
};

void leave(const Error*) { FAIL("nobody was interrupted"); }

std::vector<Numbers> pieces_of(std::size_t count) {
  std::vector<Numbers> pieces;
  for (std::size_t k = 0; k < count; ++k) pieces.push_back({static_cast<double>(k)});
  return pieces;
}

/// Squares; not of what is in `wrong`.
Compute squares(std::vector<double> wrong = {}) {
  return [wrong = std::move(wrong)](std::span<const Numbers> pieces, const Done& done) {
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const double x = pieces[k][0];
      if (std::find(wrong.begin(), wrong.end(), x) != wrong.end()) throw InputError("", std::to_string(x));
      done(k, {x * x, -x});
    }
  };
}

/// lead(team) on rank 0, while the others compute.
template <class Lead>
void on_ranks(int count, const Compute& compute, const Lead& lead) {
  Mail mail(count);
  std::vector<std::jthread> others;
  for (int rank = 1; rank < count; ++rank)
    others.emplace_back([&mail, &compute, rank] {
      Team team(std::make_unique<ThreadRanks>(mail, rank), leave);
      team.begin("key", "", 1);
      team.serve(compute);
      team.end();
    });
  Team team(std::make_unique<ThreadRanks>(mail, 0), leave);
  team.begin("key", "", 1);
  lead(team);
  team.end();
}

} // namespace

TEST_CASE("pieces come in their order, whoever computed them") {
  for (const int ranks : {1, 2, 5})
    for (const std::size_t group : {1U, 7U, 100U}) {
      std::vector<double> taken;
      on_ranks(ranks, squares(), [&](Team& team) {
        for (const std::size_t count : {0U, 1U, 50U})
          team.map(pieces_of(count), group, squares(), [&](std::size_t k, const Numbers& numbers) {
            CHECK(numbers == Numbers{static_cast<double>(k * k), -static_cast<double>(k)});
            taken.push_back(static_cast<double>(k));
          });
      });
      std::vector<double> expected(51);
      std::iota(expected.begin() + 1, expected.end(), 0);
      CHECK(taken == expected);
    }
}

TEST_CASE("the failure of the smallest piece is the one") {
  for (const int ranks : {1, 2, 5})
    for (int repetition = 0; repetition < 5; ++repetition)
      on_ranks(ranks, squares({40, 23, 71}), [&](Team& team) {
        CHECK_THROWS_WITH(team.map(pieces_of(100), 100, squares({40, 23, 71}), [](std::size_t, const Numbers&) {}),
                          "23.000000");
      });
}

TEST_CASE("what is kept of a run is what was whole") {
  const std::string folder = (std::filesystem::temp_directory_path() / "brdfplot-test-kept").string();
  std::filesystem::remove_all(folder);
  const std::string path = KeptPieces::path(folder, "key");
  {
    KeptPieces kept(folder, "key");
    CHECK(!std::filesystem::exists(folder));
    CHECK(!kept);
    kept.add({1, 2}, {3});
    kept.add({4}, {});
    CHECK(kept);
    KeptPieces other(folder, "key"); // the first one holds the file
    CHECK(!other);
    CHECK(other.find({1, 2}) == nullptr);
  }
  const auto whole = std::filesystem::file_size(path);
  std::ofstream(path, std::ios::binary | std::ios::app) << std::string(30, '\1');
  {
    KeptPieces kept(folder, "key");
    REQUIRE(kept.find({1, 2}) != nullptr);
    CHECK(*kept.find({1, 2}) == Numbers{3});
    REQUIRE(kept.find({4}) != nullptr);
    CHECK(kept.find({4})->empty());
    CHECK(kept.find({1}) == nullptr);
    CHECK(std::filesystem::file_size(path) == whole);
    kept.remove();
    CHECK(!std::filesystem::exists(path));
  }
  // Half a head, and one of another key.
  for (const char* text : {"brdf", "brdfplot pieces 1 5\nother\n"}) {
    std::ofstream(path, std::ios::binary) << text;
    KeptPieces kept(folder, "key");
    CHECK(kept.find({1, 2}) == nullptr);
    kept.add({5}, {6});
    kept = KeptPieces();
    CHECK(*KeptPieces(folder, "key").find({5}) == Numbers{6});
  }
  std::filesystem::remove_all(folder);
}
