#include "stream/stream.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "stream/evaluator.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace brdfplot {

namespace {

/// A block of closed forms is this much text; one of integrals is small, because each row takes long: so the threads
/// end together, and results are seen soon.
constexpr std::size_t block_size = std::size_t{256} << 10;
constexpr std::size_t integral_block_size = std::size_t{1} << 10;

std::vector<std::string> output_names(const StreamPlan& plan) {
  std::vector<std::string> names;
  for (const auto& quantity : plan.options.quantities) {
    if (plan.channels_of(quantity) == 1)
      names.push_back(quantity.name);
    else
      for (const char* channel : {"_r", "_g", "_b"}) names.push_back(quantity.name + channel);
  }
  return names;
}

/// "; found: theta, z_o": what the header has, for an error of what it lacks.
std::string found_columns(const StreamPlan& plan) {
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(plan.columns.names().size(), 20); ++k)
    text += (text.empty() ? "" : ", ") + echo(plan.columns.names()[k]);
  return "; found: " + text;
}

/// Whether the columns are all that the quantities need. WHERE of what is missing is `where`.
void require_columns(const StreamPlan& plan, const std::string& where) {
  using enum Letter;
  Material placed = plan.material;
  placed.name = where; // require() names the material as the place
  for (const auto& quantity : plan.options.quantities) {
    try {
      if (const auto* info = quantity.closed_form())
        require(placed, *info, plan.columns.has(o), plan.columns.has(i), plan.columns.has(m), quantity.term);
      else if (quantity.is_density()) // of two directions, as the BRDF is
        require(placed, info_of(Quantity::brdf), plan.columns.has(o), plan.columns.has(i), false);
      else if (!plan.columns.has(o))
        throw InputError(where, "\"" + quantity.name + "\" needs omega_o: theta_o [phi_o] or x_o y_o z_o");
    } catch (const InputError& error) {
      const std::string what = error.what();
      if (what.find(" needs omega_") == std::string::npos) throw;
      throw InputError("", what + found_columns(plan));
    }
  }
  for (const auto& name : output_names(plan))
    if (std::ranges::find(plan.columns.names(), name) != plan.columns.names().end())
      throw InputError(where, "column \"" + name + "\" is there already; the output would have it twice");
}

/// Threads take turns: each takes the next block, evaluates it while others take theirs, and waits for its turn to
/// write. So there is one block a thread in memory, and the order is kept.
class Pipeline {
public:
  Pipeline(const StreamPlan& plan, RowReader& reader, RowSource& in, OutputFile& out)
      : plan_(plan), reader_(reader), in_(in), out_(out) {}

  void run() {
    run_on_threads(plan_.options.threads, [this] { work(); });
    throw_if_interrupted();
    if (failure_) std::rethrow_exception(failure_);
  }

private:
  struct Turn {
    std::size_t number = 0;
    RowBlock block;
    std::exception_ptr failure;
  };

  void work() {
    try {
      StreamEvaluator evaluator(plan_);
      std::string text;
      for (Turn turn; take(turn);) {
        text.clear();
        try {
          if (!turn.failure) turn.failure = evaluator.run(turn.block, text);
        } catch (...) {
          turn.failure = std::current_exception();
        }
        deliver(turn, text);
      }
    } catch (...) { // memory for the evaluator
      const std::lock_guard lock(output_mutex_);
      stop(std::current_exception());
    }
  }

  bool take(Turn& turn) {
    const std::lock_guard lock(input_mutex_);
    if (ended_) return false;
    turn.failure = nullptr;
    try {
      if (!reader_.next(turn.block)) ended_ = true;
    } catch (...) {
      turn.failure = std::current_exception();
      ended_ = true;
    }
    if (ended_ && !turn.failure) return false;
    turn.number = taken_++;
    return true;
  }

  void deliver(const Turn& turn, const std::string& text) {
    std::unique_lock lock(output_mutex_);
    turn_came_.wait(lock, [&] { return written_ == turn.number; });
    try {
      if (!failure_) out_.write(text);
      if (turn.failure) stop(turn.failure);
    } catch (...) {
      stop(std::current_exception());
    }
    ++written_;
    turn_came_.notify_all();
  }

  /// Keeps the first failure, and ends the reading.
  void stop(std::exception_ptr failure) {
    if (!failure_) failure_ = std::move(failure);
    in_.stop();
  }

  const StreamPlan& plan_;
  RowReader& reader_;
  RowSource& in_;
  OutputFile& out_;
  std::mutex input_mutex_;
  std::size_t taken_ = 0;
  bool ended_ = false;
  std::mutex output_mutex_;
  std::condition_variable turn_came_;
  std::size_t written_ = 0;
  std::exception_ptr failure_;
};

} // namespace

std::vector<StreamQuantity> select_quantities(const std::vector<std::string>& names, const std::string& where) {
  std::vector<StreamQuantity> all;
  for (const auto& info : quantities()) all.push_back({info.name, "", info});
  for (const auto& info : integrals()) all.push_back({info.name, "", info});
  all.push_back({DensityInfo{}.name, "", DensityInfo{}});
  std::vector<std::string> known;
  for (const auto& quantity : all) known.push_back(quantity.name);
  std::vector<StreamQuantity> selected;
  for (const auto& name : names) {
    if (std::ranges::count(names, name) > 1)
      throw InputError(where, "quantity \"" + echo(name) + "\" is asked for twice");
    const std::size_t dot = name.rfind('.');
    const std::string quantity = dot == std::string::npos ? name : name.substr(dot + 1);
    const auto found = std::ranges::find(all, quantity, &StreamQuantity::name);
    if (found == all.end()) throw InputError(where, unknown_name("quantity", name, known));
    if (found->is_density() && dot != std::string::npos)
      throw InputError(where, "found \"" + echo(name) + "\", accepted: pdf, which is of all terms together");
    selected.push_back({name, dot == std::string::npos ? "" : name.substr(0, dot), found->info});
  }
  return selected;
}

void evaluate_stream(const Material& material, const StreamOptions& options, InputFile& in, OutputFile& out) {
  FileRows rows(in);
  evaluate_stream(material, options, rows, out);
}

void evaluate_stream(const Material& material, const StreamOptions& options, RowSource& in, OutputFile& out) {
  std::optional<Sampler> sampler;
  for (const auto& quantity : options.quantities)
    if (const auto* info = quantity.closed_form())
      require(material, *info, true, true, true, quantity.term);
    else if (const auto* of_directions = quantity.integral())
      require(material, *of_directions, quantity.term);
    else
      sampler.emplace(material, options.strategy);
  if (sampler && options.single_precision)
    throw InputError("--precision", "found \"single\" with \"pdf\"; accepted: double");
  const auto integral = std::ranges::find_if(options.quantities, [](const auto& q) { return q.integral() != nullptr; });
  const bool slow = integral != options.quantities.end();
  if (slow && options.single_precision)
    throw InputError("--precision", "found \"single\" with the integral \"" + integral->name +
                                        "\"; accepted: double, or quantities with a closed form only");
  RowReader reader(in, slow ? integral_block_size : block_size);
  std::string header = reader.header();
  const std::string where = in.header_name(reader.header_line());
  if (header.empty())
    throw InputError(where, "found no header; accepted: a line that names the columns, such as theta_o,phi_o");
  const StreamPlan plan{material, options, DirectionColumns(header, where), in.name(), std::move(sampler)};
  require_columns(plan, where);
  for (const auto& name : output_names(plan)) header += "," + name;
  out.write(header + "\n");
  Pipeline(plan, reader, in, out).run();
}

} // namespace brdfplot
