/// \file
/// Problems, each a number to compute from some inputs, and the methods that compute it. `brdfplot pareto` charts what
/// they cost against how well they do, `brdfplot stress` looks for where they fail.
#pragma once

#include "choice/methods/counted.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace brdfplot::choice {

/// An exact value as the sum of two doubles, of which the second is below half an ulp of the first: some 32 digits.
struct Exact {
  double high = 0, low = 0;
};

/// How an input is spread over its range, in charts and searches.
enum class Scale { linear, logarithmic };

struct Input {
  std::string name; ///< "a", "cos_theta", "alpha", ...
  std::string doc;
  double low = 0, high = 1; ///< the whole domain, both ends included
  Scale scale = Scale::linear;
  /// Where it mostly is, which is where times are taken; none: all of the domain.
  std::optional<std::array<double, 2>> usual{};
};

/// A method over arrays: inputs[k][i] is input k of row i.
template <class T>
using Run = std::function<void(std::size_t n, const T* const* inputs, T* out)>;

/// What kind of method it is.
enum class Kind {
  kernel,        ///< what this program computes with
  printed,       ///< the formula as its source prints it
  rewritten,     ///< the same function in a form that keeps its digits
  approximation, ///< another function in its place, as published
  fit,           ///< a rational made by `brdfplot fit`
  table,
  quadrature,
};

struct Method {
  std::string name; ///< unique within its problem: "printed", "walter_2007", "kernel_avx2"
  std::string doc;
  std::string source; ///< author, year, equation
  Kind kind = Kind::printed;
  std::variant<Run<double>, Run<float>>
      run;                                ///< for float, the inputs are rounded to float before they are anything else
  std::optional<Operations> operations{}; ///< the most of any input that was counted; none where it cannot be counted
  std::size_t bytes = 0;                  ///< of tables
  double bound = 0;                       ///< the relative error that it states over the whole domain; 0: none
  /// The absolute error that it states of its value at a row of inputs, as a quadrature does that judges itself. Empty:
  /// none.
  std::function<double(std::span<const double> input)> stated_error{};
  double evaluations = 0; ///< of an integrand, the most that were seen: a quadrature's cost; 0: none
  std::string note{};     ///< what else was found: whether its own estimate of its error holds
  bool portable = true;   ///< the same on every machine; not so a kernel of an instruction set that some have

  bool is_single() const { return std::holds_alternative<Run<float>>(run); }
};

struct Problem {
  std::string name; ///< "lambda_ggx"
  std::string doc;
  std::string source;
  std::vector<Input> inputs;
  std::function<Exact(std::span<const double> input)> exact{}; ///< empty, of a formula of the user's: not known
  std::vector<Method> methods{};

  // What is true of the exact function.
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  std::vector<int> monotone{}; ///< for each input: 1 grows with it, -1 falls, 0 neither; empty: neither in all
  /// What of a value is seen, where its relative error is not what matters: G1 = 1 / (1 + Lambda) of a Lambda. Empty:
  /// the value itself.
  std::function<double(double)> seen{};
  std::string seen_as{}; ///< its name: "G1"
  bool albedo = false;   ///< a share of the light: more than 1 is energy out of nothing
  bool smooth = false;   ///< where there are no exact values: digits are told by how far values are off a smooth curve
  bool reciprocal = false; ///< the same where the first half of the inputs and the second change places

  std::string cost_unit{}; ///< of costs where they are no operations: "evaluations of the integrand"

  // How exact values are asked for.
  double exact_error = 0;     ///< a bound of the relative error of `exact`, where it is not that of 32 digits
  std::size_t samples = 4096; ///< how many may be asked for within a second
};

/// A method in double or float, and its operations, of one formula for any number type: `formula(x)` with x an array of
/// as many numbers as there are inputs. Operations are counted at each of `examples`, rows of inputs, one in each
/// branch.
template <class T, std::size_t inputs, class F>
Method method_of(std::string name, std::string doc, std::string source, Kind kind, F formula,
                 const std::vector<std::array<double, inputs>>& examples) {
  Method method{.name = std::move(name),
                .doc = std::move(doc),
                .source = std::move(source),
                .kind = kind,
                .run = {},
                .operations = {}};
  method.run = Run<T>([formula](std::size_t n, const T* const* in, T* out) {
    std::array<T, inputs> x{};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < inputs; ++k) x[k] = in[k][i];
      out[i] = formula(x);
    }
  });
  for (const auto& example : examples) {
    std::array<Counted, inputs> x;
    for (std::size_t k = 0; k < inputs; ++k) x[k] = Counted(example[k]);
    const Operations operations = counted([&] { return formula(x); });
    if (!method.operations || cost(operations) > cost(*method.operations)) method.operations = operations;
  }
  return method;
}

/// All problems that need no material, each in a file of its own.
std::vector<Problem> problems();

} // namespace brdfplot::choice
