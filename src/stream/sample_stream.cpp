#include "stream/sample_stream.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "sampling/weights.hpp"
#include "stream/columns.hpp"
#include "stream/rows.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

namespace brdfplot {

namespace {

/// Samples are drawn by so many, and so much text is read at once.
constexpr std::size_t piece_size = 2048;
constexpr std::size_t sample_block_size = std::size_t{16} << 10;
/// Pieces in memory, for each thread: enough that all end at about the same time.
constexpr std::size_t pieces_a_thread = 8;

/// A viewer, and the row that it stands in.
struct Viewpoint {
  Direction omega_o{0, 0, 1};
  std::string row;
  std::size_t line = 0;
};

/// Some of the samples of a row.
struct Piece {
  Viewpoint viewer;
  std::uint64_t first = 0;
  std::size_t n = 0;
};

class Drawing {
public:
  Drawing(const Material& material, const Sampler& sampler, const SampleOptions& options, OutputFile& out,
          std::string file)
      : material_(material), sampler_(sampler), options_(options), out_(out), file_(std::move(file)) {}

  void add(const Viewpoint& viewer) {
    for (std::uint64_t first = 0; first < options_.samples; first += piece_size) {
      pieces_.push_back(
          {viewer, first, static_cast<std::size_t>(std::min<std::uint64_t>(piece_size, options_.samples - first))});
      waiting_ += pieces_.back().n;
      // One row of few samples is a piece too, and many of them are as much work as one of many.
      if (waiting_ >= piece_size * pieces_a_thread * static_cast<std::size_t>(options_.threads)) flush();
    }
  }

  void flush() {
    std::vector<std::string> texts(pieces_.size());
    std::vector<std::exception_ptr> failures(pieces_.size());
    parallel_for(pieces_.size(), options_.threads, [&](std::size_t k) {
      try {
        write(pieces_[k], texts[k]);
      } catch (...) {
        failures[k] = std::current_exception();
      }
    });
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      out_.write(texts[k]);
      if (failures[k]) std::rethrow_exception(failures[k]);
    }
    pieces_.clear();
    waiting_ = 0;
  }

private:
  void write(const Piece& piece, std::string& text) const {
    const std::string where = file_ + ":" + std::to_string(piece.viewer.line);
    const Direction& o = piece.viewer.omega_o;
    const auto channels = static_cast<std::size_t>(material_.channels());
    WeightedSamples drawn;
    try {
      draw(material_, sampler_, o, points(options_.points, options_.seed, piece.viewer.line, piece.first, piece.n),
           drawn);
    } catch (const AccuracyError& error) {
      throw AccuracyError(where, error.what());
    }
    for (std::size_t k = 0; k < piece.n; ++k) {
      text += piece.viewer.row;
      for (const double value : {drawn.lights.x[k], drawn.lights.y[k], drawn.lights.z[k], drawn.pdf[k]})
        append(text, value);
      for (std::size_t c = 0; c < channels; ++c)
        append(text, weight(drawn.weights[c * piece.n + k], drawn.pdf[k], where));
      text += '\n';
    }
  }

  static void append(std::string& text, double value) {
    text += ',';
    append_number(text, value);
  }

  static double weight(double value, double pdf, const std::string& where) {
    if (!std::isfinite(value) || !std::isfinite(pdf))
      throw AccuracyError(where, "found a weight of " + format_number(value) + " at a density of " +
                                     format_number(pdf) + ", accepted: a finite number");
    return value;
  }

  const Material& material_;
  const Sampler& sampler_;
  const SampleOptions& options_;
  OutputFile& out_;
  std::string file_;
  std::vector<Piece> pieces_;
  std::size_t waiting_ = 0;
};

std::string output_header(const std::string& header, const DirectionColumns& columns, int channels,
                          const std::string& where) {
  std::string out = header;
  std::vector<std::string> names{"x_i", "y_i", "z_i", "pdf"};
  if (channels == 1)
    names.emplace_back("weight");
  else
    names.insert(names.end(), {"weight_r", "weight_g", "weight_b"});
  for (const std::string& name : names) {
    if (std::ranges::find(columns.names(), name) != columns.names().end())
      throw InputError(where, "column \"" + name + "\" is there already; the output would have it twice");
    out += "," + name;
  }
  return out + "\n";
}

/// Adds the rows of the block, up to the first that is wrong.
void add_rows(const RowBlock& block, const DirectionColumns& columns, const std::string& file, Drawing& drawing) {
  for (FieldScanner scanner(block.text); !scanner.at_end();) {
    const std::size_t start = scanner.position();
    const std::size_t line = block.first_line + scanner.lines();
    std::array<Direction, letter_count> directions{};
    const auto problem = columns.read_row(scanner, directions);
    std::string_view row = std::string_view(block.text).substr(start, scanner.position() - start);
    if (row.front() <= ' ' && is_blank(row)) continue;
    if (problem) {
      drawing.flush();
      throw InputError(file + ":" + std::to_string(line), *problem);
    }
    row.remove_suffix(row.ends_with("\r\n") ? 2 : 1);
    drawing.add({directions[static_cast<std::size_t>(Letter::o)], std::string(row), line});
  }
}

} // namespace

void sample_stream(const Material& material, const Sampler& sampler, const SampleOptions& options, InputFile& in,
                   OutputFile& out) {
  FileRows rows(in);
  RowReader reader(rows, sample_block_size);
  const std::string header = reader.header();
  const std::string where = in.name() + ":" + std::to_string(reader.header_line());
  if (header.empty())
    throw InputError(where, "found no header; accepted: a line that names the columns, such as theta_o,phi_o");
  const DirectionColumns columns(header, where);
  if (columns.has(Letter::i))
    throw InputError(where, "found columns of omega_i, which are what is drawn; accepted: columns of omega_o, and any "
                            "that are no directions");
  if (!columns.has(Letter::o)) throw InputError(where, "found no omega_o; accepted: theta_o [phi_o] or x_o y_o z_o");
  out.write(output_header(header, columns, material.channels(), where));
  Drawing drawing(material, sampler, options, out, in.name());
  for (RowBlock block; reader.next(block);) {
    throw_if_interrupted();
    add_rows(block, columns, in.name(), drawing);
    drawing.flush();
  }
}

} // namespace brdfplot
