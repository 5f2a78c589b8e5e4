#include "surface_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

namespace surface_scene {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Sfloat;

std::uint32_t hostMemoryType(const common::GpuDevice& gpu, std::uint32_t bits) {
  const auto flags = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  const auto properties = gpu.physicalDevice().getMemoryProperties();
  for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i) {
    if ((bits >> i & 1u) && (properties.memoryTypes[i].propertyFlags & flags) == flags) return i;
  }
  throw std::runtime_error("the device has no host-visible memory");
}

/// Mip 0 samples the wave, every further mip is the box filter of the one before.
std::vector<std::vector<glm::vec4>> mipChain(const Wave& wave) {
  std::vector<std::vector<glm::vec4>> mips(1);
  for (std::uint32_t row = 0; row < kSize; ++row) {
    for (std::uint32_t column = 0; column < kSize; ++column) {
      mips[0].emplace_back(glm::dvec4(wave.at(kPatch / kSize * glm::dvec2(column, row)), 1));
    }
  }
  for (std::uint32_t side = kSize / 2; side > 0; side /= 2) {
    const std::vector<glm::vec4>& fine = mips.back();
    std::vector<glm::vec4> coarse;
    for (std::uint32_t row = 0; row < side; ++row) {
      for (std::uint32_t column = 0; column < side; ++column) {
        const std::size_t at = 2 * row * (2 * side) + 2 * column;
        coarse.push_back(0.25f * (fine[at] + fine[at + 1] + fine[at + 2 * side] + fine[at + 2 * side + 1]));
      }
    }
    mips.push_back(std::move(coarse));
  }
  return mips;
}

}  // namespace

glm::dvec3 Wave::at(const glm::dvec2& point) const {
  const glm::dvec2 k = kTurn / kPatch * glm::dvec2(mode);
  const double angle = glm::dot(k, point) + phase;
  // Toward the crests: D = -choppiness * amplitude * k/|k| * sin.
  const glm::dvec2 sideways = -choppiness * amplitude * std::sin(angle) * k / glm::length(k);
  return {sideways.x, amplitude * std::cos(angle), sideways.y};
}

double Wave::heightBelow(const glm::dvec2& point) const {
  glm::dvec2 source = point;
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 d = at(source);
    source = point - glm::dvec2(d.x, d.z);
  }
  return at(source).y;
}

SyntheticSea::SyntheticSea(const common::GpuDevice& gpu, const Wave& now, const Wave& before) {
  maps_.displacement = upload(gpu, now, now_);
  maps_.previousDisplacement = upload(gpu, before, before_);
  maps_.displacementPair = {maps_.previousDisplacement, maps_.displacement};
  maps_.layout.size = kSize;
  maps_.layout.count = 1;
  maps_.layout.cascades[0].length = kPatch;
  maps_.elevationDeviation = now.amplitude / std::numbers::sqrt2;
  maps_.horizontalDeviation = now.choppiness * maps_.elevationDeviation;
  maps_.choppiness = now.choppiness;
}

pelagic::MapView SyntheticSea::upload(const common::GpuDevice& gpu, const Wave& wave, Map& map) {
  const auto mips = mipChain(wave);
  const auto levels = static_cast<std::uint32_t>(mips.size());
  const vk::Device device = gpu.device();
  map.image = device.createImageUnique({{},
                                        vk::ImageType::e2D,
                                        kFormat,
                                        {kSize, kSize, 1},
                                        levels,
                                        1,
                                        vk::SampleCountFlagBits::e1,
                                        vk::ImageTiling::eOptimal,
                                        vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst});
  const auto needs = device.getImageMemoryRequirements(*map.image);
  map.memory =
      device.allocateMemoryUnique({needs.size, static_cast<std::uint32_t>(std::countr_zero(needs.memoryTypeBits))});
  device.bindImageMemory(*map.image, *map.memory, 0);
  const vk::ImageSubresourceRange range(vk::ImageAspectFlagBits::eColor, 0, levels, 0, 1);
  map.view = device.createImageViewUnique({{}, *map.image, vk::ImageViewType::e2DArray, kFormat, {}, range});

  std::vector<vk::BufferImageCopy> copies;
  std::vector<glm::vec4> texels;
  for (std::uint32_t level = 0; level < levels; ++level) {
    copies.emplace_back(texels.size() * sizeof(glm::vec4), 0, 0,
                        vk::ImageSubresourceLayers(vk::ImageAspectFlagBits::eColor, level, 0, 1), vk::Offset3D(),
                        vk::Extent3D(kSize >> level, kSize >> level, 1));
    texels.insert(texels.end(), mips[level].begin(), mips[level].end());
  }
  const vk::DeviceSize bytes = texels.size() * sizeof(glm::vec4);
  vk::UniqueDeviceMemory memory;  // outlives its buffer
  const auto buffer = device.createBufferUnique({{}, bytes, vk::BufferUsageFlagBits::eTransferSrc});
  const auto bufferNeeds = device.getBufferMemoryRequirements(*buffer);
  memory = device.allocateMemoryUnique({bufferNeeds.size, hostMemoryType(gpu, bufferNeeds.memoryTypeBits)});
  device.bindBufferMemory(*buffer, *memory, 0);
  std::memcpy(device.mapMemory(*memory, 0, VK_WHOLE_SIZE), texels.data(), bytes);
  device.unmapMemory(*memory);
  gpu.run([&](vk::CommandBuffer commands) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const vk::ImageMemoryBarrier2 in(Stage::eNone, Access::eNone, Stage::eAllTransfer, Access::eTransferWrite,
                                     vk::ImageLayout::eUndefined, vk::ImageLayout::eTransferDstOptimal,
                                     VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *map.image, range);
    commands.pipelineBarrier2({{}, {}, {}, in});
    commands.copyBufferToImage(*buffer, *map.image, vk::ImageLayout::eTransferDstOptimal, copies);
    const vk::ImageMemoryBarrier2 out(
        Stage::eAllTransfer, Access::eTransferWrite, vk::PipelineStageFlags2(pelagic::kShaderRead.stages),
        vk::AccessFlags2(pelagic::kShaderRead.access), vk::ImageLayout::eTransferDstOptimal,
        vk::ImageLayout(pelagic::kShaderRead.layout), VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *map.image,
        range);
    commands.pipelineBarrier2({{}, {}, {}, out});
  });
  return {*map.image, *map.view, static_cast<VkFormat>(kFormat), {kSize, kSize}, 1, levels};
}

pelagic::Camera camera(const glm::dvec3& position, double yaw, double pitch, double roll, const Lens& lens,
                       VkExtent2D extent) {
  const glm::dvec3 forward(std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw));
  const glm::dvec3 level(std::cos(yaw), 0, std::sin(yaw));
  const glm::dvec3 upright = glm::cross(level, forward);
  const glm::dvec3 right = std::cos(roll) * level + std::sin(roll) * upright;
  const glm::dvec3 up = glm::cross(right, forward);
  pelagic::Camera result;
  result.position = position;
  result.rotation = glm::mat3(glm::transpose(glm::dmat3(right, up, -forward)));
  const double focal = 1 / std::tan(lens.fov / 2);
  const double aspect = double(extent.width) / extent.height;
  glm::dmat4 p(0);
  p[0][0] = focal / aspect;
  p[1][1] = lens.flipped ? -focal : focal;
  p[2][0] = lens.shift.x;
  p[2][1] = lens.shift.y;
  p[2][3] = -1;
  const double near = lens.near;
  const double far = lens.far;
  if (lens.reversed) {
    p[2][2] = far > 0 ? near / (far - near) : 0;
    p[3][2] = far > 0 ? near * far / (far - near) : near;
  } else {
    p[2][2] = far > 0 ? -far / (far - near) : -1;
    p[3][2] = far > 0 ? -near * far / (far - near) : -near;
  }
  result.projection = glm::mat4(p);
  result.reversedDepth = lens.reversed;
  return result;
}

glm::dvec3 ray(const pelagic::Camera& camera, const glm::dvec2& uv) {
  const glm::dmat4 p(camera.projection);
  // clip = p v with v = (x, y, -1): two linear equations.
  const glm::dvec2 ndc = 2.0 * uv - 1.0;
  const glm::dvec3 view((ndc.x + p[2][0]) / p[0][0], (ndc.y + p[2][1]) / p[1][1], -1);
  return glm::transpose(glm::dmat3(camera.rotation)) * view;
}

double hitSphere(const pelagic::Camera& camera, const glm::dvec3& direction, double level, double planetRadius) {
  const double radius = planetRadius + level;
  const glm::dvec3 fromCentre(0, planetRadius + camera.position.y, 0);
  const double above = camera.position.y - level;
  const double a = glm::dot(direction, direction);
  const double b = glm::dot(direction, fromCentre);
  const double c = above * (radius + fromCentre.y);
  const double root = b * b - a * c;
  if (root < 0) return -1;
  // From outside the nearer, from inside the farther hit.
  if (above >= 0) return b < 0 ? c / (-b + std::sqrt(root)) : -1;
  return (-b + std::sqrt(root)) / a;
}

double seaLevel(const glm::dvec2& relative) {
  const double r2 = glm::dot(relative, relative);
  return -r2 / (pelagic::kEarthRadius + std::sqrt(pelagic::kEarthRadius * pelagic::kEarthRadius - r2));
}

glm::dvec3 project(const pelagic::Camera& camera, const glm::dvec3& relative) {
  const glm::dvec4 clip = glm::dmat4(camera.projection) * glm::dvec4(glm::dmat3(camera.rotation) * relative, 1);
  return {0.5 * clip.x / clip.w + 0.5, 0.5 * clip.y / clip.w + 0.5, clip.z / clip.w};
}

Water read(const common::GpuDevice& gpu, const pelagic::WaterBuffer& buffer) {
  return {buffer.body.extent, common::readFloats(gpu, buffer.position),
          buffer.motion.view == VK_NULL_HANDLE ? std::vector<float>() : common::readFloats(gpu, buffer.motion),
          common::readFloats(gpu, buffer.body), common::readFloats(gpu, buffer.depth)};
}

}  // namespace surface_scene
