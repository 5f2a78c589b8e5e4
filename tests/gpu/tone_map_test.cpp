#include <cmath>
#include <pelagic/composite.hpp>

#include "composite/white_balance.hpp"
#include "physics/tone.glsl"
#include "support/gpu_test.hpp"

namespace {

using namespace pelagic;

class ToneMapTest : public support::GpuTest {
 protected:
  /// 8-bit values (RGBA, 0 … 255) of a picture of one radiance.
  std::vector<float> map(float radiance, float exposure, bool metered = false, double kelvin = 6504) {
    const vk::Extent2D extent{48, 48};
    using Usage = vk::ImageUsageFlagBits;
    const auto input = common::createImage(gpu(), vk::Format::eR32G32B32A32Sfloat, extent,
                                           Usage::eSampled | Usage::eTransferDst, "input");
    const auto output =
        common::createImage(gpu(), vk::Format::eR8G8B8A8Unorm, extent, Usage::eStorage | Usage::eTransferSrc, "output");
    const ImageState cleared{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    auto tone = ToneMap::create(
        device(), {input.host(cleared, kShaderRead), output.host(common::kUndefined, common::kTransferSource)});
    EXPECT_TRUE(tone) << tone.error().message;
    EXPECT_TRUE(tone->setWhiteBalance(kelvin));
    for (const double wrong : {1999.0, 25001.0, std::nan("")}) {
      const auto refused = tone->setWhiteBalance(wrong);
      EXPECT_FALSE(refused);
      EXPECT_NE(refused.error().message.find("it must be 2000 to 25000 K"), std::string::npos);
    }
    gpu().run([&](vk::CommandBuffer commands) {
      const vk::ImageSubresourceRange range(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
      const vk::ImageMemoryBarrier2 barrier({}, {}, vk::PipelineStageFlagBits2::eAllTransfer,
                                            vk::AccessFlagBits2::eTransferWrite, vk::ImageLayout::eUndefined,
                                            vk::ImageLayout::eTransferDstOptimal, VK_QUEUE_FAMILY_IGNORED,
                                            VK_QUEUE_FAMILY_IGNORED, *input.image, range);
      commands.pipelineBarrier2({{}, {}, {}, barrier});
      commands.clearColorImage(*input.image, vk::ImageLayout::eTransferDstOptimal,
                               vk::ClearColorValue(std::array<float, 4>{radiance, radiance, radiance, 1}), range);
      metered ? tone->recordMetered(commands, exposure) : tone->record(commands, exposure);
    });
    return common::readFloats(gpu(), *output.image, output.format, extent, common::kTransferSource);
  }
  double mean(float radiance, float exposure) {
    const auto values = map(radiance, exposure);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); i += 4) sum += values[i];
    return sum / (static_cast<double>(values.size()) / 4);
  }
};

/// The same curve in double precision with the standard's own encoding.
double display(double x) {
  const double p = std::pow(x, 1.25);
  const double y = p / (p + std::pow(0.18, 1.25) * (1 / 0.18 - 1));
  return 255 * (y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - 0.055);
}

// At 4500 K daylight is blue.
TEST_F(ToneMapTest, WhiteBalance) {
  const glm::dvec3 expected = whiteBalance(4500) * glm::dvec3(0.2);
  ASSERT_LT(expected.r, 0.9 * expected.b);
  const auto values = map(0.2f, 0, false, 4500);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = c; i < values.size(); i += 4) sum += static_cast<double>(values[i]);
    EXPECT_NEAR(sum / (static_cast<double>(values.size()) / 4), display(expected[static_cast<int>(c)]), 0.1) << c;
  }
}

TEST_F(ToneMapTest, MeanOfTheDitherIsTheValue) {
  for (const float radiance : {0.004f, 0.03f, 0.18f, 0.5f, 1.0f, 20.0f}) {
    EXPECT_NEAR(mean(radiance, 0), display(radiance), 0.07) << radiance;
    const auto values = map(radiance, 0);
    for (std::size_t i = 0; i < values.size(); i += 4) {
      ASSERT_LE(std::abs(values[i] - display(radiance)), 1.02) << radiance;
    }
  }
}

TEST_F(ToneMapTest, ExposureIsInStops) { EXPECT_NEAR(mean(0.05f, 1.5f), mean(0.05f * std::exp2(1.5f), 0), 1e-6); }

/// A picture of one radiance is middle grey, whatever the radiance, and compensation adds stops.
TEST_F(ToneMapTest, MeteringMakesMiddleGrey) {
  for (const float radiance : {0.002f, 0.18f, 7.0f}) {
    const auto values = map(radiance, 0, true);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); i += 4) sum += 4 * values[i] / static_cast<double>(values.size());
    EXPECT_NEAR(sum, display(0.18), 0.1) << radiance;
    const auto brighter = map(radiance, 1, true);
    double two = 0;
    for (std::size_t i = 0; i < brighter.size(); i += 4) two += 4 * brighter[i] / static_cast<double>(brighter.size());
    EXPECT_NEAR(two, display(0.36), 0.1) << radiance;
  }
  // The bounds: black is not made grey, nor is the sun's disc.
  EXPECT_EQ(map(0, 0, true)[0], 0);
  EXPECT_GT(map(50000, 0, true)[0], 250);
}

TEST_F(ToneMapTest, MeteringIsTheMeanOfStops) {
  EXPECT_NEAR(physics::meteredStops({0.25f, 0.25f, 0.25f}), -2, 1e-5);
  EXPECT_NEAR(physics::meteredStops({1, 0, 0}), std::log2(0.2126), 1e-5);
  EXPECT_NEAR(physics::meteredExposure(static_cast<float>(std::log2(0.18))), 0, 1e-6);
  EXPECT_NEAR(physics::meteredExposure(0), std::log2(0.18), 1e-6) << "a picture of 1 is darkened";
}

}  // namespace
