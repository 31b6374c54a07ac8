#include <algorithm>

#include "draw/text.hpp"

namespace brdfplot::plot {

namespace {

/// The words of a label; a blank inside braces does not separate.
std::vector<std::string> words_of(std::string_view label) {
  std::vector<std::string> words(1);
  int depth = 0;
  for (const char c : label) {
    if (c == '{') ++depth;
    if (c == '}') --depth;
    if ((c == ' ' || c == '\n') && depth <= 0) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  std::erase(words, std::string());
  return words;
}

/// Cuts a word that is wider than a line between characters; a word with markup stays whole.
std::vector<std::string> cut_word(const std::string& word, double size, double width, bool bold) {
  if (text_width(word, size, bold) <= width || word.find_first_of("{}^_") != std::string::npos) return {word};
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < word.size();) {
    std::size_t end = i + 1;
    while (end < word.size() && (static_cast<unsigned char>(word[end]) & 0xC0U) == 0x80U) ++end;
    const auto character = word.substr(i, end - i);
    if (!pieces.back().empty() && text_width(pieces.back() + character, size, bold) > width) pieces.emplace_back();
    pieces.back() += character;
    i = end;
  }
  return pieces;
}

std::vector<std::string> wrap(std::string_view label, double size, double width, bool bold) {
  std::vector<std::string> lines;
  for (const auto& word : words_of(label)) {
    for (const auto& piece : cut_word(word, size, width, bold)) {
      if (!lines.empty() && text_width(lines.back() + " " + piece, size, bold) <= width) {
        lines.back() += " " + piece;
      } else {
        lines.push_back(piece);
      }
    }
  }
  return lines;
}

} // namespace

double FittedText::width() const {
  double widest = 0;
  for (const auto& line : lines) widest = std::max(widest, text_width(line, size, bold));
  return widest;
}

FittedText fit_text(std::string_view label, double size, double width, std::size_t max_lines, bool bold) {
  constexpr double step = 0.5;
  FittedText fitted{wrap(label, size, width, bold), size, bold};
  while ((fitted.lines.size() > max_lines || fitted.width() > width) && fitted.size - step >= smallest_font) {
    fitted.size -= step;
    fitted.lines = wrap(label, fitted.size, width, bold);
  }
  return fitted;
}

} // namespace brdfplot::plot
