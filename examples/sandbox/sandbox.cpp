/// pelagic-sandbox: a window onto the ocean, with every parameter at hand.
#include <imgui.h>

#include <chrono>
#include <common/failure.hpp>
#include <common/image_file.hpp>
#include <common/program.hpp>

#include "fly_camera.hpp"
#include "overlay.hpp"
#include "panel.hpp"
#include "picture.hpp"
#include "swapchain.hpp"

namespace {

constexpr std::uint32_t kFramesInFlight = 2;

struct Options {
  common::Scene scene;
  VkExtent2D extent{1280, 720};
  std::uint64_t frames = 0;  ///< 0: until the window is closed.
  std::string screenshot;
};

/// What one frame needs until the device has finished it.
struct Frame {
  vk::UniqueCommandPool pool;
  vk::CommandBuffer commands;
  vk::UniqueSemaphore acquired;
  vk::UniqueFence done;
  std::optional<pelagic::Timings> timings;
  bool used = false;
};

class Sandbox {
 public:
  Sandbox(common::Program& program, const Options& options)
      : options_(options),
        scene_(options.scene),
        window_(options.extent, "Pelagic"),
        gpu_(openDevice(program, window_)),
        device_(common::unwrap(pelagic::Device::create(gpu_.info()))),
        surface_(window_.createSurface(gpu_.instance())),
        overlay_(gpu_, window_, kFramesInFlight),
        camera_(options.scene.view) {
    clock_.time = scene_.time;
    for (Frame& frame : frames_) createFrame(frame);
    resize();
    rebuild();
  }
  ~Sandbox() { waitIdle(); }
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  void run() {
    auto last = std::chrono::steady_clock::now();
    for (std::uint64_t n = 0; !window_.closing() && (options_.frames == 0 || n < options_.frames); ++n) {
      glfwPollEvents();
      const auto now = std::chrono::steady_clock::now();
      // Counted frames are a sixtieth of a second apart, so that a screenshot can be repeated.
      const double seconds = options_.frames > 0 ? 1.0 / 60 : std::chrono::duration<double>(now - last).count();
      last = now;
      clock_.time += seconds * clock_.speed;
      steer(seconds);
      draw(frames_[n % kFramesInFlight]);
    }
  }

  void writeScreenshot(const std::filesystem::path& path) {
    waitIdle();
    const auto pixels = common::readImage(gpu_, picture_->image(), sandbox::Picture::kFormat, picture_->extent(),
                                          common::kTransferSource);
    common::writePng(path, picture_->extent().width, picture_->extent().height, pixels);
  }

 private:
  static common::GpuDevice openDevice(common::Program& program, const sandbox::Window& window) {
    common::GpuDeviceOptions options;
    options.instanceExtensions = window.instanceExtensions();
    options.deviceExtensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
    return program.openDevice(options);
  }

  void waitIdle() const { gpu_.device().waitIdle(); }

  void createFrame(Frame& frame) {
    frame.pool = gpu_.device().createCommandPoolUnique({vk::CommandPoolCreateFlagBits::eTransient, gpu_.queueFamily()});
    frame.commands = gpu_.device().allocateCommandBuffers({*frame.pool, vk::CommandBufferLevel::ePrimary, 1}).front();
    frame.acquired = gpu_.device().createSemaphoreUnique({});
    frame.done = gpu_.device().createFenceUnique({vk::FenceCreateFlagBits::eSignaled});
    frame.timings = common::unwrap(pelagic::Timings::create(device_));
  }

  /// Images of the window's present size.
  void resize() {
    while (window_.extent().width == 0 && !window_.closing()) glfwWaitEvents();  // minimised
    waitIdle();
    picture_.reset();
    swapchain_.reset();
    swapchain_.emplace(gpu_, *surface_, window_.extent());
    picture_.emplace(gpu_, device_, swapchain_->extent());
    overlay_.bind(*picture_);
    if (ocean_) picture_->bind(*ocean_);
  }

  /// A simulation with the scene's layout.
  void rebuild() {
    waitIdle();
    picture_->release();
    ocean_.reset();
    ocean_ = common::unwrap(pelagic::Ocean::create(device_, common::oceanInfo(scene_)));
    picture_->bind(*ocean_);
  }

  void steer(double seconds) {
    const ImGuiIO& io = ImGui::GetIO();
    camera_.move(window_, seconds, !io.WantCaptureKeyboard, !io.WantCaptureMouse);
    overlay_.begin();
    const sandbox::Changes changes = sandbox::drawPanel(scene_, clock_, camera_.fov, ocean_->waves().report(), passes_);
    outgrown_ |= changes.layout;
    if (changes.sea) {
      common::unwrap(
          ocean_->setSea(scene_.sea.state, {clock_.time, clock_.speed > 0 ? clock_.change * clock_.speed : 0}));
      outgrown_ |= outgrown();
    }
    if (changes.sky || changes.sea) common::unwrap(ocean_->setSky(common::skyState(scene_)));
    if (changes.water) common::unwrap(ocean_->setMedium(scene_.medium));
    if (outgrown_ && !ImGui::IsAnyItemActive()) {  // not while a slider moves
      rebuild();
      outgrown_ = false;
    }
  }

  /// Does the sea want patches of quite another length than it has?
  bool outgrown() const {
    const common::SeaSettings& sea = scene_.sea;
    const double wanted =
        common::unwrap(pelagic::waveLayout(sea.state, sea.cascades, sea.size, sea.span)).cascades[0].length;
    const double present = ocean_->waves().maps().layout.cascades[0].length;
    return wanted > 1.2 * present || wanted < 0.5 * present;
  }

  void keepTimings(Frame& frame) {
    const auto measured = common::unwrap(frame.timings->read());
    passes_.clear();
    for (const auto& pass : measured) passes_.push_back({pass.name, pass.milliseconds});
  }

  void draw(Frame& frame) {
    constexpr std::uint64_t kTimeout = 600'000'000'000;  // 10 min in ns, as GpuDevice::run
    if (gpu_.device().waitForFences(*frame.done, VK_TRUE, kTimeout) != vk::Result::eSuccess) {
      throw std::runtime_error("the device did not finish within ten minutes");
    }
    if (frame.used) keepTimings(frame);
    auto index = swapchain_->acquire(*frame.acquired);
    while (!index) {
      resize();
      index = swapchain_->acquire(*frame.acquired);
    }
    gpu_.device().resetFences(*frame.done);
    gpu_.device().resetCommandPool(*frame.pool);
    record(frame, *index);
    const vk::PipelineStageFlags wait = vk::PipelineStageFlagBits::eTransfer;
    const vk::Semaphore drawn = swapchain_->drawn(*index);
    gpu_.queue().submit(vk::SubmitInfo(*frame.acquired, wait, frame.commands, drawn), *frame.done);
    frame.used = true;
    const vk::Extent2D extent = window_.extent();
    if (!swapchain_->present(gpu_.queue(), *index) || extent != picture_->extent()) resize();
  }

  void record(Frame& frame, std::uint32_t index) {
    const double aspect = static_cast<double>(picture_->extent().width) / picture_->extent().height;
    frame.commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    frame.timings->reset(frame.commands);
    ocean_->record(frame.commands, clock_.time, &*frame.timings);
    picture_->record(frame.commands, camera_.camera(aspect), scene_, *frame.timings);
    overlay_.record(frame.commands);
    swapchain_->recordCopy(frame.commands, picture_->image(), index);
    frame.commands.end();
  }

  const Options& options_;
  common::Scene scene_;
  sandbox::Window window_;
  common::GpuDevice gpu_;
  pelagic::Device device_;
  vk::UniqueSurfaceKHR surface_;
  sandbox::Overlay overlay_;
  sandbox::FlyCamera camera_;
  sandbox::Clock clock_;
  std::array<Frame, kFramesInFlight> frames_;
  std::optional<sandbox::Swapchain> swapchain_;
  std::optional<pelagic::Ocean> ocean_;
  std::optional<sandbox::Picture> picture_;
  std::vector<sandbox::PassTime> passes_;
  bool outgrown_ = false;
};

common::Fields windowFields(Options& options) {
  using Texts = std::vector<std::string>;
  return {common::extentField("resolution", "Size of the window", options.extent),
          common::wholeField("frames", "N", "Draw this many frames and leave", 1, 1000000,
                             [&options](std::uint64_t n) { options.frames = n; }),
          {"screenshot", "FILE.png", "Write the last frame, only with --frames",
           [&options](const std::string&, const Texts& texts) { options.screenshot = texts.front(); }}};
}

}  // namespace

int main(int argc, char** argv) {
  common::Program program("pelagic-sandbox", "A window onto the ocean, with every parameter at hand.");
  Options options;
  common::addSceneOptions(program, options.scene);
  program.add(windowFields(options), "Window");
  return program.run(argc, argv, [&](common::OutputSet& outputs) {
    if (!options.screenshot.empty() && options.frames == 0) {
      common::refuse("--screenshot", options.screenshot, "only with --frames");
    }
    std::filesystem::path file;
    if (!options.screenshot.empty()) file = outputs.add("--screenshot", options.screenshot);
    Sandbox sandbox(program, options);
    sandbox.run();
    if (!options.screenshot.empty()) sandbox.writeScreenshot(file);
  });
}
