// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/picture_arguments.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "host/cli/input_error.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

// Takes a number off the front of `text`.
template <class Number>
bool take(std::string_view& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool take(std::string_view& text, char expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(1);
  return true;
}

std::array<double, 3> to_direction(const char* option, const std::string& typed) {
  std::string_view text = typed;
  std::array<double, 3> direction{};
  const bool is_read = take(text, direction[0]) && take(text, ',') && take(text, direction[1]) && take(text, ',') &&
                       take(text, direction[2]) && text.empty();
  if (!is_read) {
    throw UsageError(std::string(option) + ": needs three numbers X,Y,Z without spaces, not " + in_quotes(typed));
  }
  for (const double x : direction) {
    if (!std::isfinite(x)) throw UsageError(option + (" " + typed) + ": its numbers have to be finite");
  }
  if (direction == std::array<double, 3>{}) throw UsageError(option + (" " + typed) + ": gives no direction");
  return direction;
}

View to_view(const PictureArguments& arguments) {
  View view;
  if (arguments.up) view = default_view(to_direction("--picture-up", *arguments.up));
  if (arguments.from) view.toward_viewer = to_direction("--picture-from", *arguments.from);
  if (is_sound(view)) return view;
  // The default view is sound, so a direction was given.
  throw UsageError("--picture-from " + *arguments.from + ": is parallel to what is up, " +
                   (arguments.up ? "--picture-up " + *arguments.up : "0,1,0 without a --picture-up"));
}

void read_size(const std::string& typed, PictureOptions& options) {
  std::string_view text = typed;
  if (!take(text, options.width) || !take(text, 'x') || !take(text, options.height) || !text.empty()) {
    throw UsageError("--picture-size: needs two whole numbers WxH, as 1280x800, not " + in_quotes(typed));
  }
  for (const int size : {options.width, options.height}) {
    if (size >= smallest_picture && size <= largest_picture) continue;
    throw UsageError("--picture-size " + typed + ": either has to be from " + std::to_string(smallest_picture) +
                     " to " + std::to_string(largest_picture));
  }
}

}  // namespace

PictureOptions to_options(const PictureArguments& arguments) {
  PictureOptions options;
  options.views = {to_view(arguments)};
  if (arguments.size) read_size(*arguments.size, options);
  return options;
}

}  // namespace cagewright::host
