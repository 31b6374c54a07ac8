#include "base/echo.hpp"

#include <doctest/doctest.h>

using brdfplot::echo;

TEST_CASE("what errors repeat of a text") {
  CHECK(echo("").empty());
  CHECK(echo("abc") == "abc");
  CHECK(echo(std::string(60, 'a')) == std::string(60, 'a'));
  CHECK(echo(std::string(61, 'a')) == std::string(60, 'a') + "… (61 bytes)");
  CHECK(echo("abcd", 3) == "abc… (4 bytes)");
  CHECK(echo("a\nb\x1b[31m\x7f\r") == "a\\nb\\u001b[31m\\u007f\\u000d");
}

TEST_CASE("characters are not cut") {
  CHECK(echo("αβγδ", 3) == "αβγ… (8 bytes)");
  CHECK(echo("αβγδ", 4) == "αβγδ");
  CHECK(echo("a😀b", 2) == "a😀… (6 bytes)");
  // No UTF-8: bytes that only continue belong to what is before them, up to four.
  CHECK(echo(std::string(100, '\x80'), 1) == std::string(4, '\x80') + "… (100 bytes)");
}
