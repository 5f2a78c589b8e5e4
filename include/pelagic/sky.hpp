/// The sky stage: sun, moon and stars, clear sky after Hillaire (2020), CIE overcast, and the light that the water
/// needs from them. Radiance is in units of the extraterrestrial solar irradiance per steradian, per linear Rec.709
/// channel: above the air the sun's irradiance is (1,1,1), its disc has the radiance 1/6.8e-5 = 1.46e4, which half
/// floats hold. Twilight loses half of its light every 0.7 degrees. So that half floats hold it, every radiance and
/// irradiance of the maps is multiplied by twilightGain() when the sun is down: 1 by day, and a change of exposure
/// else.
#pragma once

#include <pelagic/shader/constants.h>

#include <glm/glm.hpp>
#include <optional>
#include <pelagic/camera.hpp>
#include <pelagic/device.hpp>
#include <pelagic/image.hpp>
#include <pelagic/timings.hpp>
#include <vector>

namespace pelagic {

/// Angular radius of the sun's disc [rad].
inline constexpr double kSunAngularRadius = shader::kSunAngularRadius;

/// One layer of clouds, which drifts with the wind. Its shape repeats after 15 km. Fields of clouds and open sea take
/// turns over tens of kilometres; at time 0 a field lies over the origin of the world.
struct CloudLayer {
  double cover = 0;        ///< Share of the sky that they take, looking up in a field of them [1], 0 none … 1 all.
  double base = 800;       ///< Altitude of their base [m], 100 … 8000.
  double thickness = 700;  ///< From base to the highest tops [m], 50 … 4000.
  /// Along world x and z [m/s], -100 … 100 each. To change it moves the clouds by the difference times the time.
  glm::dvec2 velocity{6, 0};
  std::uint32_t seed = 1;  ///< Of their shape.
  bool operator==(const CloudLayer&) const = default;
};

struct SkyState {
  double sunElevation = 0.6;  ///< Above the horizontal [rad], -pi/2 … pi/2.
  double sunAzimuth = 0.0;    ///< Toward the sun, from +x turning to +z [rad], finite.
  double overcast = 0.0;      ///< 0 clear … 1 CIE overcast sky without a sun [1].
  double haze = 1.0;          ///< Aerosol at sea level, 1: clean maritime air of extinction 6e-5 1/m, 0 … 20.
  CloudLayer clouds;          ///< Below the overcast, which has no height.
  /// Scale height of the aerosol, less in a shallow layer over the sea [m], 200 … 5000. From kilometres above, the
  /// light of a layer under 800 m is drawn with too little aerosol (0.9 of 400 m's from 10 km, 0.7 of 200 m's).
  double hazeHeight = 1200;
  double moonElevation = -1;   ///< Above the horizontal [rad], -pi/2 … pi/2; below the horizon there is no moon.
  double moonAzimuth = 0;      ///< Toward the moon [rad], as the sun's.
  double moonIlluminated = 1;  ///< Part of its disc that the sun lights [1], 0 new … 1 full.
  /// Turns the sky of the stars into the world, a rotation: their pole is its z axis, as in a catalogue's equatorial
  /// coordinates. The stars themselves are random, as many of each magnitude as real ones.
  glm::dmat3 starsToWorld{1};
};
Result<void> validate(const SkyState& state);

/// A sun beside a host's picture of the sky.
struct EnvironmentSun {
  double elevation = 0;     ///< Above the horizontal [rad], 0 … pi/2.
  double azimuth = 0;       ///< Toward it, from +x turning to +z [rad], finite; not turned with the picture.
  glm::vec3 irradiance{0};  ///< At sea level on a plane facing it, in the units of this header, 0 … 1e9 each.
};

/// A host's picture of the sky, longitude x latitude, that stands in place of Pelagic's: then of SkyState the haze
/// and its height alone count. Its upper half is the sky, what is below the horizon is not used. Nor does an eye's
/// altitude change it: the rows are spread between the zenith and the eye's own horizon. Into the distance the sea
/// takes the colour of the horizon above it, as the haze thickens.
struct SkyEnvironment {
  std::uint32_t width = 0;   ///< Pixels of a row, 4 … 4096, a multiple of 4; 0: no picture, the sky is Pelagic's.
  std::uint32_t height = 0;  ///< Rows: half of width.
  /// Radiance, linear Rec.709, 0 … 1e9 each: rows from the zenith to the nadir, the centre of pixel (i, j) at the
  /// azimuth 2 pi (i + 1/2)/width, from +x turning to +z (to the right, for who looks at it), and the elevation
  /// pi/2 - pi (j + 1/2)/height. Times `scale`, more than 6e4 outside the sun is held at that: maps are halves.
  std::vector<glm::vec3> radiance;
  double scale = 1;     ///< Factor on the radiance, into the units of this header or the host's own [1], 0 … 1e6.
  double rotation = 0;  ///< Turns the picture, from +x to +z [rad], finite.
  /// Without it the sun is looked for in the picture: within 2.5 degrees (or 1.5 pixels) of the brightest pixel above
  /// the horizon, what exceeds the mean of a narrow ring around. Where the mean luminance there is at least four times
  /// the ring's, that light is a sun: it leaves the picture and becomes SkyLight's directional sun of the same
  /// irradiance, with a disc of kSunAngularRadius, which glitters sharply. Else there is no sun. A sun given here is
  /// one that the picture does not show; of the irradiance 0, it says that there is none.
  std::optional<EnvironmentSun> sun;
};
/// The error names the field, its value and its range.
Result<void> validate(const SkyEnvironment& environment);

/// Factor on all light of the sky: 1 while the sun is higher than 2 degrees below the horizon, then 2^1.45 more per
/// degree down to 2^20. SkyLight::skyIrradiance.w holds it for a host that adds lamps of its own.
double twilightGain(double sunElevation) noexcept;

/// The maps of the sky. All 2-D, one layer, linear filtering, rest in kShaderRead.
struct SkyMaps {
  /// rgba16f, lat-long: u = azimuth/(2 pi) in the world frame (atan(z,x), wraps). With the elevation e and that of the
  /// eye's horizon e0 = -acos(R/(R + altitude)), R the planet's radius, v = 0.5 + 0.5 sqrt((e - e0)/(pi/2 - e0)) above
  /// it, which spends texels on the horizon: radiance of the sky without the sun's disc. Sky::maps() has it for sea
  /// level, e0 = 0, and below the horizon holds the radiance of the horizon. SkyView::maps() has it for an eye, and
  /// below, v = 0.5 - 0.5 sqrt((e0 - e)/(pi/2 + e0)), the air's own light: what stands there with the radiance L is
  /// seen as t L + (1 - t) times the texel, t the transmittance of the air before it.
  MapView radiance;
  /// rgba16f, mips, stereographic: direction r maps to uv = 0.5 + 0.5 (r.x, r.z)/(1 + r.y) * kEnvironmentScale;
  /// RGB radiance x coverage, A coverage: 1 above the horizon, 0 below; blurred toward higher mips.
  MapView environment;
  /// The SkyLight block of pelagic/shader/sky_light.h, with STORAGE_BUFFER and UNIFORM_BUFFER usage; CompositeView
  /// binds it as a uniform block. Resting state: shader reads.
  VkBuffer light = VK_NULL_HANDLE;
  VkDeviceSize lightSize = 0;
  /// Clouds, null where there can be none, as in Sky::maps(). rgba16f, a picture of the view at half its
  /// resolution, pixel (x, y) of the view at ((x, y) + 0.5)/(2 extent): RGB light of the clouds and the air before
  /// them, A the transmittance for what is behind.
  MapView clouds;
  /// rg16f with mips, repeats: share of the sun's light that reaches sea level through the clouds, with what they turn
  /// by a few degrees only; R in a field of clouds, G where the weather holds them down, to be mixed by the w of
  /// SkyLight::cloudZenith. Of the point p = (x, z) from the eye [m] it lies at xy + p z of SkyLight::cloudPlace.
  MapView cloudShadow;
  double planetRadius = kEarthRadius;  ///< As given to Sky::create() [m]; that of the water it is composed with.
};

/// Move-only; one thread at a time.
class Sky {
 public:
  /// `planetRadius` at sea level [m], 1e5 … 1e8: that of the water below, SurfaceInfo::planetRadius, so that horizon
  /// and clouds end where the sea does. The air is the Earth's whatever it is: 100 km, as dense at each altitude.
  /// `environment`: a picture instead; what comes by setEnvironment() has its size.
  static Result<Sky> create(Device& device, const SkyState& state, double planetRadius = kEarthRadius,
                            const SkyEnvironment& environment = {});
  Sky(Sky&&) noexcept;
  Sky& operator=(Sky&&) noexcept;
  ~Sky();

  /// Takes effect with the next record(). On error nothing changes.
  Result<void> setState(const SkyState& state);
  /// Likewise; a picture of the size given to create(), or none: Pelagic's sky again. The picture is read while the
  /// commands of the next record() execute, which must have ended before the record() after another picture was set.
  Result<void> setEnvironment(const SkyEnvironment& environment);
  /// Recomputes the maps when the state changed since the last call, else records nothing. `time` [s], any finite
  /// value: where the clouds have drifted to by then is seen in views.
  void record(VkCommandBuffer commands, double time, Timings* timings = nullptr) noexcept;
  /// Of a sea without clouds.
  SkyMaps maps() const noexcept;

 private:
  friend class SkyView;
  struct Impl;
  explicit Sky(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

/// The sky of one camera: from its altitude, with clouds, and the air between the eye and what it sees. Move-only; one
/// thread at a time; must not outlive its Sky.
class SkyView {
 public:
  /// `extent` of the view's pictures [px], 1 … 16384 each.
  static Result<SkyView> create(const Sky& sky, VkExtent2D extent);
  SkyView(SkyView&&) noexcept;
  SkyView& operator=(SkyView&&) noexcept;
  ~SkyView();

  /// After Sky::record(). The camera's altitude counts to the metre, held at 0 to 99 km. What depends on the sky's
  /// state and the altitude is recomputed when they have changed, the clouds always, where there are any.
  void record(VkCommandBuffer commands, const Camera& camera, Timings* timings = nullptr) noexcept;
  /// As the sky's, as the eye sees it.
  SkyMaps maps() const noexcept;

 private:
  struct Impl;
  explicit SkyView(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
