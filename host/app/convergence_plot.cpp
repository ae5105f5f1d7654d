// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/convergence_plot.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace cagewright::host {
namespace {

constexpr double bound = 1e-3;                   // equation (9)
constexpr int first_power = -5, last_power = 0;  // of ten, where the scale ends

double share_of(double distance) {
  const double power = std::log10(std::max(std::abs(distance), std::pow(10, first_power)));
  return std::clamp((power - first_power) / (last_power - first_power), 0.0, 1.0);
}

}  // namespace

ConvergencePlot::ConvergencePlot(QWidget* parent) : QWidget(parent) {
  setObjectName("convergence");
  setMinimumHeight(140);
  setAccessibleName("Convergence of the refinement");
  setToolTip(
      "The refinement's largest signed distance, over the diagonal, by steps (equation 6); dashed: the bound of "
      "equation 9.");
}

void ConvergencePlot::show(std::vector<double> distances) {
  distances_ = std::move(distances);
  update();
}

void ConvergencePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  const QFontMetrics metrics = fontMetrics();
  const QRectF area = QRectF(rect()).adjusted(metrics.horizontalAdvance("1e-5 "), metrics.height() / 2.0 + 2, -10,
                                              -metrics.height() - 4);
  const auto y_of = [&](double share) { return area.bottom() - share * area.height(); };
  QColor faint = palette().text().color();
  faint.setAlpha(50);
  for (int power = first_power; power <= last_power; ++power) {
    const double y = y_of(static_cast<double>(power - first_power) / (last_power - first_power));
    painter.setPen(faint);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(palette().text().color());
    painter.drawText(QRectF(0, y - metrics.height() / 2.0, area.left() - 4, metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, QString("1e%1").arg(power));
  }
  painter.setPen(QPen(QColor(0x5f, 0xbf, 0x77), 1.5, Qt::DashLine));
  painter.drawLine(QPointF(area.left(), y_of(share_of(bound))), QPointF(area.right(), y_of(share_of(bound))));
  painter.setPen(palette().text().color());
  painter.drawText(QRectF(area.left(), area.bottom() + 2, area.width(), metrics.height()), Qt::AlignCenter,
                   distances_.empty() ? "no refinement yet" : QString("step 0 to %1").arg(distances_.size() - 1));
  QPainterPath path;
  for (std::size_t i = 0; i < distances_.size(); ++i) {
    const double share =
        distances_.size() > 1 ? static_cast<double>(i) / static_cast<double>(distances_.size() - 1) : 0.5;
    const QPointF at(area.left() + share * area.width(), y_of(share_of(distances_[i])));
    i == 0 ? path.moveTo(at) : path.lineTo(at);
    painter.setBrush(QColor(0xf0, 0xa0, 0x40));
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(at, 2.5, 2.5);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0xf0, 0xa0, 0x40), 1.5));
  painter.drawPath(path);
}

}  // namespace cagewright::host
