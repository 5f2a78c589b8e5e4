/// A Vulkan device of the example programs and tests: headless or for a window. The library never makes one.
#pragma once

#include <functional>
#include <memory>
#include <pelagic/device.hpp>
#include <pelagic/image.hpp>
#include <string>
#include <string_view>
#include <vector>
#include <vulkan/vulkan.hpp>

namespace common {

struct GpuDeviceOptions {
  std::string select;     ///< Index or part of the name; empty: a GPU if there is one, else a software device.
  bool validate = false;  ///< Core, synchronization and best-practices validation.
  std::vector<const char*> instanceExtensions;
  std::vector<const char*> deviceExtensions;
};

/// Messages of the validation layer, without the ids on the allow-list.
struct ValidationLog {
  std::vector<std::string> messages;
};

struct GpuDeviceError {
  bool noMatch = false;  ///< There are devices, but none that GpuDeviceOptions::select names.
  std::string message;   ///< One sentence.
};

class GpuDevice {
 public:
  static tl::expected<GpuDevice, GpuDeviceError> create(const GpuDeviceOptions& options);

  vk::Instance instance() const { return *instance_; }
  vk::PhysicalDevice physicalDevice() const { return physicalDevice_; }
  vk::Device device() const { return *device_; }
  vk::Queue queue() const { return queue_; }
  std::uint32_t queueFamily() const { return queueFamily_; }
  std::string name() const;
  pelagic::DeviceInfo info() const;
  const std::vector<std::string>& validationMessages() const { return log_->messages; }
  /// Outlives the device, so that messages of its destruction are found too.
  std::shared_ptr<const ValidationLog> log() const { return log_; }

  /// What validation messages call an image.
  void setName(vk::Image image, const std::string& name) const;
  /// Records with `record`, submits and waits.
  void run(const std::function<void(vk::CommandBuffer)>& record) const;

 private:
  std::shared_ptr<ValidationLog> log_ = std::make_shared<ValidationLog>();
  vk::UniqueInstance instance_;
  std::unique_ptr<vk::DispatchLoaderDynamic> dispatch_;  // the messenger points to it
  vk::UniqueHandle<vk::DebugUtilsMessengerEXT, vk::DispatchLoaderDynamic> messenger_;
  vk::PhysicalDevice physicalDevice_;
  vk::UniqueDevice device_;
  vk::Queue queue_;
  std::uint32_t queueFamily_ = 0;
  vk::UniqueCommandPool pool_;
};

/// An image with memory and a view, owned by the program.
struct OwnedImage {
  vk::UniqueDeviceMemory memory;
  vk::UniqueImage image;
  vk::UniqueImageView view;
  vk::Format format{};
  vk::Extent2D extent{};

  OwnedImage() = default;
  OwnedImage(OwnedImage&&) = default;
  /// Memory goes last, as the image is bound to it.
  OwnedImage& operator=(OwnedImage&& other) noexcept;
  ~OwnedImage() = default;

  /// As Pelagic takes it.
  pelagic::HostImage host(const pelagic::ImageState& before, const pelagic::ImageState& after) const;
};
OwnedImage createImage(const GpuDevice& gpu, vk::Format format, vk::Extent2D extent, vk::ImageUsageFlags usage,
                       const std::string& name);

/// Bytes of one mip and layer, tightly packed. The image must be in `state`; it is left in the same.
std::vector<std::byte> readImage(const GpuDevice& gpu, vk::Image image, vk::Format format, vk::Extent2D extent,
                                 const pelagic::ImageState& state, std::uint32_t mip = 0, std::uint32_t layer = 0);
/// The same as floats, whatever the (16- or 32-bit float, or 8-bit unsigned) format, channels interleaved.
std::vector<float> readFloats(const GpuDevice& gpu, vk::Image image, vk::Format format, vk::Extent2D extent,
                              const pelagic::ImageState& state, std::uint32_t mip = 0, std::uint32_t layer = 0);
std::vector<float> readFloats(const GpuDevice& gpu, const pelagic::MapView& map, std::uint32_t mip = 0,
                              std::uint32_t layer = 0);
/// Bytes of a buffer that the device has finished writing.
std::vector<std::byte> readBuffer(const GpuDevice& gpu, vk::Buffer buffer, vk::DeviceSize size);

/// States that programs use.
inline constexpr pelagic::ImageState kUndefined{};
inline constexpr pelagic::ImageState kTransferSource{
    VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

}  // namespace common
