// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_TEXT_SCANNER_H
#define CAGEWRIGHT_HOST_FILE_TEXT_SCANNER_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace cagewright::host {

struct TextRules {
  char comment = '\0';       // from here to the line's end is nothing; '\0': no comments
  char continuation = '\0';  // as a line's last character joins the next line to it; '\0': no continuation
};

// Words and numbers of a text file, line by line; ends of line are \n, \r\n or \r. Numbers do not depend on the locale.
// `text` and `path` are borrowed for the life of the scanner. Every failure is a FileError with the line.
class TextScanner {
 public:
  TextScanner(std::string_view text, const std::filesystem::path& path, TextRules rules);

  std::size_t line() const { return line_; }  // of the last word, from 1

  // Goes to the next line that holds a word; false at the end of the text. Skips what is left of the current line.
  bool next_line();
  // The next word on this line; "" at its end.
  std::string_view word_on_line();
  // The next word on this or a later line; fails at the end of the text: "ends where WHAT should be".
  std::string_view word(std::string_view what);
  // Whether the line has a further word.
  bool more_on_line();
  void skip_line();
  // True where nothing but blanks and comments is left. Does not move past a word.
  bool at_end();

  // Whether `word` is a number; sets it. Numbers too large for a double are infinite, too small ones 0.
  static bool parse(std::string_view word, double& number);

  // `word` as a number; `what` names it in the sentence. Fails where it is no number.
  double to_number(std::string_view word, std::string_view what) const;
  // The same, and fails where it is NaN or infinite.
  double to_coordinate(std::string_view word, std::string_view what) const;
  std::int64_t to_integer(std::string_view word, std::string_view what) const;

  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void skip_blanks();
  bool at_line_end() const;
  void pass_line_end();

  const char* at_;
  const char* end_;
  const std::filesystem::path& path_;
  TextRules rules_;
  std::size_t line_ = 1;
  bool started_ = false;
};

}  // namespace cagewright::host

#endif
