#include "math/formula.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

namespace brdfplot {

namespace {

struct Source {
  std::string text;
  std::vector<std::string> variables;
  auto operator<=>(const Source&) const = default;
};

/// A parser that knows this project's names, and nothing with an underscore in front as muParser's own constants have.
mu::Parser bare_parser() {
  mu::Parser parser;
  parser.ClearConst();
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
  parser.DefineFun("erfc", static_cast<double (*)(double)>(std::erfc));
  parser.DefineFun("expm1", static_cast<double (*)(double)>(std::expm1));
  parser.DefineFun("log1p", static_cast<double (*)(double)>(std::log1p));
  parser.DefineFun("gamma", static_cast<double (*)(double)>(std::tgamma));
  parser.DefineFun("pow", static_cast<double (*)(double, double)>(std::pow));
  parser.DefineFun("hypot", static_cast<double (*)(double, double)>(std::hypot));
  return parser;
}

/// A formula compiled for one thread: evaluation writes into the parser and into the values bound to it.
class Program {
public:
  explicit Program(const Source& source) : values_(source.variables.size()), parser_(bare_parser()) {
    for (std::size_t k = 0; k < values_.size(); ++k) parser_.DefineVar(source.variables[k], &values_[k]);
    parser_.SetExpr(source.text);
  }

  double operator()(std::span<const double> values) {
    std::ranges::copy(values, values_.begin());
    return parser_.Eval();
  }
  /// Of the last evaluation: "1, 2" has two.
  int results() const { return parser_.GetNumResults(); }

private:
  std::vector<double> values_;
  mu::Parser parser_;
};

/// Every formula that was made, by number. Materials are built anew for each point of a figure, mostly with the same
/// formula; the table grows with the number of different ones.
class Table {
public:
  std::size_t add(Source source) {
    const std::lock_guard lock(mutex_);
    const auto [place, is_new] = numbers_.try_emplace(std::move(source), sources_.size());
    if (is_new) sources_.push_back(place->first);
    return place->second;
  }
  Source source(std::size_t number) {
    const std::lock_guard lock(mutex_);
    return sources_[number];
  }

private:
  std::mutex mutex_;
  std::map<Source, std::size_t> numbers_;
  std::deque<Source> sources_;
};

Table& table() {
  static Table all;
  return all;
}

std::string explained(const mu::ParserError& error) {
  std::string what = error.GetMsg();
  std::ranges::replace_if(
      what, [](unsigned char c) { return c < 0x20; }, ' ');
  if (what.ends_with('.')) what.pop_back();
  if (error.GetPos() >= 0 && what.find("position") == std::string::npos)
    what += " at position " + std::to_string(error.GetPos());
  return echo(what, 200);
}

/// Where `text` assigns to a variable, which muParser allows: an `=` that is no part of a comparison.
std::optional<std::size_t> assignment(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '=') continue;
    const bool equal = k + 1 < text.size() && text[k + 1] == '=';
    if (!equal && (k == 0 || std::string("<>!=").find(text[k - 1]) == std::string::npos)) return k;
    if (equal) ++k;
  }
  return std::nullopt;
}

} // namespace

std::optional<FormulaProblem> Formula::problem(const std::string& text, const std::vector<std::string>& variables) {
  if (const auto place = assignment(text))
    return FormulaProblem{"", "assignment at position " + std::to_string(*place) + "; == compares"};
  try {
    Program program({text, variables});
    // Anything but a number to divide by would do: only whether it can be evaluated is asked.
    (void)program(std::vector<double>(variables.size(), 0.5));
    if (program.results() != 1)
      return FormulaProblem{"", "it has " + std::to_string(program.results()) + " values; accepted: one"};
  } catch (const mu::ParserError& error) {
    return FormulaProblem{error.GetCode() == mu::ecUNASSIGNABLE_TOKEN ? error.GetToken() : "", explained(error)};
  }
  return std::nullopt;
}

Formula::Formula(std::string text, std::vector<std::string> variables) : text_(std::move(text)) {
  if (const auto wrong = problem(text_, variables)) throw InputError("formula \"" + echo(text_) + "\"", wrong->what);
  program_ = table().add({text_, std::move(variables)});
}

double Formula::operator()(std::span<const double> values) const {
  thread_local std::vector<std::unique_ptr<Program>> programs;
  if (programs.size() <= program_) programs.resize(program_ + 1);
  auto& program = programs[program_];
  if (!program) program = std::make_unique<Program>(table().source(program_));
  return (*program)(values);
}

std::vector<std::string> names_in_formulas() {
  const mu::Parser parser = bare_parser();
  std::vector<std::string> names;
  for (const auto& constant : parser.GetConst()) names.push_back(constant.first);
  for (const auto& function : parser.GetFunDef()) names.push_back(function.first);
  std::ranges::sort(names);
  return names;
}

} // namespace brdfplot
