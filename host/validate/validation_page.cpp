// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host/scene/base64.h"
#include "host/validate/validation_file.h"

namespace cagewright::host {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string percent(double share) { return text_of(100 * share) + "&nbsp;%"; }

std::string row(const std::string& name, const std::string& value) {
  return "<tr><th>" + name + "</th><td>" + value + "</td></tr>\n";
}

std::string checks_table(const Validation& v) {
  std::string html =
      "<table><tr><th>Stage</th><th>Claim</th><th>Worst</th><th>Tolerance</th><th>Comparisons</th></tr>\n";
  for (const Check& c : v.checks) {
    html += std::string("<tr class=\"") + (c.holds() ? "holds" : "fault") + "\"><td>" + escaped(c.stage) + "</td><td>" +
            escaped(c.claim) + (c.holds() ? "" : "<p><b>" + escaped(c.fault) + "</b></p>") + "</td><td>" +
            text_of(c.worst) + "</td><td>" + text_of(c.tolerance) + " " + escaped(c.unit) + "</td><td>" +
            std::to_string(c.count) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

std::string orientation_table(const OrientationFigures& o) {
  return "<table>\n" + row("Equation (1) at the plug-in's sections", text_of(o.plugin)) +
         row("at the linear solution, each x taken to length 1", text_of(o.linear)) +
         row("at the minimum next to the plug-in's sections", text_of(o.from_plugin)) +
         row("at the best of " + std::to_string(o.starts) + " random starts",
             text_of(o.best) + ", reached from " + std::to_string(o.reached)) +
         row("Sections above the best", percent(o.plugin_off)) +
         row("Linear solution above the best", percent(o.linear_off)) + "</table>\n";
}

std::string tighter_cells(const TighterCage& t) {
  return "<td>" + text_of(t.volume_ratio) + "</td><td>" + percent(t.gap) + "</td><td>" + std::to_string(t.rounds) +
         "</td><td>" + std::to_string(t.certified) + "</td><td>" + text_of(t.seconds) + "</td><td>" +
         (t.settled ? "nothing more to gain" : "the clock") + "</td></tr>\n";
}

std::string optimality_table(const Validation& v) {
  if (!v.optimality) {
    return v.certified ? "<p>Not asked for.</p>\n"
                       : "<p>None: the plug-in's cage, whose limbs are not merged here (<code>enclose.merge</code>), "
                         "is not certified.</p>\n";
  }
  return "<p>The plug-in's cage has the volume ratio " + text_of(v.optimality->volume_ratio) +
         ". With the same triangles the slow optimiser reached, certified by the plug-in:</p>\n"
         "<table><tr><th></th><th>Volume ratio</th><th>Gap</th><th>Rounds</th><th>Certified</th><th>Seconds</th>"
         "<th>Ended by</th></tr>\n<tr><th>Sections in plane and in shape, as the plug-in's</th>" +
         tighter_cells(v.optimality->shaped) + "<tr><th>Sections free</th>" + tighter_cells(v.optimality->free) +
         "</table>\n";
}

// Figure 11: the largest signed distance over the diagonal, by iteration.
std::string convergence_plot(const std::vector<double>& distances) {
  constexpr double width = 480, height = 200, left = 60, bottom = 30, top = 10;
  const double most = std::max(1e-6, *std::max_element(distances.begin(), distances.end()));
  const double steps = std::max<double>(1, static_cast<double>(distances.size()) - 1);
  const auto x = [&](double k) { return left + (width - left - 10) * k / steps; };
  const auto y = [&](double d) { return top + (height - bottom - top) * (1 - std::max(0.0, d) / most); };
  const auto text = [](double tx, double ty, const std::string& words) {
    return "<text x=\"" + text_of(tx) + "\" y=\"" + text_of(ty) + "\">" + words + "</text>";
  };
  std::string line, dots;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const std::string px = text_of(x(static_cast<double>(k))), py = text_of(y(distances[k]));
    line += px + "," + py + " ";
    dots += "<circle cx=\"" + px + "\" cy=\"" + py + "\" r=\"3\"/>";
  }
  const std::string nine = text_of(y(1e-3));
  return "<svg width=\"480\" height=\"200\" class=\"plot\"><line x1=\"60\" x2=\"470\" y1=\"" + nine + "\" y2=\"" +
         nine + "\" class=\"limit\"/><polyline points=\"" + line + "\"/>" + dots + text(4, top + 10, text_of(most)) +
         text(4, y(1e-3) - 3, "0.001") + text(left, height - 8, "0") +
         text(x(steps) - 60, height - 8, "iteration " + text_of(steps)) + "</svg>\n";
}

std::string pictures_of(const std::vector<PagePicture>& pictures) {
  std::string html;
  for (const PagePicture& picture : pictures) {
    html += "<figure><img alt=\"" + escaped(picture.caption) + "\" src=\"data:image/png;base64," + base64(picture.png) +
            "\"><figcaption>" + escaped(picture.caption) + "</figcaption></figure>\n";
  }
  return html;
}

std::string section_of(const Validation& v) {
  return (v.node.empty() ? "" : "<h2>" + escaped(v.node) + "</h2>\n") + "<p>" + std::to_string(v.model_triangles) +
         " model triangles, " + std::to_string(v.slides) + " slides, " + std::to_string(v.cage_triangles) +
         " cage triangles, " + (v.certified ? "certified" : "not certified") + ".</p>\n" + "<h3>Checks</h3>\n" +
         checks_table(v) + "<h3>Equation (1) over the angles</h3>\n" + orientation_table(v.orientation) +
         "<h3>Optimality gap</h3>\n" + optimality_table(v) +
         "<h3>Convergence</h3>\n<p>Largest signed distance of (6) over the diagonal; the line is (9) for delta = "
         "0.</p>\n" +
         convergence_plot(v.max_signed_distances);
}

constexpr const char* style =
    "body{font:15px/1.4 sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:.5em 0}th,td{border:1px solid #ccc;padding:.25em .6em;text-align:left;"
    "vertical-align:top}.fault{background:#fdd}.holds td:first-child{border-left:4px solid #4a4}"
    "img{max-width:100%}figure{margin:1em 0}.plot{font-size:11px}.plot polyline{fill:none;stroke:#236;stroke-width:2}"
    ".plot circle{fill:#236}.plot .limit{stroke:#a33;stroke-dasharray:4}";

}  // namespace

std::string validation_page(const ValidationReport& report, const std::vector<std::vector<PagePicture>>& pictures,
                            const std::string& why_no_pictures) {
  std::string html = std::string("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>") +
                     escaped(report.model) + ": validation</title><style>" + style + "</style></head><body>\n<h1>" +
                     escaped(report.model) + "</h1>\n<p>" +
                     (report.agrees() ? "Every check of the plug-in's figures holds."
                                      : "<b>Not every check of the plug-in's figures holds.</b>") +
                     " Cagewright " + escaped(report.version) + ", Ceres as the independent optimiser.</p>\n";
  for (const Validation& cage : report.cages) {
    for (const Check& check : cage.checks) {
      if (!check.holds()) html += "<p class=\"fault\">" + escaped(check.fault) + "</p>\n";
    }
  }
  for (std::size_t i = 0; i < report.cages.size(); ++i) {
    html += section_of(report.cages[i]);
    if (i < pictures.size()) html += pictures_of(pictures[i]);
  }
  if (!why_no_pictures.empty()) html += "<p>There are no pictures: " + escaped(why_no_pictures) + "</p>\n";
  html += "<h2>Options</h2>\n<table>\n";
  for (const auto& [name, value] : report.options) html += row(escaped(name), escaped(value));
  return html + "</table>\n</body></html>\n";
}

}  // namespace cagewright::host
