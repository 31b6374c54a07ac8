#include <algorithm>
#include <cstddef>

#include "draw/png.hpp"
#include "draw/svg/plan.hpp"

namespace brdfplot::plot {

void measure_spheres(const Figure&, FigurePlan& plan, double width) {
  constexpr double largest = 320;
  const double cell = width / plan.columns;
  const double side = std::min(cell, largest);
  for (PanelPlan& panel : plan.panels) {
    if (panel.kind != Kind::spheres) continue;
    panel.plot.w = panel.plot.h = side;
    panel.x = panel.y = {panel.panel->x.from, panel.panel->x.to};
    panel.insets = {(cell - side) / 2, (cell - side) / 2, 2, 0};
  }
}

void draw_spheres(SvgWriter& svg, const PanelPlan& plan) {
  if (plan.panel->picture) svg.image(plan.plot, "image/png", to_png(*plan.panel->picture));
}

} // namespace brdfplot::plot
