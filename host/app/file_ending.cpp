// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/file_ending.h"

#include <QFileInfo>
#include <QRegularExpression>

namespace cagewright::host {

QString with_ending_of(const QString& filter, const QString& file) {
  if (!QFileInfo(file).suffix().isEmpty()) return file;
  static const QRegularExpression first(R"(\(\*(\.\w+))");
  const QString ending = first.match(filter).captured(1);
  return (file.endsWith('.') ? file.chopped(1) : file) + ending;
}

}  // namespace cagewright::host
