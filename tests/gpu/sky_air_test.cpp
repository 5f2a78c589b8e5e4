// The maps of the air, which the sky keeps to itself: their shaders run here on images of the test's own.
#include <cmath>
#include <span>

#include "physics/atmosphere.glsl"
#include "shared/sky_pass.h"
#include "sky_transmittance_comp.spv.hpp"
#include "support/gpu_test.hpp"

namespace {

namespace air = pelagic::shader;
using glm::dvec3;

constexpr pelagic::ImageState kWritten{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                                       VK_IMAGE_LAYOUT_GENERAL};

class SkyAirTest : public support::GpuTest {
 protected:
  /// Runs a shader whose only binding is an image that it writes.
  std::vector<float> drawn(std::span<const std::uint32_t> code, vk::Extent2D extent, const air::SkyPass& push) {
    const vk::Device vulkan = gpu().device();
    const auto image =
        common::createImage(gpu(), vk::Format::eR16G16B16A16Sfloat, extent,
                            vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eTransferSrc, "under test");
    const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eStorageImage, 1,
                                                 vk::ShaderStageFlagBits::eCompute);
    const auto setLayout = vulkan.createDescriptorSetLayoutUnique({{}, binding});
    const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0, sizeof(push));
    const auto layout = vulkan.createPipelineLayoutUnique({{}, *setLayout, range});
    const auto shader = vulkan.createShaderModuleUnique({{}, code.size_bytes(), code.data()});
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
    const auto pipeline = vulkan.createComputePipelineUnique({}, {{}, stage, *layout}).value;
    const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageImage, 1);
    const auto pool = vulkan.createDescriptorPoolUnique({{}, 1, size});
    const vk::DescriptorSet set = vulkan.allocateDescriptorSets({*pool, *setLayout}).front();
    const vk::DescriptorImageInfo view({}, *image.view, vk::ImageLayout::eGeneral);
    vulkan.updateDescriptorSets(vk::WriteDescriptorSet(set, 0, 0, vk::DescriptorType::eStorageImage, view), {});
    gpu().run([&](vk::CommandBuffer commands) {
      const vk::ImageMemoryBarrier2 ready({}, {}, vk::PipelineStageFlagBits2::eComputeShader,
                                          vk::AccessFlagBits2::eShaderStorageWrite, vk::ImageLayout::eUndefined,
                                          vk::ImageLayout::eGeneral, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                                          *image.image, {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1});
      commands.pipelineBarrier2({{}, {}, {}, ready});
      commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
      commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, set, {});
      commands.pushConstants(*layout, vk::ShaderStageFlagBits::eCompute, 0, sizeof(push), &push);
      commands.dispatch(extent.width / air::kSkyTile, extent.height / air::kSkyTile, 1);
    });
    return common::readFloats(gpu(), *image.image, image.format, extent, kWritten);
  }
};

/// Transmittance from altitude h to 100 km in double precision, densities and coefficients written out again.
dvec3 transmittance(double h, double mu, double haze, double hazeHeight) {
  constexpr double radius = 6371e3, top = radius + 100e3;
  const double r = radius + h;
  const double end = -r * mu + std::sqrt(r * r * (mu * mu - 1) + top * top);
  constexpr int kSteps = 50000;
  dvec3 depth(0);
  for (int i = 0; i < kSteps; ++i) {
    const double t = end * (i + 0.5) / kSteps;
    const double z = std::sqrt(r * r + 2 * r * mu * t + t * t) - radius;
    depth += end / kSteps *
             (dvec3(7.10e-6, 1.38e-5, 3.31e-5) * std::exp(-z / 8000) +
              haze * dvec3(5.50e-5, 5.86e-5, 6.38e-5) * std::exp(-z / hazeHeight) +
              dvec3(2.58e-6, 1.71e-6, 0) * std::max(0.0, 1 - std::abs(z - 25e3) / 15e3));
  }
  return glm::exp(-depth);
}

TEST_F(SkyAirTest, TransmittanceMapEqualsQuadrature) {
  for (const auto& [haze, hazeHeight] : {std::pair(1.0, 1200.0), std::pair(6.0, 1200.0), std::pair(3.0, 400.0)}) {
    constexpr int kWidth = air::kTransmittanceWidth, kHeight = air::kTransmittanceHeight;
    air::SkyPass push{};
    push.haze = glm::vec2(haze, hazeHeight);
    const std::vector<float> map = drawn(pelagic::shaders::sky_transmittance_comp, {kWidth, kHeight}, push);
    for (const double h : {0.0, 800.0, 9000.0, 40000.0}) {
      for (const double degrees : {90.0, 40.0, 12.0, 3.0, 0.5, 0.0, -2.0, -5.0}) {
        const double mu = std::sin(glm::radians(degrees));
        if (mu < double(air::horizonCosine(float(h)))) continue;
        const glm::vec2 at = air::transmittancePlace(float(h), float(mu)) * glm::vec2(kWidth - 1, kHeight - 1);
        const int x = std::min(int(at.x), kWidth - 2), y = std::min(int(at.y), kHeight - 2);
        const auto texel = [&](int i, int j) {
          const float* p = &map[4 * static_cast<std::size_t>((y + j) * kWidth + x + i)];
          return dvec3(p[0], p[1], p[2]);
        };
        const dvec3 value = glm::mix(glm::mix(texel(0, 0), texel(1, 0), double(at.x) - x),
                                     glm::mix(texel(0, 1), texel(1, 1), double(at.x) - x), double(at.y) - y);
        const dvec3 expected = transmittance(h, mu, haze, hazeHeight);
        for (int c = 0; c < 3; ++c) {
          // Interpolation between the map's rows errs most where much haze thins out quickly.
          EXPECT_NEAR(value[c], expected[c], 0.01 * (haze + 0.5) * expected[c] + 1e-4)
              << haze << ' ' << hazeHeight << ' ' << h << ' ' << degrees;
        }
      }
    }
  }
}

}  // namespace
