#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace bodkin::views {

// The least and the greatest value in a piece of the axis; empty without values.
struct ChartColumn {
  float least = std::numeric_limits<float>::infinity();
  float most = -std::numeric_limits<float>::infinity();

  bool empty() const { return least > most; }
  void add(float value) {
    if (value < least) least = value;
    if (value > most) most = value;
  }
  void add(const ChartColumn& other) {
    if (other.least < least) least = other.least;
    if (other.most > most) most = other.most;
  }
  bool operator==(const ChartColumn&) const = default;
};

// A curve against depth or time with any number of samples: it stores the least and greatest value of each piece of
// the axis, initially `first_step` wide. When the axis becomes longer than `most_steps` pieces, the pieces are joined
// in pairs, so that neither memory nor the cost of drawing grows with time.
class ChartCurve {
 public:
  explicit ChartCurve(double first_step, std::size_t most_steps = 4096);

  // Adds a sample at a position >= 0 of the axis; others and values that are not finite are ignored. The curve is
  // connected to the previous sample by a straight line, so that no piece between them stays empty.
  void add(double place, double value);
  // Does not connect the next sample to the previous one.
  void lift() { joined_ = false; }
  void clear();

  double step() const { return step_; }  // width of a piece
  // End of the last non-empty piece; 0 for an empty curve.
  double reach() const { return step_ * static_cast<double>(columns_.size()); }
  // The content of a chart of `count` pixel columns showing the axis from `from` to `to`.
  std::vector<ChartColumn> columns(double from, double to, std::size_t count) const;
  // The greatest value for an axis: of all, unless fewer than `spikes` columns of 512 are more than twice as high as
  // the rest; those are clipped, because one outlier would flatten everything else. 0 for an empty curve.
  double usual_most(std::size_t spikes = 3) const;
  // The greatest and least of all values.
  const ChartColumn& range() const { return range_; }

 private:
  void put(std::size_t piece, float value);
  void join_pieces();

  double first_step_, step_;
  std::size_t most_steps_;
  std::vector<ChartColumn> columns_;
  ChartColumn range_;
  bool joined_ = false;
  double place_ = 0.0, value_ = 0.0;  // of the last sample
};

// The end of an axis that contains `most`: 1, 2 or 5 times a power of ten, or 4, 6 or 8 times one; at least `least`.
double axis_end(double most, double least);
// The distance between the labels of an axis from 0 to `end` with room for `count` of them: 1, 2 or 5 times a power
// of ten.
double axis_step(double end, int count);

}  // namespace bodkin::views
