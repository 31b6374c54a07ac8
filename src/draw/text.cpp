#include "draw/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "draw/number_text.hpp"

namespace brdfplot::plot {

namespace {

constexpr double script_scale = 0.75;

bool is_alnum(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The length in bytes of the UTF-8 character at `at`; a stray byte counts as one.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  const std::size_t length = byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
  return std::min(length, text.size() - at);
}

/// Whether the `_` at `at` is part of an identifier such as `v_cavity` rather than markup: one character alone is a
/// subscript without braces.
bool joins_identifier(std::string_view label, std::size_t at) {
  if (label[at] != '_' || label[at + 1] == '{') return false;
  if (is_digit(label[at - 1])) return true;
  const bool word_before = is_alnum(label[at - 1]);
  const bool word_after = at + 2 < label.size() && is_alnum(label[at + 1]) && is_alnum(label[at + 2]);
  return word_before && word_after;
}

bool starts_script(std::string_view label, std::size_t at) {
  if (label[at] != '_' && label[at] != '^') return false;
  if (at == 0 || label[at - 1] == ' ' || at + 1 >= label.size() || label[at + 1] == ' ') return false;
  return !joins_identifier(label, at);
}

bool is_escape(std::string_view label, std::size_t at) {
  return label[at] == '\\' && at + 1 < label.size() && (label[at + 1] == '_' || label[at + 1] == '^');
}

/// Where the group that opens at `open` closes, or npos.
std::size_t closing_brace(std::string_view label, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < label.size(); ++i) {
    if (label[i] == '{') ++depth;
    if (label[i] == '}' && --depth == 0) return i;
  }
  return std::string_view::npos;
}

void add(std::vector<Run>& runs, std::string_view text, Run::Level level) {
  if (text.empty()) return;
  if (!runs.empty() && runs.back().level == level) {
    runs.back().text += text;
  } else {
    runs.push_back({std::string(text), level});
  }
}

struct Script {
  std::string_view text;
  std::size_t end; ///< the first byte after the script
};

/// What the `_` or `^` at `at` lowers or raises.
Script script_at(std::string_view label, std::size_t at) {
  if (label[at + 1] == '{') {
    const auto close = closing_brace(label, at + 1);
    if (close != std::string_view::npos) return {label.substr(at + 2, close - at - 2), close + 1};
  }
  const auto length = character_length(label, at + 1);
  return {label.substr(at + 1, length), at + 1 + length};
}

/// Advance widths of DejaVu Sans for U+0020 to U+007E, in thousandths of the font size.
constexpr std::array<short, 95> ascii_width = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};

/// The same for U+0391 to U+03C9, Α to ω.
constexpr std::array<short, 57> greek_width = {
    684, 686, 557, 684, 632, 685, 752, 787, 295, 656, 684, 863, 748, 632, 787, 752, 603, 632, 632,
    611, 611, 787, 685, 787, 764, 295, 611, 659, 541, 634, 338, 579, 659, 638, 592, 612, 541, 544,
    634, 612, 338, 589, 592, 636, 559, 558, 612, 602, 635, 587, 634, 602, 579, 660, 578, 660, 837};

/// The width of a character outside ASCII: Greek, or by its block: combining marks, accented Latin, symbols.
double wide_character_width(std::string_view character) {
  if (character == "°") return 0.5;
  if (character == "·") return 0.318;
  if (character == "−") return 0.838;
  constexpr unsigned alpha = 0x391;
  if (character.size() == 2) {
    const auto first = static_cast<unsigned char>(character[0]), second = static_cast<unsigned char>(character[1]);
    const unsigned code = (first & 0x1FU) << 6U | (second & 0x3FU);
    if (code >= alpha && code < alpha + greek_width.size()) return greek_width[code - alpha] / 1000.0;
  }
  const auto lead = static_cast<unsigned char>(character[0]);
  const auto next = static_cast<unsigned char>(character.size() > 1 ? character[1] : 0);
  if (lead == 0xCC || (lead == 0xCD && next < 0xB0)) return 0;
  if (lead < 0xE0) return 0.72;
  return lead < 0xF0 ? 0.87 : 1.0;
}

/// The length of the valid UTF-8 character at `at` that XML allows; 0 when there is none.
std::size_t valid_length(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return lead >= 0x20 || lead == '\n' || lead == '\t' || lead == '\r' ? 1 : 0;
  const std::size_t length = lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (length == 0 || at + length > text.size()) return 0;
  unsigned code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[at + i]);
    if ((byte & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte & 0x3FU);
  }
  const bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool forbidden = (code >= 0xD800 && code < 0xE000) || code == 0xFFFE || code == 0xFFFF || code > 0x10FFFF;
  return too_long || forbidden ? 0 : length;
}

double plain_width(std::string_view text) {
  double width = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto length = character_length(text, i);
    const auto c = static_cast<unsigned char>(text[i]);
    if (c >= 0x80) {
      width += wide_character_width(text.substr(i, length));
    } else if (c >= 0x20 && c < 0x7F) {
      width += ascii_width[c - 0x20U] / 1000.0;
    }
    i += length;
  }
  return width;
}

} // namespace

std::vector<Run> parse_markup(std::string_view label) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < label.size();) {
    if (is_escape(label, i)) {
      add(runs, label.substr(i + 1, 1), Run::Level::base);
      i += 2;
    } else if (starts_script(label, i)) {
      const auto script = script_at(label, i);
      add(runs, script.text, label[i] == '_' ? Run::Level::sub : Run::Level::super);
      i = script.end;
    } else {
      const auto length = character_length(label, i);
      add(runs, label.substr(i, length), Run::Level::base);
      i += length;
    }
  }
  return runs;
}

std::string strip_markup(std::string_view label) {
  std::string out;
  out.reserve(label.size());
  for (const auto& run : parse_markup(label)) {
    if (run.level == Run::Level::sub) out += '_';
    if (run.level == Run::Level::super) out += '^';
    out += run.text;
  }
  return out;
}

std::string literal_label(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '_' || c == '^') out += '\\';
    out += c;
  }
  return out;
}

void append_escaped(std::string& out, std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto length = valid_length(text, i);
    switch (text[i]) {
    case '&': out += "&amp;"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '"': out += "&quot;"; break;
    case '\'': out += "&#39;"; break;
    default: out += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
}

void append_tspans(std::string& out, std::string_view label, double size) {
  double at = 0; // how far the current run stands below the baseline
  for (const auto& run : parse_markup(label)) {
    const double target = run.level == Run::Level::base ? 0 : (run.level == Run::Level::sub ? 0.24 : -0.36) * size;
    const bool plain = target == 0 && at == 0;
    if (!plain) {
      out += "<tspan dy=\"";
      append_fixed(out, target - at);
      if (target != 0) {
        out += "\" font-size=\"";
        append_fixed(out, script_scale * size);
      }
      out += "\">";
    }
    append_escaped(out, run.text);
    if (!plain) out += "</tspan>";
    at = target;
  }
}

void append_html(std::string& out, std::string_view label) {
  for (const auto& run : parse_markup(label)) {
    const std::string_view tag = run.level == Run::Level::sub ? "sub" : "sup";
    if (run.level != Run::Level::base) out.append("<").append(tag).append(">");
    append_escaped(out, run.text);
    if (run.level != Run::Level::base) out.append("</").append(tag).append(">");
  }
}

double text_width(std::string_view label, double size, bool bold) {
  double width = 0;
  for (const auto& run : parse_markup(label)) {
    width += plain_width(run.text) * (run.level == Run::Level::base ? 1 : script_scale);
  }
  return width * size * (bold ? 1.12 : 1);
}

} // namespace brdfplot::plot
