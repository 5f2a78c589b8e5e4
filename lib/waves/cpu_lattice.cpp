#include <cmath>
#include <numbers>
#include <waves/cpu_lattice.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

int modeOf(std::uint32_t i, std::uint32_t size) noexcept {
  return static_cast<int>(i) - (i >= size / 2 ? static_cast<int>(size) : 0);
}

/// std::floor() is a call where the processor is not known to round.
std::int64_t floorOf(double x) noexcept {
  const auto whole = static_cast<std::int64_t>(x);
  return whole - (x < static_cast<double>(whole));
}

glm::vec2 timesI(const glm::vec2& z) noexcept { return {-z.y, z.x}; }

}  // namespace

CpuLattice::CpuLattice(const SeaState& sea, const WavesInfo& info, std::uint32_t cascade, double kMax)
    : size_(info.layout.size),
      length_(info.layout.cascades[cascade].length),
      density_(size_ / length_),
      loopPeriod_(info.loopPeriod) {
  const CascadeModes all = makeModes(sea, info.layout, cascade, info.loopPeriod);
  const double dk = kTwoPi / length_;
  for (std::uint32_t row = 0; row < size_; ++row) {
    for (std::uint32_t column = 0; column < size_; ++column) {
      const std::uint32_t index = row * size_ + column;
      const glm::dvec2 k = dk * glm::dvec2(modeOf(column, size_), modeOf(row, size_));
      if (all.constants[index].cycles == 0 || glm::length(k) > kMax) continue;
      Mode mode;
      mode.index = index;
      mode.cycles = all.constants[index].cycles;
      mode.kx = static_cast<float>(k.x);
      mode.kz = static_cast<float>(k.y);
      mode.chop = all.constants[index].chop;
      mode.frequency = static_cast<float>(kTwoPi * mode.cycles / loopPeriod_);
      mode.amplitude = all.amplitude[index];
      modes_.push_back(mode);
    }
  }
  const std::size_t count = std::size_t{size_} * size_;
  for (auto* map : {&texels_.displacement, &texels_.gradient, &texels_.velocity, &texels_.acceleration}) {
    map->assign(count, glm::vec4(0));
  }
}

/// Spectrum of a real field from the elevation's: D = i (k/k) coth(kh) choppiness h, derivatives by i k.
glm::vec2 CpuLattice::field(const Mode& m, Field field) noexcept {
  const float w2 = m.frequency * m.frequency;
  switch (field) {
    case Field::dx:
      return timesI(m.elevation) * (m.chop * m.kx);
    case Field::h:
      return m.elevation;
    case Field::dz:
      return timesI(m.elevation) * (m.chop * m.kz);
    case Field::dzdx:
      return m.elevation * (-m.chop * m.kz * m.kx);
    case Field::hx:
      return timesI(m.elevation) * m.kx;
    case Field::hz:
      return timesI(m.elevation) * m.kz;
    case Field::dxdx:
      return m.elevation * (-m.chop * m.kx * m.kx);
    case Field::dzdz:
      return m.elevation * (-m.chop * m.kz * m.kz);
    case Field::vx:
      return timesI(m.rate) * (m.chop * m.kx);
    case Field::vh:
      return m.rate;
    case Field::vz:
      return timesI(m.rate) * (m.chop * m.kz);
    case Field::ax:
      return timesI(m.elevation) * (-w2 * m.chop * m.kx);
    case Field::ah:
      return m.elevation * -w2;
    case Field::az:
      return timesI(m.elevation) * (-w2 * m.chop * m.kz);
  }
  return {};
}

void CpuLattice::evolve(double time, const InverseFft& fft, ComplexPlane& plane, ComplexPlane& scratch) noexcept {
  const std::uint64_t fraction = loopFraction(time, loopPeriod_);
  for (Mode& mode : modes_) {
    // The angle of n times the fraction, exact in wrapping integers; its sign bit makes it -pi … pi.
    const auto turn = static_cast<std::int64_t>(mode.cycles * fraction);
    const double phase = kTwoPi * 0x1p-64 * static_cast<double>(turn);
    const glm::vec2 e(static_cast<float>(std::cos(phase)), static_cast<float>(std::sin(phase)));
    const glm::vec4 a = mode.amplitude;
    const glm::vec2 forward(a.x * e.x + a.y * e.y, a.y * e.x - a.x * e.y);   // h0(k) e^{-i w t}
    const glm::vec2 backward(a.z * e.x - a.w * e.y, a.w * e.x + a.z * e.y);  // conj h0(-k) e^{+i w t}
    mode.elevation = forward + backward;
    mode.rate = timesI(backward - forward) * mode.frequency;
  }
  struct Pair {
    Field first, second;  // the real and the imaginary part of one transform
    std::vector<glm::vec4>* map;
    int channel;  // of the first
  };
  using F = Field;
  LatticeTexels& t = texels_;
  const Pair pairs[] = {{F::dx, F::h, &t.displacement, 0}, {F::dz, F::dzdx, &t.displacement, 2},
                        {F::hx, F::hz, &t.gradient, 0},    {F::dxdx, F::dzdz, &t.gradient, 2},
                        {F::vx, F::vh, &t.velocity, 0},    {F::ax, F::ah, &t.acceleration, 0},
                        {F::vz, F::az, &t.velocity, 2}};
  for (const Pair& pair : pairs) {
    std::fill(plane.re.begin(), plane.re.end(), 0.0f);
    std::fill(plane.im.begin(), plane.im.end(), 0.0f);
    for (const Mode& mode : modes_) {
      const glm::vec2 sum = field(mode, pair.first) + timesI(field(mode, pair.second));
      plane.re[mode.index] = sum.x;
      plane.im[mode.index] = sum.y;
    }
    fft.transform(plane, scratch);
    for (std::size_t i = 0; i < plane.re.size(); ++i) {
      (*pair.map)[i][pair.channel] = plane.re[i];
      (*pair.map)[i][pair.channel + 1] = plane.im[i];
    }
  }
  // The last pair's second field belongs to the other map.
  for (std::size_t i = 0; i < plane.im.size(); ++i) t.acceleration[i].z = plane.im[i];
}

LatticePlace CpuLattice::placeOf(const glm::dvec2& point) const noexcept {
  const glm::dvec2 at = point * density_;
  const std::int64_t baseX = floorOf(at.x);
  const std::int64_t baseZ = floorOf(at.y);
  const std::size_t x = static_cast<std::size_t>(baseX) & (size_ - 1);
  const std::size_t z = static_cast<std::size_t>(baseZ) & (size_ - 1);
  const std::size_t nextX = (x + 1) & (size_ - 1);
  const std::size_t row = z * size_;
  const std::size_t nextRow = ((z + 1) & (size_ - 1)) * size_;
  return {{row + x, row + nextX, nextRow + x, nextRow + nextX},
          static_cast<float>(at.x - static_cast<double>(baseX)),
          static_cast<float>(at.y - static_cast<double>(baseZ))};
}

}  // namespace pelagic
