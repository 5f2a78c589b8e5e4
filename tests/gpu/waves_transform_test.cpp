#include "waves_support.hpp"

namespace {

using support::kFieldNames;
using support::kFields;

class WaveTransformTest : public support::WavesTest, public testing::WithParamInterface<std::uint32_t> {};

TEST_P(WaveTransformTest, AgreesWithFftw) {
  const std::uint32_t cascades = GetParam() < 1024 ? 2 : 1;  // the largest takes seconds
  auto info = support::wavesInfo(GetParam(), cascades, 12);
  info.sea.depth = 40;
  info.sea.choppiness = 0.9;
  auto waves = create(info);
  constexpr double kTime = 1234.5678;
  record(waves, kTime);
  for (std::uint32_t cascade = 0; cascade < info.layout.count; ++cascade) {
    const auto fields = read(waves.maps(), cascade);
    const auto reference = support::referenceFields(info, cascade, kTime);
    for (std::size_t f = 0; f < kFields; ++f) {
      const double error = support::relativeError(fields[f], reference[f]);
      EXPECT_LT(error, 1e-5) << kFieldNames[f] << " of cascade " << cascade;
    }
    const auto displacement = common::readFloats(gpu(), waves.maps().displacement, 0, cascade);
    for (std::size_t i = 0; i < reference[0].size(); ++i) {
      const double dzdx = reference[7][i];
      const double jacobian = (1 + reference[5][i]) * (1 + reference[6][i]) - dzdx * dzdx;
      ASSERT_NEAR(displacement[4 * i + 3], jacobian, 1e-5);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, WaveTransformTest, testing::Values(64, 128, 256, 512, 1024));

}  // namespace
