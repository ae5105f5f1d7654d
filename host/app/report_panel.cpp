// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/report_panel.h"

#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/app/convergence_plot.h"
#include "host/app/theme.h"

namespace cagewright::host {
namespace {

QString number(double value, int digits = 4) {
  return std::isfinite(value) ? QString::number(value, 'g', digits) : QString("-");
}
QString degrees(double radians) { return number(radians * 180 / std::numbers::pi, 3) + "&deg;"; }
QString row(const QString& name, const QString& value) {
  return QString("<tr><td>%1&nbsp;&nbsp;</td><td align='right' style='white-space: nowrap;'>%2</td></tr>")
      .arg(name, value);
}

QString measures_rows(const Measures& measures) {
  return row("Volume ratio", number(measures.volume_ratio)) + row("Mean gap / diagonal", number(measures.mean_gap)) +
         row("Largest gap / diagonal", number(measures.max_gap)) + row("Coverage", number(measures.coverage)) +
         row("Clearance / diagonal", number(measures.clearance, 3)) +
         row("Sections off square", degrees(measures.worst_squareness)) +
         row("Twist between sections", degrees(measures.worst_twist)) +
         row("Least, greatest dihedral",
             degrees(measures.least_dihedral) + ", " + degrees(measures.greatest_dihedral)) +
         row("Largest aspect", number(measures.greatest_aspect, 3));
}

QString timings_rows(const cgw_summary& summary, double total) {
  return row("Segment", number(summary.segment_ms, 3) + " ms") + row("Orient", number(summary.orient_ms, 3) + " ms") +
         row("Mesh", number(summary.meshing_ms, 3) + " ms") + row("Refine", number(summary.refine_ms, 3) + " ms") +
         row("Enclose", number(summary.enclose_ms, 3) + " ms") + row("Whole", number(total, 3) + " ms");
}

QString certificate_rows(const Certificate& certificate) {
  return row("Closed", certificate.closed ? "yes" : "no") +
         row("Self-intersections", QString::number(certificate.self_intersections.size())) +
         row("Model meets cage", QString::number(certificate.model_cage_intersections.size())) +
         row("Vertices outside", QString::number(certificate.vertices_outside.size()));
}

struct Verdict {
  QString text;
  Tone tone;
};

// A cage that was read knows no slides.
QString last_good_text(std::size_t slides_of_cage, std::size_t slides) {
  if (slides_of_cage == 0 || slides_of_cage == slides)
    return "The last good cage: the slides as they are now give none";
  return QString("The last good cage, of %1 slide%2: the %3 as they are now give none")
      .arg(slides_of_cage)
      .arg(slides_of_cage == 1 ? "" : "s")
      .arg(slides);
}

Verdict verdict_of(const CageState& cage, std::size_t slides, bool is_solving) {
  if (cage.cage.triangles.empty()) return {cage.failed ? "No cage: see the problems" : "No cage yet", Tone::unknown};
  if (cage.failed) return {last_good_text(cage.section_slides.size(), slides), Tone::doubtful};
  if (!cage.is_of_now || cage.is_of_editing || !cage.certificate)
    return {is_solving ? "Being made ..." : "Not certified yet", Tone::unknown};
  const auto lost = std::ranges::count(cage.sections_merged, true);
  if (cage.certificate->encloses && cage.certificate->keeps_distance && lost > 0)
    return {
        QString("Certified, but without the sections of %1 slide%2, see Problems").arg(lost).arg(lost == 1 ? "" : "s"),
        Tone::doubtful};
  if (cage.certificate->encloses && cage.certificate->keeps_distance)
    return {"Certified: it encloses the model", Tone::good};
  if (cage.certificate->encloses) return {"Encloses the model, but not at the distance asked for", Tone::doubtful};
  return {"Not certified: it does not enclose the model", Tone::bad};
}

}  // namespace

ReportPanel::ReportPanel(Editor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  setObjectName("report");
  auto* column = new QVBoxLayout(this);
  verdict_ = new QLabel(this);
  verdict_->setObjectName("verdict");
  verdict_->setWordWrap(true);
  figures_ = new QLabel(this);
  figures_->setObjectName("figures");
  figures_->setTextFormat(Qt::RichText);
  figures_->setWordWrap(true);  // as narrow as the panel is
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  plot_ = new ConvergencePlot(this);
  column->addWidget(verdict_);
  column->addWidget(plot_);
  column->addWidget(figures_);
  column->addStretch();
  editor_.listen_seldom([this](WorkspaceChange change) {
    if (change == WorkspaceChange::cage || change == WorkspaceChange::scene || change == WorkspaceChange::mesh)
      show_cage();
    if (change == WorkspaceChange::progress) show_verdict();
  });
  show_cage();
}

void ReportPanel::show_verdict() {
  const Workspace& workspace = editor_.workspace();
  const Verdict verdict = verdict_of(workspace.cage(), workspace.slides().size(), workspace.progress().is_solving);
  if (verdict_->text() != verdict.text) verdict_->setText(verdict.text);
  const QString style = QString("font-weight: bold; color: %1;").arg(colour_of(verdict.tone, palette()).name());
  if (verdict_->styleSheet() != style) verdict_->setStyleSheet(style);
}

// The theme's colours are others now.
void ReportPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_verdict();
}

void ReportPanel::show_cage() {
  show_verdict();
  const CageState& cage = editor_.workspace().cage();
  QString rows;
  if (!cage.cage.triangles.empty()) {
    rows = row("Cage triangles", QString::number(cage.cage.triangle_count())) +
           row("Cage vertices", QString::number(cage.cage.vertex_count())) +
           row("Refinement steps", QString::number(cage.summary.iterations));
    if (cage.certificate) rows += certificate_rows(*cage.certificate);
    if (cage.measures) rows += measures_rows(*cage.measures);
    rows += timings_rows(cage.summary, cage.milliseconds);
  }
  figures_->setText("<table width='100%'>" + rows + "</table>");
  plot_->show(cage.max_signed_distances);
}

}  // namespace cagewright::host
