#include "overlay.hpp"

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

#include "picture.hpp"

namespace sandbox {
namespace {

/// Dear ImGui 1.86 knows render passes only. Keeps the picture, leaves it in TRANSFER_SRC layout.
vk::UniqueRenderPass createPass(vk::Device device) {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::AttachmentDescription color({}, Picture::kFormat, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad,
                                        vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                        vk::AttachmentStoreOp::eDontCare, vk::ImageLayout::eColorAttachmentOptimal,
                                        vk::ImageLayout::eTransferSrcOptimal);
  const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
  const vk::AccessFlags write = Access::eColorAttachmentRead | Access::eColorAttachmentWrite;
  const vk::SubpassDependency dependencies[] = {
      {VK_SUBPASS_EXTERNAL, 0, Stage::eColorAttachmentOutput, Stage::eColorAttachmentOutput, write, write},
      {0, VK_SUBPASS_EXTERNAL, Stage::eColorAttachmentOutput, Stage::eTransfer, Access::eColorAttachmentWrite,
       Access::eTransferRead},
  };
  return device.createRenderPassUnique({{}, color, subpass, dependencies});
}

void check(VkResult result) {
  if (result < 0) throw std::runtime_error("Dear ImGui: " + vk::to_string(vk::Result(result)));
}

}  // namespace

Overlay::Overlay(const common::GpuDevice& gpu, const Window& window, std::uint32_t framesInFlight)
    : gpu_(&gpu), pass_(createPass(gpu.device())) {
  const vk::DescriptorPoolSize size(vk::DescriptorType::eCombinedImageSampler, 1);
  pool_ = gpu.device().createDescriptorPoolUnique({vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size});
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = gpu.instance();
  info.PhysicalDevice = gpu.physicalDevice();
  info.Device = gpu.device();
  info.QueueFamily = gpu.queueFamily();
  info.Queue = gpu.queue();
  info.DescriptorPool = *pool_;
  info.MinImageCount = framesInFlight;
  info.ImageCount = framesInFlight;
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = check;
  ImGui_ImplVulkan_Init(&info, *pass_);
  gpu.run([](vk::CommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
}

Overlay::~Overlay() {
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Overlay::bind(const Picture& picture) {
  extent_ = picture.extent();
  const vk::ImageView view = picture.view();
  framebuffer_ = gpu_->device().createFramebufferUnique({{}, *pass_, view, extent_.width, extent_.height, 1});
}

void Overlay::begin() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Overlay::record(vk::CommandBuffer commands) {
  ImGui::Render();
  commands.beginRenderPass({*pass_, *framebuffer_, {{0, 0}, extent_}}, vk::SubpassContents::eInline);
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
  commands.endRenderPass();
}

}  // namespace sandbox
