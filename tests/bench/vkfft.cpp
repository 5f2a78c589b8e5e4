#include "vkfft.hpp"

#define VKFFT_BACKEND 0
#include <vkFFT.h>

namespace bench {

/// VkFFT keeps pointers to these: never moved.
struct VkFft::Impl {
  VkPhysicalDevice physicalDevice{};
  VkDevice device{};
  VkQueue queue{};
  VkCommandPool pool{};
  VkFence fence{};
  VkBuffer buffer{};
  VkDeviceMemory memory{};
  std::uint64_t bytes = 0;
  VkFFTApplication application{};
  bool planned = false;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (planned) deleteVkFFT(&application);
    vkDestroyBuffer(device, buffer, nullptr);
    vkFreeMemory(device, memory, nullptr);
    vkDestroyFence(device, fence, nullptr);
    vkDestroyCommandPool(device, pool, nullptr);
  }
};

VkFft::VkFft(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VkFft::VkFft(VkFft&&) noexcept = default;
VkFft& VkFft::operator=(VkFft&&) noexcept = default;
VkFft::~VkFft() = default;

tl::expected<VkFft, std::string> VkFft::create(const common::GpuDevice& gpu, std::uint32_t transforms,
                                               std::uint32_t size) {
  auto impl = std::make_unique<Impl>();
  impl->physicalDevice = gpu.physicalDevice();
  impl->device = gpu.device();
  impl->queue = gpu.queue();
  impl->bytes = std::uint64_t{transforms} * size * size * 2 * sizeof(float);
  const vk::Device device = gpu.device();
  impl->pool = device.createCommandPool({{}, gpu.queueFamily()});
  impl->fence = device.createFence({});
  impl->buffer = device.createBuffer({{},
                                      impl->bytes,
                                      vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferSrc |
                                          vk::BufferUsageFlagBits::eTransferDst});
  const auto needs = device.getBufferMemoryRequirements(impl->buffer);
  const auto types = gpu.physicalDevice().getMemoryProperties();
  std::uint32_t type = 0;
  const vk::MemoryPropertyFlags local = vk::MemoryPropertyFlagBits::eDeviceLocal;
  while (type < types.memoryTypeCount &&
         !((needs.memoryTypeBits >> type & 1u) && (types.memoryTypes[type].propertyFlags & local) == local)) {
    ++type;
  }
  impl->memory = device.allocateMemory({needs.size, type});
  device.bindBufferMemory(impl->buffer, impl->memory, 0);

  VkFFTConfiguration configuration{};
  configuration.FFTdim = 2;
  configuration.size[0] = size;
  configuration.size[1] = size;
  configuration.numberBatches = transforms;
  configuration.makeInversePlanOnly = 1;
  configuration.physicalDevice = &impl->physicalDevice;
  configuration.device = &impl->device;
  configuration.queue = &impl->queue;
  configuration.commandPool = &impl->pool;
  configuration.fence = &impl->fence;
  configuration.buffer = &impl->buffer;
  configuration.bufferSize = &impl->bytes;
  const VkFFTResult result = initializeVkFFT(&impl->application, configuration);
  if (result != VKFFT_SUCCESS) return tl::unexpected("VkFFT cannot plan: error " + std::to_string(result));
  impl->planned = true;
  return VkFft(std::move(impl));
}

void VkFft::record(vk::CommandBuffer commands) {
  VkCommandBuffer handle = commands;
  VkFFTLaunchParams launch{};
  launch.commandBuffer = &handle;
  launch.buffer = &impl_->buffer;
  VkFFTAppend(&impl_->application, 1, &launch);
}

vk::Buffer VkFft::buffer() const { return impl_->buffer; }
vk::DeviceSize VkFft::bytes() const { return impl_->bytes; }

}  // namespace bench
