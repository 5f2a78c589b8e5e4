#include "composite_support.hpp"

#include <cmath>
#include <cstring>
#include <limits>

namespace support {
namespace {

using vk::Format;
using Usage = vk::ImageUsageFlagBits;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

vk::UniqueImageView arrayView(const common::GpuDevice& gpu, const common::OwnedImage& image) {
  return gpu.device().createImageViewUnique(
      {{}, *image.image, vk::ImageViewType::e2DArray, image.format, {}, {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}});
}

vk::ImageSubresourceRange rangeOf(const common::OwnedImage& image) {
  const bool depth = image.format == Format::eD32Sfloat;
  return {depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};
}

/// Written by transfers, then read or written by shaders, then read by transfers.
void transition(vk::CommandBuffer commands, const common::OwnedImage& image, const pelagic::ImageState& from,
                const pelagic::ImageState& to) {
  const vk::ImageMemoryBarrier2 barrier(vk::PipelineStageFlags2(from.stages), vk::AccessFlags2(from.access),
                                        vk::PipelineStageFlags2(to.stages), vk::AccessFlags2(to.access),
                                        vk::ImageLayout(from.layout), vk::ImageLayout(to.layout),
                                        VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *image.image, rangeOf(image));
  commands.pipelineBarrier2({{}, {}, {}, barrier});
}

constexpr pelagic::ImageState kFilled{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

void clear(vk::CommandBuffer commands, const common::OwnedImage& image, const std::array<float, 4>& value,
           const pelagic::ImageState& rest = pelagic::kShaderRead) {
  transition(commands, image, common::kUndefined, kFilled);
  commands.clearColorImage(*image.image, vk::ImageLayout::eTransferDstOptimal, vk::ClearColorValue(value),
                           rangeOf(image));
  if (rest.layout != kFilled.layout) transition(commands, image, kFilled, rest);
}

struct HostBuffer {
  vk::UniqueDeviceMemory memory;
  vk::UniqueBuffer buffer;
};

HostBuffer hostBuffer(const common::GpuDevice& gpu, const void* data, std::size_t bytes, vk::BufferUsageFlags usage) {
  HostBuffer result;
  result.buffer = gpu.device().createBufferUnique({{}, bytes, usage});
  const auto needs = gpu.device().getBufferMemoryRequirements(*result.buffer);
  const auto memory = gpu.physicalDevice().getMemoryProperties();
  const auto wanted = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  std::uint32_t type = 0;
  while ((memory.memoryTypes[type].propertyFlags & wanted) != wanted || !(needs.memoryTypeBits >> type & 1u)) ++type;
  result.memory = gpu.device().allocateMemoryUnique({needs.size, type});
  gpu.device().bindBufferMemory(*result.buffer, *result.memory, 0);
  std::memcpy(gpu.device().mapMemory(*result.memory, 0, VK_WHOLE_SIZE), data, bytes);
  gpu.device().unmapMemory(*result.memory);
  return result;
}

void copyInto(const common::GpuDevice& gpu, const common::OwnedImage& image, const void* data, std::size_t bytes) {
  const HostBuffer staging = hostBuffer(gpu, data, bytes, vk::BufferUsageFlagBits::eTransferSrc);
  gpu.run([&](vk::CommandBuffer commands) {
    transition(commands, image, common::kUndefined, kFilled);
    const vk::BufferImageCopy copy(0, 0, 0, {rangeOf(image).aspectMask, 0, 0, 1}, {},
                                   {image.extent.width, image.extent.height, 1});
    commands.copyBufferToImage(*staging.buffer, *image.image, vk::ImageLayout::eTransferDstOptimal, copy);
    transition(commands, image, kFilled, pelagic::kShaderRead);
  });
}

pelagic::MapView mapOf(const common::OwnedImage& image, vk::ImageView view) {
  return {*image.image, view, static_cast<VkFormat>(image.format), image.extent, 1, 1};
}

}  // namespace

glm::mat4 perspective(double verticalAngle, double aspect, double near, bool reversed) {
  const double f = 1 / std::tan(verticalAngle / 2);
  glm::dmat4 m(0);
  m[0][0] = f / aspect;
  m[1][1] = -f;
  m[2][2] = reversed ? 0 : -1;
  m[2][3] = -1;
  m[3][2] = reversed ? near : -near;
  return glm::mat4(m);
}

glm::mat3 lookAlong(double yaw, double pitch) {
  const glm::dvec3 forward(std::sin(yaw) * std::cos(pitch), -std::sin(pitch), -std::cos(yaw) * std::cos(pitch));
  const glm::dvec3 right(std::cos(yaw), 0, std::sin(yaw));
  return glm::mat3(glm::transpose(glm::dmat3(right, glm::cross(right, forward), -forward)));
}

SyntheticScene::SyntheticScene(const common::GpuDevice& gpu, vk::Extent2D size) : extent(size), gpu_(&gpu) {
  const std::size_t pixels = std::size_t{size.width} * size.height;
  body.assign(pixels, 0);
  position.assign(pixels, glm::vec2(0));
  depth.assign(pixels, 0);
  hostDepth.assign(pixels, 0);
  camera.projection = perspective(0.8, static_cast<double>(size.width) / size.height, 0.1, true);
  camera.rotation = lookAlong(0, 0.5);
  light.sunDirection = glm::vec4(0, 1, 0, std::cos(pelagic::kSunAngularRadius));
  light.skyIrradiance = glm::vec4(3.14159265f * glm::vec3(sky[0], sky[1], sky[2]), 0);
  light.rayleighExtinction = glm::vec4(0, 0, 0, 8000);
  light.mieExtinction = glm::vec4(0, 0, 0, 1200);
  waves.layout.size = 64;
  waves.layout.count = 1;
  waves.layout.cascades[0] = {1000, 0.1, 0.14};
  createImages();
}

void SyntheticScene::createImages() {
  const auto image = [&](Format format, vk::Extent2D size, vk::ImageUsageFlags usage) {
    return common::createImage(*gpu_, format, size, usage | Usage::eTransferDst, "synthetic");
  };
  const vk::Extent2D patch{64, 64};
  gradientImage_ = image(Format::eR32G32B32A32Sfloat, patch, Usage::eSampled);
  momentsImage_ = image(Format::eR32G32B32A32Sfloat, patch, Usage::eSampled);
  foamImage_ = image(Format::eR32Sfloat, patch, Usage::eSampled);
  gradientView_ = arrayView(*gpu_, gradientImage_);
  momentsView_ = arrayView(*gpu_, momentsImage_);
  foamView_ = arrayView(*gpu_, foamImage_);
  radianceImage_ = image(Format::eR16G16B16A16Sfloat, patch, Usage::eSampled);
  cloudImage_ = image(Format::eR16G16B16A16Sfloat, patch, Usage::eSampled);
  environmentImage_ = image(Format::eR16G16B16A16Sfloat, patch, Usage::eSampled);
  positionImage_ = image(Format::eR32G32Sfloat, extent, Usage::eSampled);
  bodyImage_ = image(Format::eR8Uint, extent, Usage::eSampled);
  depthImage_ = image(Format::eD32Sfloat, extent, Usage::eSampled);
  hostColorImage_ = image(Format::eR16G16B16A16Sfloat, extent, Usage::eSampled);
  hostDepthImage_ = image(Format::eD32Sfloat, extent, Usage::eSampled);
  const vk::ImageUsageFlags written = Usage::eStorage | Usage::eTransferSrc;
  output_ = image(Format::eR32G32B32A32Sfloat, extent, written);
  normalImage_ = image(Format::eR32G32B32A32Sfloat, extent, written);
  varianceImage_ = image(Format::eR32G32Sfloat, extent, written);
  mergedImage_ = image(Format::eR32Sfloat, extent, written);
}

void SyntheticScene::upload() {
  copyInto(*gpu_, bodyImage_, body.data(), body.size());
  copyInto(*gpu_, positionImage_, position.data(), position.size() * sizeof(glm::vec2));
  copyInto(*gpu_, depthImage_, depth.data(), depth.size() * sizeof(float));
  copyInto(*gpu_, hostDepthImage_, hostDepth.data(), hostDepth.size() * sizeof(float));
  gpu_->run([&](vk::CommandBuffer commands) {
    clear(commands, gradientImage_, gradient);
    clear(commands, momentsImage_, moments);
    clear(commands, foamImage_, {foam, 0, 0, 0});
    clear(commands, radianceImage_, sky);
    clear(commands, environmentImage_, sky);
    clear(commands, cloudImage_, clouds.value_or(std::array<float, 4>{}));
    clear(commands, hostColorImage_, hostColor);
    for (const auto* image : {&output_, &normalImage_, &varianceImage_, &mergedImage_}) {
      clear(commands, *image, {kNan, kNan, kNan, kNan}, kFilled);
    }
  });
  lightBuffer_.reset();
  HostBuffer buffer = hostBuffer(*gpu_, &light, sizeof(light), vk::BufferUsageFlagBits::eUniformBuffer);
  lightBuffer_ = std::move(buffer.buffer);
  lightMemory_ = std::move(buffer.memory);
}

void SyntheticScene::fillMaps() {
  waves.gradient = mapOf(gradientImage_, *gradientView_);
  waves.moments = mapOf(momentsImage_, *momentsView_);
  waves.foam = mapOf(foamImage_, *foamView_);
  waves.displacement = waves.gradient;
  skyMaps_.radiance = mapOf(radianceImage_, *radianceImage_.view);
  skyMaps_.environment = mapOf(environmentImage_, *environmentImage_.view);
  if (realSky) skyMaps_ = realSky->maps();
  skyMaps_.planetRadius = planetRadius;
  if (clouds) skyMaps_.clouds = skyMaps_.cloudShadow = mapOf(cloudImage_, *cloudImage_.view);
  skyMaps_.light = *lightBuffer_;
  skyMaps_.lightSize = sizeof(light);
  water_.position = mapOf(positionImage_, *positionImage_.view);
  water_.body = mapOf(bodyImage_, *bodyImage_.view);
  water_.depth = mapOf(depthImage_, *depthImage_.view);
  water_.planetRadius = planetRadius;
}

float SyntheticScene::depthAt(float w) const {
  const glm::mat4& p = camera.projection;
  return p[2][2] / p[2][3] + p[3][2] / w;
}

void SyntheticScene::spread(float step) {
  for (std::size_t i = 0; i < position.size(); ++i) {
    position[i] = step * glm::vec2(static_cast<float>(i % extent.width), static_cast<float>(i / extent.width));
  }
}

void SyntheticScene::fillWater(float w) {
  std::fill(body.begin(), body.end(), std::uint8_t{1});
  std::fill(depth.begin(), depth.end(), depthAt(w));
}

void SyntheticScene::render(pelagic::Device& device) {
  upload();
  fillMaps();
  pelagic::CompositeTargets targets;
  targets.output = output_.host(kFilled, common::kTransferSource);
  if (withOutputs) {
    targets.normal = normalImage_.host(kFilled, common::kTransferSource);
    targets.slopeVariance = varianceImage_.host(kFilled, common::kTransferSource);
    targets.mergedDepth = mergedImage_.host(kFilled, common::kTransferSource);
  }
  targets.airBeforeHost = airBeforeHost;
  if (withHost) {
    targets.color = hostColorImage_.host(pelagic::kShaderRead, pelagic::kShaderRead);
    targets.depth = hostDepthImage_.host(pelagic::kShaderRead, pelagic::kShaderRead);
  }
  auto composite = pelagic::Composite::create(device);
  ASSERT_TRUE(composite) << composite.error().message;
  auto view = pelagic::CompositeView::create(*composite, waves, skyMaps_, water_, targets);
  ASSERT_TRUE(view) << view.error().message;
  const auto lit = composite->setLights(lights);
  ASSERT_TRUE(lit) << lit.error().message;
  gpu_->run([&](vk::CommandBuffer commands) { view->record(commands, waves, water_, camera, medium); });
  const auto read = [&](const common::OwnedImage& image) {
    return common::readFloats(*gpu_, *image.image, image.format, extent, common::kTransferSource);
  };
  radiance = read(output_);
  if (withOutputs) {
    normal = read(normalImage_);
    slopeVariance = read(varianceImage_);
    mergedDepth = read(mergedImage_);
  }
}

glm::vec3 SyntheticScene::radianceAt(std::uint32_t x, std::uint32_t y) const {
  const float* pixel = radiance.data() + 4 * (std::size_t{y} * extent.width + x);
  return {pixel[0], pixel[1], pixel[2]};
}

glm::dvec3 SyntheticScene::directionAt(std::uint32_t x, std::uint32_t y) const {
  const glm::dvec4 clip(2 * (x + 0.5) / extent.width - 1, 2 * (y + 0.5) / extent.height - 1, depthAt(1), 1);
  const glm::dvec4 view = glm::inverse(glm::dmat4(camera.projection)) * clip;
  return glm::normalize(glm::transpose(glm::dmat3(camera.rotation)) * (glm::dvec3(view) / view.w));
}

}  // namespace support
