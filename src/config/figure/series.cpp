#include "config/figure/series.hpp"

#include "base/errors.hpp"
#include "config/figure/labels.hpp"
#include "figure/series/configuration.hpp"
#include "figure/series/simulated.hpp"

#include <algorithm>
#include <array>

namespace brdfplot::config {

namespace {

using plot::Expression;

/// The channels of `"channel": "rgb"`.
constexpr std::array<const char*, 3> each_channel = {"r", "g", "b"};

/// What is fixed is not swept: a flat line is no curve. Operands may fix it: they are what others are compared with.
void check_free(const SeriesContext& context, const Scope& scope) {
  const auto fixes = [](const std::string& set, const std::string& swept) {
    return set == swept || (set == "a" && swept == "theta_o") || (set == "slope" && swept == "theta_m");
  };
  for (std::size_t k = 0; k < scope.at.size(); ++k)
    for (const Sweep& sweep : context.swept)
      if (fixes(scope.at[k].variable, sweep.variable))
        context.file.fail(scope.places[k], "\"" + scope.at[k].variable + "\" fixes \"" + sweep.variable +
                                               "\", which is swept by " + sweep.place +
                                               "; accepted: one of the two, or to fix it within an operand");
}

/// Whether one channel has to be named for a term: it is coloured.
bool needs_channel(const Scope& scope, const std::string& quantity) {
  if (!scope.material || !plot::is_coloured(quantity)) return false;
  try {
    plot::Configuration configuration(*scope.material);
    for (const plot::Setting& setting : scope.at) configuration.set(setting);
    const plot::Configuration::Surface made = configuration.surface();
    return plot::channels_differ(made.description, made.material, quantity);
  } catch (const InputError&) {
    return false; // told where the term is read
  }
}

class SeriesReader {
public:
  explicit SeriesReader(const SeriesContext& context) : context_(context) {}

  std::vector<plot::SeriesDescription> read(const Json& panel, const std::string& pointer, const Scope& scope) {
    for (std::size_t k = 0; k < panel["series"].size(); ++k) {
      const std::string at = pointer + "/series/" + std::to_string(k);
      const Json& one = panel["series"][k];
      context_.levels.for_each(
          one, at, scope, [&](const Scope& inner, std::optional<double> ramp) { add_channels(one, at, inner, ramp); });
    }
    name_unlabelled();
    return std::move(series_);
  }

  Expression expression(const Json& object, const std::string& pointer, Scope scope, bool operand = false) {
    context_.levels.enter(scope, object, pointer);
    if (!operand) check_free(context_, scope);
    Expression out;
    const auto operands = [&](const std::string& key, Expression::Operation operation) {
      out.operation = operation;
      const std::string at = step(pointer, key);
      for (std::size_t k = 0; k < object[key].size(); ++k)
        out.operands.push_back(expression(object[key][k], step(at, std::to_string(k)), scope, true));
    };
    if (object.contains("ratio"))
      operands("ratio", Expression::Operation::ratio);
    else if (object.contains("difference"))
      operands("difference", Expression::Operation::difference);
    else if (object.contains("absolute")) {
      out.operation = Expression::Operation::absolute;
      out.operands.push_back(expression(object["absolute"], step(pointer, "absolute"), scope, true));
    } else {
      out.term = term(object, pointer, scope);
    }
    return out;
  }

private:
  plot::Term term(const Json& object, const std::string& pointer, const Scope& scope) {
    if (!scope.material) context_.file.fail(pointer, "\"material\" is missing here and above");
    plot::Term out{object["quantity"].get<std::string>(), *scope.material, scope.at, {}};
    if (object.contains("simulate")) {
      if (context_.kind == plot::Kind::heatmap)
        context_.file.fail(step(pointer, "simulate"), "a heat map is not simulated");
      out.simulate = read_simulate(object["simulate"]);
    }
    check_term(context_.file, out, pointer, scope, context_.swept, context_.tolerance);
    add_traits(current_, out, scope);
    return out;
  }

  /// Whether the series is coloured, and each of its channels is meant.
  bool has_channels(const Json& object, const std::string& pointer, Scope scope) const {
    if (!scope.each_channel && object.value("channel", "") != "rgb") return false;
    context_.levels.enter(scope, object, pointer);
    if (object.contains("quantity"))
      return scope.each_channel && needs_channel(scope, object["quantity"].get<std::string>());
    for (const char* key : {"ratio", "difference", "absolute"}) {
      if (!object.contains(key)) continue;
      const Json operands = object[key].is_array() ? object[key] : Json::array({object[key]});
      for (const Json& operand : operands)
        if (has_channels(operand, pointer, scope)) return true;
    }
    return false;
  }

  void add_channels(const Json& object, const std::string& pointer, const Scope& scope, std::optional<double> ramp) {
    if (!has_channels(object, pointer, scope)) return add(object, pointer, scope, ramp, looped_channel(object, scope));
    for (const char* channel : each_channel) {
      Scope one = scope;
      one.set({"channel", channel}, pointer + "/channel");
      one.words["channel"] = channel;
      add(object, pointer, one, std::nullopt, channel);
    }
  }

  /// The channel of a series whose own `for_each` runs over them.
  static std::string looped_channel(const Json& object, const Scope& scope) {
    const std::vector<Json> loops = loops_of(object);
    if (std::ranges::none_of(loops, [](const Json& loop) { return loop["variable"] == "channel"; })) return {};
    const auto last = std::ranges::find(scope.at.rbegin(), scope.at.rend(), "channel", &plot::Setting::variable);
    const auto* name = std::get_if<std::string>(&last->value);
    return name != nullptr ? *name : "";
  }

  void add(const Json& object, const std::string& pointer, const Scope& scope, std::optional<double> ramp,
           const std::string& channel) {
    current_.clear();
    Expression value = expression(object, pointer, scope);
    if (value.operation != Expression::Operation::term)
      current_.insert(current_.begin(), operation_trait(value.operation));
    traits_.push_back(current_);
    labelled_.push_back(object.contains("label"));
    plot::SeriesDescription& out = series_.emplace_back();
    out.label = worded(context_.file, object, pointer, "label", scope);
    out.value = std::move(value);
    out.ramp = ramp;
    const auto found = std::ranges::find(each_channel, channel);
    if (found == each_channel.end()) return;
    out.hue = static_cast<plot::Hue>(found - each_channel.begin());
    Scope any = scope;
    any.words["channel"] = "";
    out.family = worded(context_.file, object, pointer, "label", any);
    // A label that does not say of which channel it is would be that of three.
    if (labelled_.back() && out.family == out.label) out.label += (out.label.empty() ? "" : ", ") + channel;
  }

  void name_unlabelled() {
    if (series_.size() < 2) return;
    const std::vector<std::string> labels = labels_of(traits_), families = labels_of(traits_, "channel");
    for (std::size_t k = 0; k < series_.size(); ++k) {
      if (labelled_[k]) continue;
      series_[k].label = labels[k];
      if (series_[k].hue) series_[k].family = families[k];
    }
  }

  const SeriesContext& context_;
  Traits current_; ///< of the series being read
  std::vector<Traits> traits_;
  std::vector<bool> labelled_;
  std::vector<plot::SeriesDescription> series_;
};

} // namespace

std::vector<plot::SeriesDescription> read_series(const SeriesContext& context, const Json& panel,
                                                 const std::string& pointer, const Scope& scope) {
  return SeriesReader(context).read(panel, pointer, scope);
}

Expression read_expression(const SeriesContext& context, const Json& object, const std::string& pointer,
                           const Scope& scope) {
  return SeriesReader(context).expression(object, pointer, scope);
}

} // namespace brdfplot::config
