/// The composite stage: deferred shading of sea and sky over the host's picture, in compute.
#pragma once

#include <optional>
#include <pelagic/sky.hpp>
#include <pelagic/surface.hpp>
#include <span>
#include <string_view>

namespace pelagic {

/// How the colour of the water is found: from the medium, or by one of three laws that artists use in its place.
/// Their colours are what a white surface's would be, dimensionless, 0 … 1: radiance below the surface is colour/pi
/// times the irradiance that enters, so that they are seen as given under the noon sun and fade to black as it sets.
struct WaterLook {
  enum class Law {
    medium,       ///< As WaterMedium's coefficients say; the colours here are not used.
    deepShallow,  ///< Between `deep` and `shallow` by `shallowness`, the same everywhere.
    thickness,    ///< `deep`; thin crests against the light are as opaque as tintOpacity in physics/optics.glsl says.
    viewAngle     ///< From `deep`, seen straight on, to `shallow`, seen along the wave's face; linear in the angle.
  };
  Law law = Law::medium;
  glm::vec3 deep{0.004f, 0.022f, 0.055f};
  glm::vec3 shallow{0.010f, 0.120f, 0.140f};
  float shallowness = 0.3f;    ///< Of the law deepShallow [1], 0 … 1.
  float leastOpacity = 0.15f;  ///< Of the thinnest water, law thickness [1], 0 … 1.
  float opaqueDepth = 6.0f;    ///< Water as thick as this shows nothing behind it, law thickness [m], 0.01 … 1000.
  /// Factor on the sky's reflected light, 1 … 4, under every law: 1 is Fresnel's; more lifts bright water over dark.
  float contrast = 1.0f;
  bool operator==(const WaterLook&) const = default;
};
/// Looks by name: "natural", which is the default, "turquoise" (law deepShallow), "glassy" (thickness) and "painted"
/// (viewAngle, with contrast).
struct NamedWaterLook {
  std::string_view name;
  WaterLook look;
};
std::span<const NamedWaterLook> waterLooks() noexcept;

/// The water below the surface and what floats on it, per channel at about 680, 550 and 440 nm. Defaults: the open
/// ocean between Jerlov's types IB and II: pure sea water with a little yellow substance and particles.
struct WaterMedium {
  glm::vec3 absorption{0.470f, 0.0680f, 0.0450f};    ///< a [1/m], 1e-4 … 100.
  glm::vec3 backscatter{0.0017f, 0.0022f, 0.0030f};  ///< b_b [1/m], 0 … 100.
  /// Standard deviation of the slope variance of short waves over its mean [1], 0 … 0.5: films of oil gather into
  /// slicks, where there are hardly any ripples, and stay until the wind stirs them in at about 7 m/s (Romano 1996);
  /// gusts roughen the sea between. In bands along the wind, 4 m to 1 km wide, which stay where they are, but for
  /// a change of the sea that turns the wind: halfway they turn at once. In the light alone; in the mean over the sea
  /// its variance is the same. Short are the waves of cascades with patches of less than 24 m and those that none
  /// holds: of less than 0.4 to 1.7 m in layouts of 4 or more cascades of 256². 0: the sea is as rough everywhere.
  double slicks = 0;
  WaterLook look;
};
Result<void> validate(const WaterMedium& medium);

/// A light of the host: a ball that shines evenly, small like a lamp or as large as a lit sail, or a rectangle like a
/// window or a screen, which shines on one side, as bright from wherever it is seen (Lambert's law). It glitters on the
/// sea, lights the water from within and the foam. The light itself, and what else it shines on, are the host's to
/// draw. Nothing but the planet stands in its way: behind the horizon it lights no water, but neither waves nor the
/// host's own objects cast shadows, and the air between it and the sea takes nothing.
struct HostLight {
  /// Of its centre in the world [m]; |x|, |z| <= 1e9. y, 0 … 1e5, is its height over the still sea below it, which the
  /// planet's curve lowers with the distance from the camera.
  glm::dvec3 position{0, 10, 0};
  /// Of a ball [m], 1e-3 … 1e4; seen from the water under more than 0.1 rad, its glint is too wide.
  double radius = 0.1;
  /// Radiant intensity: its irradiance at the distance r, on a plane facing it, is intensity/r^2 [units of
  /// pelagic/sky.hpp times m^2], 0 … 1e12 each; that of a rectangle straight before it, from afar. Where 1.28e5 lx are
  /// the sun's irradiance above the air, 1000 cd are 0.0078. Like all light it is multiplied by twilightGain().
  glm::vec3 intensity{0.01f};
  /// In the level frame of its place. Both 0: a ball. Else half the sides of a rectangle, at right angles, each 1e-3 …
  /// 1e4 long [m]: it shines toward cross(halfWidth, halfHeight), its corners lie at y >= 0 and `radius` is not used.
  /// Its glint is too wide where a half is seen under more than 0.075 rad.
  glm::dvec3 halfWidth{0};
  glm::dvec3 halfHeight{0};
};
/// As many as there may be.
inline constexpr std::size_t kMostHostLights = shader::kMostHostLights;
Result<void> validate(std::span<const HostLight> lights);

/// What the host's picture needs from the sea, bound once per view. All images have the view's extent.
struct CompositeTargets {
  /// HDR out, rgba16f or rgba32f with STORAGE usage. `before.layout` may be UNDEFINED: every pixel is written.
  HostImage output;
  /// Host's scene: colour (linear, sampled) and depth (d32f, sampled, in the camera's convention). Both or neither.
  /// An object nearer than the water hides it and one behind it is hidden; where depth is the far value there is sky.
  std::optional<HostImage> color;
  std::optional<HostImage> depth;
  /// Whether the host's objects are seen through the air and the clouds that lie before them, as the water is; false
  /// for a host whose colour has its own.
  bool airBeforeHost = true;
  /// Optional outputs, STORAGE usage, every pixel written:
  /// rgba16f or rgba32f: water normal (world, unit), foam in A. 0 without water. Of the mean slope in the pixel, before
  /// shading moves it to where the waves that the sheet is too coarse for are in sight.
  std::optional<HostImage> normal;
  std::optional<HostImage> slopeVariance;  ///< rg16f or rg32f: unresolved slope variance along world x and z [1].
  std::optional<HostImage> mergedDepth;    ///< r32f: depth of sea and host merged, in the camera's convention.
};

/// Pipelines shared by all views. Move-only; one thread at a time.
class Composite {
 public:
  static Result<Composite> create(Device& device);
  Composite(Composite&&) noexcept;
  Composite& operator=(Composite&&) noexcept;
  ~Composite();

  /// On all views, from their next record() on. The first lights compile pipelines; without lights there is no cost.
  /// On error nothing changes.
  Result<void> setLights(std::span<const HostLight> lights);

 private:
  friend class CompositeView;
  struct Impl;
  explicit Composite(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

/// One view's bindings. Move-only; must not outlive the objects it was created from.
class CompositeView {
 public:
  /// Errors: invalidArgument when an extent or format differs from what CompositeTargets says, or when sky and water
  /// are of different planets.
  static Result<CompositeView> create(Composite& composite, const WaveMaps& waves, const SkyMaps& sky,
                                      const WaterBuffer& water, const CompositeTargets& targets);
  CompositeView(CompositeView&&) noexcept;
  CompositeView& operator=(CompositeView&&) noexcept;
  ~CompositeView();

  /// Shades the water buffer; `waves` and `water` as Waves::maps() and SurfaceView::buffer() return them now. Every
  /// host image goes from its `before` to its `after` state.
  void record(VkCommandBuffer commands, const WaveMaps& waves, const WaterBuffer& water, const Camera& camera,
              const WaterMedium& medium, Timings* timings = nullptr) noexcept;

 private:
  struct Impl;
  explicit CompositeView(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

struct ToneMapInfo {
  HostImage input;   ///< HDR, rgba16f or rgba32f, SAMPLED usage.
  HostImage output;  ///< rgba8 (unorm, sRGB-encoded by the pass) with STORAGE usage; same extent.
};

/// The optional last pass: exposure, a filmic curve, sRGB encoding and dithering to 8 bits. Move-only.
class ToneMap {
 public:
  static Result<ToneMap> create(Device& device, const ToneMapInfo& info);
  ToneMap(ToneMap&&) noexcept;
  ToneMap& operator=(ToneMap&&) noexcept;
  ~ToneMap();

  /// Light of this colour temperature [K], 2000 … 25000, becomes grey, by the Bradford transform, in what is recorded
  /// from now on. 6504, the default, leaves colours as they are; less makes a picture bluer, more warmer, as a camera's
  /// white balance does.
  Result<void> setWhiteBalance(double kelvin);
  /// `exposure` in stops (EV): radiance is multiplied by 2^exposure before the curve; -32 … 32, clamped.
  void record(VkCommandBuffer commands, float exposure, Timings* timings = nullptr) noexcept;
  /// Exposes the picture by itself: the geometric mean of its luminance, of 4096 pixels each held within
  /// 1e-5 … 100, becomes middle grey, then `compensation` [EV] brighter. Depends on this picture alone, not on the ones
  /// before.
  void recordMetered(VkCommandBuffer commands, float compensation, Timings* timings = nullptr) noexcept;

 private:
  struct Impl;
  explicit ToneMap(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
