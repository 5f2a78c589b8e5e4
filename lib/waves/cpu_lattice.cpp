#include <cmath>
#include <numbers>
#include <waves/cpu_lattice.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

glm::vec2 timesI(const glm::vec2& z) noexcept { return {-z.y, z.x}; }

}  // namespace

CpuLattice::CpuLattice(const SeaChange& sea, const WavesInfo& info, std::uint32_t cascade, double kMax)
    : size_(info.layout.size),
      density_(size_ / info.layout.cascades[cascade].length),
      loopPeriod_(info.loopPeriod),
      changing_(sea.changing()) {
  const std::size_t count = std::size_t{size_} * size_;
  const std::size_t first = cascade * count;
  const double dk = kTwoPi / info.layout.cascades[cascade].length;
  const auto waveOf = [&](const GridSea& grid, std::size_t index) {
    const ModeConstants& constants = grid.constants[first + index];
    return Wave{constants.cycles, constants.chop, static_cast<float>(kTwoPi * constants.cycles / loopPeriod_),
                grid.amplitudes[first + index]};
  };
  for (std::uint32_t row = 0; row < size_; ++row) {
    for (std::uint32_t column = 0; column < size_; ++column) {
      const std::uint32_t index = row * size_ + column;
      const glm::dvec2 k = dk * glm::dvec2(modeOf(column, size_), modeOf(row, size_));
      if (sea.after.constants[first + index].cycles == 0 || glm::length(k) > kMax) continue;
      Mode mode;
      mode.index = index;
      mode.kx = static_cast<float>(k.x);
      mode.kz = static_cast<float>(k.y);
      mode.after = waveOf(sea.after, index);
      if (changing_) mode.before = waveOf(sea.before, index);
      modes_.push_back(mode);
    }
  }
  for (auto* map : {&texels_.displacement, &texels_.gradient, &texels_.velocity, &texels_.acceleration}) {
    map->assign(count, glm::vec4(0));
  }
}

/// Spectrum of a real field from that of the elevation or of its rate: D = i k chop h (ModeConstants), derivatives by
/// i k.
glm::vec2 CpuLattice::apply(Operator wanted, const Mode& m, const Spectral& of) noexcept {
  switch (wanted) {
    case Operator::height:
      return of.h;
    case Operator::dx:
      return timesI(of.chop) * m.kx;
    case Operator::dz:
      return timesI(of.chop) * m.kz;
    case Operator::hx:
      return timesI(of.h) * m.kx;
    case Operator::hz:
      return timesI(of.h) * m.kz;
    case Operator::dxdx:
      return of.chop * (-m.kx * m.kx);
    case Operator::dzdz:
      return of.chop * (-m.kz * m.kz);
    case Operator::dzdx:
      return of.chop * (-m.kz * m.kx);
  }
  return {};
}

void CpuLattice::add(const Wave& wave, std::uint64_t fraction, const Share& share, Mode& mode) noexcept {
  // The angle of n times the fraction, exact in wrapping integers; its sign bit makes it -pi … pi.
  const auto turn = static_cast<std::int64_t>(wave.cycles * fraction);
  const double phase = kTwoPi * 0x1p-64 * static_cast<double>(turn);
  const glm::vec2 e(static_cast<float>(std::cos(phase)), static_cast<float>(std::sin(phase)));
  const glm::vec4 a = wave.amplitude;
  const glm::vec2 forward(a.x * e.x + a.y * e.y, a.y * e.x - a.x * e.y);   // h0(k) e^{-i w t}
  const glm::vec2 backward(a.z * e.x - a.w * e.y, a.w * e.x + a.z * e.y);  // conj h0(-k) e^{+i w t}
  const glm::vec2 h = forward + backward;
  const glm::vec2 rate = timesI(backward - forward) * wave.frequency;
  const glm::vec2 acceleration = h * (-wave.frequency * wave.frequency);
  const auto value = static_cast<float>(share.value);
  const auto growth = static_cast<float>(share.rate);
  const auto sum = [&](Spectral& target, const glm::vec2& part) {
    target.h += part;
    target.chop += times(wave.chop, part);
  };
  sum(mode.elevation, value * h);
  sum(mode.rate, value * rate + growth * h);
  sum(mode.acceleration, value * acceleration + 2 * growth * rate + static_cast<float>(share.acceleration) * h);
}

void CpuLattice::evolve(double time, const Share& share, const InverseFft& fft, ComplexPlane& plane,
                        ComplexPlane& scratch) noexcept {
  const std::uint64_t fraction = loopFraction(time, loopPeriod_);
  for (Mode& mode : modes_) {
    mode.elevation = mode.rate = mode.acceleration = {};
    add(mode.after, fraction, share, mode);
    if (changing_ && share.value < 1)
      add(mode.before, fraction, {1 - share.value, -share.rate, -share.acceleration}, mode);
  }
  // Two real fields ride in one transform; each has a channel of a map.
  struct Field {
    Spectral Mode::*source;
    Operator of;
    std::vector<glm::vec4>* map;
    int channel;
  };
  using O = Operator;
  const auto height = &Mode::elevation;
  const auto rate = &Mode::rate;
  const auto acceleration = &Mode::acceleration;
  LatticeTexels& t = texels_;
  const Field pairs[][2] = {{{height, O::dx, &t.displacement, 0}, {height, O::height, &t.displacement, 1}},
                            {{height, O::dz, &t.displacement, 2}, {height, O::dzdx, &t.displacement, 3}},
                            {{height, O::hx, &t.gradient, 0}, {height, O::hz, &t.gradient, 1}},
                            {{height, O::dxdx, &t.gradient, 2}, {height, O::dzdz, &t.gradient, 3}},
                            {{rate, O::dx, &t.velocity, 0}, {rate, O::height, &t.velocity, 1}},
                            {{acceleration, O::dx, &t.acceleration, 0}, {acceleration, O::height, &t.acceleration, 1}},
                            {{rate, O::dz, &t.velocity, 2}, {acceleration, O::dz, &t.acceleration, 2}}};
  for (const auto& [real, imaginary] : pairs) {
    std::fill(plane.re.begin(), plane.re.end(), 0.0f);
    std::fill(plane.im.begin(), plane.im.end(), 0.0f);
    for (const Mode& mode : modes_) {
      const glm::vec2 sum =
          apply(real.of, mode, mode.*real.source) + timesI(apply(imaginary.of, mode, mode.*imaginary.source));
      plane.re[mode.index] = sum.x;
      plane.im[mode.index] = sum.y;
    }
    fft.transform(plane, scratch);
    for (std::size_t i = 0; i < plane.re.size(); ++i) {
      (*real.map)[i][real.channel] = plane.re[i];
      (*imaginary.map)[i][imaginary.channel] = plane.im[i];
    }
  }
}

}  // namespace pelagic
