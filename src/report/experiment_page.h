#pragma once

#include <string>
#include <vector>

#include "study/experiment.h"

namespace bodkin::report {

// An experiment with its run and plot.
struct Figure {
  io::Experiment experiment;
  study::ExperimentRun run;
};

// "1.50 N", "-0.25 N": a value of a quantity with its unit.
std::string with_unit(double value, io::Quantity quantity);

// A page with every figure (files NAME.svg next to it), its caption and its table of published and found numbers.
std::string figures_html(const std::vector<Figure>& figures);

// The same page as Markdown, for documentation.
std::string figures_markdown(const std::vector<Figure>& figures);

}  // namespace bodkin::report
