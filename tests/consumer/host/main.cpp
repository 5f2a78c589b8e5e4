/// The host around README's lines: device, images and read-back are its own business. Writes ocean.ppm.
#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>
#include <vulkan/vulkan.hpp>

#include "snippet_includes.inc"

namespace {

struct Image {
  vk::UniqueDeviceMemory memory;
  vk::UniqueImage image;
  vk::UniqueImageView view;
};

Image createImage(vk::Device device, vk::Format format, VkExtent2D extent, vk::ImageUsageFlags usage) {
  Image result;
  const vk::Extent3D size(extent.width, extent.height, 1);
  result.image = device.createImageUnique(
      {{}, vk::ImageType::e2D, format, size, 1, 1, vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, usage});
  const auto needs = device.getImageMemoryRequirements(*result.image);
  const auto type = static_cast<std::uint32_t>(__builtin_ctz(needs.memoryTypeBits));
  result.memory = device.allocateMemoryUnique({needs.size, type});
  device.bindImageMemory(*result.image, *result.memory, 0);
  const vk::ImageSubresourceRange range(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
  result.view = device.createImageViewUnique({{}, *result.image, vk::ImageViewType::e2D, format, {}, range});
  return result;
}

}  // namespace

int main() {
  const vk::ApplicationInfo application("host", 0, nullptr, 0, VK_API_VERSION_1_3);
  const vk::UniqueInstance uniqueInstance = vk::createInstanceUnique({{}, &application});
  const VkInstance instance = *uniqueInstance;
  const vk::PhysicalDevice physicalDevice = uniqueInstance->enumeratePhysicalDevices().front();
  const std::uint32_t queueFamily = 0;  // has graphics and compute wherever this test runs
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queueInfo({}, queueFamily, 1, &priority);
  const pelagic::RequiredFeatures features;
  vk::DeviceCreateInfo deviceInfo({}, queueInfo);
  deviceInfo.pNext = &features.features;
  const vk::UniqueDevice uniqueDevice = physicalDevice.createDeviceUnique(deviceInfo);
  const vk::Device device = *uniqueDevice;

  const VkExtent2D extent{640, 360};
  using Usage = vk::ImageUsageFlagBits;
  const Image hdr = createImage(device, vk::Format::eR16G16B16A16Sfloat, extent, Usage::eStorage | Usage::eSampled);
  const Image picture = createImage(device, vk::Format::eR8G8B8A8Unorm, extent, Usage::eStorage | Usage::eTransferSrc);
  const VkImage hdrImage = *hdr.image, pictureImage = *picture.image;
  const VkImageView hdrView = *hdr.view, pictureView = *picture.view;
  const vk::DeviceSize bytes = 4 * extent.width * extent.height;
  const vk::UniqueBuffer pixels = device.createBufferUnique({{}, bytes, vk::BufferUsageFlagBits::eTransferDst});
  const auto types = physicalDevice.getMemoryProperties();
  std::uint32_t type = 0;
  while (!(types.memoryTypes[type].propertyFlags & vk::MemoryPropertyFlagBits::eHostCoherent)) ++type;
  const vk::UniqueDeviceMemory pixelMemory =
      device.allocateMemoryUnique({device.getBufferMemoryRequirements(*pixels).size, type});
  device.bindBufferMemory(*pixels, *pixelMemory, 0);

  const vk::UniqueCommandPool pool = device.createCommandPoolUnique({{}, queueFamily});
  const auto buffers = device.allocateCommandBuffersUnique({*pool, vk::CommandBufferLevel::ePrimary, 1});
  const vk::CommandBuffer commands = *buffers.front();
  commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  const double time = 12;

#include "snippet.inc"

  const vk::BufferImageCopy copy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                 {extent.width, extent.height, 1});
  commands.copyImageToBuffer(pictureImage, vk::ImageLayout::eTransferSrcOptimal, *pixels, copy);
  commands.end();
  const vk::Queue queue = device.getQueue(queueFamily, 0);
  queue.submit(vk::SubmitInfo({}, {}, commands));
  queue.waitIdle();

  const auto* rgba = static_cast<const unsigned char*>(device.mapMemory(*pixelMemory, 0, bytes));
  std::ofstream file("ocean.ppm", std::ios::binary);
  file << "P6\n" << extent.width << ' ' << extent.height << "\n255\n";
  double upper = 0, lower = 0;
  for (std::size_t i = 0; i < bytes; i += 4) {
    file.write(reinterpret_cast<const char*>(rgba + i), 3);
    (i < bytes / 2 ? upper : lower) += rgba[i] + rgba[i + 1] + rgba[i + 2];
  }
  std::cout << "mean of the sky " << upper / (1.5 * extent.width * extent.height) << ", of the sea "
            << lower / (1.5 * extent.width * extent.height) << "; height " << height << " m, moving at "
            << glm::length(velocity) << " m/s\n";
  const bool moving = std::abs(height) > 0 && std::abs(height) < 10 && glm::length(velocity) > 0;
  return file && upper > lower && lower > 0 && moving ? 0 : 1;  // a sky above a darker sea
}
