// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_CONVERGENCE_PLOT_H
#define CAGEWRIGHT_HOST_APP_CONVERGENCE_PLOT_H

#include <QWidget>
#include <vector>

namespace cagewright::host {

// The paper's figure 11: the largest signed distance of equation (6), over the diagonal, of each refinement step; its
// size on a logarithmic scale, with the bound of equation (9).
class ConvergencePlot : public QWidget {
 public:
  explicit ConvergencePlot(QWidget* parent);

  void show(std::vector<double> distances);

 protected:
  void paintEvent(QPaintEvent* event) override;
  QSize sizeHint() const override { return {280, 170}; }

 private:
  std::vector<double> distances_;
};

}  // namespace cagewright::host

#endif
