// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/text_scanner.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

// What std::from_chars could not represent is either far too large or far too small.
bool is_tiny(std::string_view number) {
  return number.find("e-") != number.npos || number.find("E-") != number.npos || number.starts_with("0.") ||
         number.starts_with("-0.") || number.starts_with(".");
}

}  // namespace

TextScanner::TextScanner(std::string_view text, const std::filesystem::path& path, TextRules rules)
    : at_(text.data()), end_(text.data() + text.size()), path_(path), rules_(rules) {
  if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
}

bool TextScanner::at_line_end() const { return at_ == end_ || is_line_end(*at_); }

void TextScanner::pass_line_end() {
  if (at_ == end_) return;
  if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
  ++at_;
  ++line_;
}

void TextScanner::skip_blanks() {
  while (at_ != end_) {
    if (is_blank(*at_)) {
      ++at_;
    } else if (rules_.comment != '\0' && *at_ == rules_.comment) {
      while (!at_line_end()) ++at_;
    } else if (rules_.continuation != '\0' && *at_ == rules_.continuation && at_ + 1 != end_ && is_line_end(at_[1])) {
      ++at_;
      pass_line_end();
    } else {
      return;
    }
  }
}

bool TextScanner::next_line() {
  if (started_) {
    skip_line();
    pass_line_end();
  }
  started_ = true;
  return !at_end();
}

bool TextScanner::at_end() {
  skip_blanks();
  while (at_ != end_ && is_line_end(*at_)) {
    pass_line_end();
    skip_blanks();
  }
  return at_ == end_;
}

bool TextScanner::more_on_line() {
  skip_blanks();
  return !at_line_end();
}

void TextScanner::skip_line() {
  while (more_on_line()) word_on_line();
}

std::string_view TextScanner::word_on_line() {
  skip_blanks();
  const char* begin = at_;
  while (at_ != end_ && !is_blank(*at_) && !is_line_end(*at_)) {
    if (rules_.comment != '\0' && *at_ == rules_.comment) break;
    if (rules_.continuation != '\0' && *at_ == rules_.continuation && at_ + 1 != end_ && is_line_end(at_[1])) break;
    ++at_;
  }
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextScanner::word(std::string_view what) {
  if (at_end()) fail("the file ends where " + std::string(what) + " should be");
  return word_on_line();
}

bool TextScanner::parse(std::string_view word, double& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, number);
  if (word.empty() || end != last) return false;
  if (error == std::errc::result_out_of_range) {
    number = is_tiny(word) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return error == std::errc() || error == std::errc::result_out_of_range;
}

double TextScanner::to_number(std::string_view word, std::string_view what) const {
  double value = 0;
  if (parse(word, value)) return value;
  if (word.empty()) fail("the line ends where " + std::string(what) + " should be");
  fail(std::string(what) + " should be a number, not " + in_quotes(word));
}

double TextScanner::to_coordinate(std::string_view word, std::string_view what) const {
  const double value = to_number(word, what);
  if (!std::isfinite(value)) fail(std::string(what) + " is not finite: " + in_quotes(word));
  return value;
}

std::int64_t TextScanner::to_integer(std::string_view word, std::string_view what) const {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc() && end == digits.data() + digits.size()) return value;
  if (word.empty()) fail("the line ends where " + std::string(what) + " should be");
  fail(std::string(what) + " should be a whole number, not " + in_quotes(word));
}

void TextScanner::fail(const std::string& reason) const { throw FileError(path_, Line{line_, 0}, reason); }

}  // namespace cagewright::host
