#include <algorithm>
#include <cmath>
#include <numbers>
#include <waves/peak.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
/// Bins in ln w, far finer than JONSWAP's peak, 0.07. They reach beyond every peak that a sea may have (tables from
/// 1e-3 to 50 Hz); S^4 falls as w^-20.
constexpr double kLowest = 4e-3;   // [rad/s]
constexpr double kHighest = 1200;  // [rad/s]
constexpr double kStep = 0.005;

std::size_t binCount() noexcept { return static_cast<std::size_t>(std::ceil(std::log(kHighest / kLowest) / kStep)); }

/// S at the middle of the bins, over its largest value, so that the fourth power of a calm sea's is still a number.
class Shape {
 public:
  explicit Shape(const SeaState& sea) : spectrum_(binCount()) {
    double most = 0;
    for (std::size_t bin = 0; bin < spectrum_.size(); ++bin) {
      spectrum_[bin] = frequencySpectrum(sea, frequency(bin));
      most = std::max(most, spectrum_[bin]);
    }
    for (double& value : spectrum_) value = most > 0 ? value / most : 0;
  }
  static double frequency(std::size_t bin) noexcept {
    return kLowest * std::exp(kStep * (static_cast<double>(bin) + 0.5));
  }
  double spectrum(std::size_t bin) const noexcept { return spectrum_[bin]; }

 private:
  std::vector<double> spectrum_;
};

double cube(double x) noexcept { return x * x * x; }

}  // namespace

double weightedPeakFrequency(const SeaState& sea) {
  const Shape shape(sea);
  double moment = 0, sum = 0;
  for (std::size_t bin = 0; bin < binCount(); ++bin) {
    const double w = Shape::frequency(bin);
    const double s = shape.spectrum(bin);
    const double energy = s * cube(s) * w;  // dw = w dln w
    moment += energy * w;
    sum += energy;
  }
  return sum > 0 ? moment / sum : 0;
}

ModeEnergies::ModeEnergies() : bins_(binCount()) {}

void ModeEnergies::add(const CascadeModes& modes, double loopPeriod) noexcept {
  for (std::size_t mode = 0; mode < modes.variance.size(); ++mode) {
    if (!(modes.variance[mode] > 0)) continue;
    const double w = kTwoPi * modes.constants[mode].cycles / loopPeriod;
    const double bin = std::floor(std::log(w / kLowest) / kStep);
    if (!(bin >= 0 && bin < static_cast<double>(bins_.size()))) continue;
    bins_[static_cast<std::size_t>(bin)].energy += modes.variance[mode];
    bins_[static_cast<std::size_t>(bin)].moment += modes.variance[mode] * w;
  }
}

double ModeEnergies::weightedPeakFrequency(const SeaState& sea) const {
  const Shape shape(sea);
  double moment = 0, sum = 0;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
    if (!(bins_[bin].energy > 0)) continue;
    const double share = cube(shape.spectrum(bin));
    moment += share * bins_[bin].moment;
    sum += share * bins_[bin].energy;
  }
  return sum > 0 ? moment / sum : 0;
}

double gridPeakPeriod(const SeaState& sea, const ModeEnergies& modes) {
  const double achieved = modes.weightedPeakFrequency(sea);
  return achieved > 0 ? peakPeriod(sea) * weightedPeakFrequency(sea) / achieved : 0;
}

}  // namespace pelagic
