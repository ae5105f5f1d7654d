// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_VALIDATION_FILE_H
#define CAGEWRIGHT_HOST_VALIDATE_VALIDATION_FILE_H

#include <string>
#include <utility>
#include <vector>

#include "host/validate/validation.h"

namespace cagewright::host {

// What a run of `cagewright validate` found, and on what.
struct ValidationReport {
  std::string model, version;                                // the file; the program's version
  std::vector<std::pair<std::string, std::string>> options;  // what was asked for, as typed
  std::vector<Validation> cages;                             // one at least

  bool agrees() const;
};

// A picture for the page: a caption and the bytes of a PNG.
struct PagePicture {
  std::string caption;
  std::string png;
};

// As JSON; docs/file-formats.md has the keys. What is not a number is null.
std::string validation_json(const ValidationReport& report);

// As one HTML file that needs no other: pictures are data URIs, plots are SVG. pictures: of each cage; where there are
// none, `why_no_pictures` says so in a sentence.
std::string validation_page(const ValidationReport& report, const std::vector<std::vector<PagePicture>>& pictures,
                            const std::string& why_no_pictures);

// For stdout: a line for each claim that does not hold, and figures.
std::string validation_summary(const Validation& validation);

}  // namespace cagewright::host

#endif
