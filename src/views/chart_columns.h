#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace bodkin::views {

// The least and the greatest value that fell into a piece of the axis; empty where nothing did.
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

// A curve against depth or time that any number of samples may be added to: it keeps the least and greatest value of
// each piece of the axis, `first_step` wide at the beginning. When the axis becomes longer than `most_steps` pieces,
// the pieces are joined two by two, so that neither memory nor the cost of a drawing grows with time.
class ChartCurve {
 public:
  explicit ChartCurve(double first_step, std::size_t most_steps = 4096);

  // A sample at a place >= 0 of the axis; others and values that are not finite are left out. The curve is joined to
  // the sample before by a straight line, so that no piece between them stays empty.
  void add(double place, double value);
  // The next sample is not joined to the one before.
  void lift() { joined_ = false; }
  void clear();

  double step() const { return step_; }  // width of a piece
  // End of the last piece that holds anything; 0 for an empty curve.
  double reach() const { return step_ * static_cast<double>(columns_.size()); }
  // What a chart of `count` pixel columns shows of the axis from `from` to `to`.
  std::vector<ChartColumn> columns(double from, double to, std::size_t count) const;
  // The greatest value that an axis should hold: of all, unless fewer than `spikes` columns of 512 are more than
  // twice as high as the rest; those are left to be cut off, for one odd tick would press all else to the ground. 0
  // for an empty curve.
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

// The end of an axis that holds `most`: 1, 2 or 5 times a power of ten, or 4, 6 or 8 times one; at least `least`.
double axis_end(double most, double least);
// The distance between the numbers of an axis from 0 to `end` with room for `count` of them: 1, 2 or 5 times a power
// of ten.
double axis_step(double end, int count);

}  // namespace bodkin::views
