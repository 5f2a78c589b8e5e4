/// A reference for the light of a rough sea: rays through an explicit random surface of facets. CPU, for tests only.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace support {

/// Gaussian waves on a periodic lattice of unit cells, each of two plane facets: y = h(x, z), a spectrum of slopes that
/// is flat over ln k between four waves a side and one of eight cells.
class FacetedSea {
 public:
  /// Slopes of the variances `along` and `across` x; the lattice has `size`, a power of two, cells a side. Of the waves
  /// the longest that make up the part `longest` of the slopes' variance.
  FacetedSea(std::uint32_t size, double along, double across, std::uint32_t seed, double longest = 1);

  /// First two moments of the facets' slopes: mean squares along x and z, and mean product [1].
  glm::dvec3 slopeCovariance() const;
  /// Of the facets about a place.
  glm::dvec2 slope(double x, double z) const;
  double top() const { return top_; }
  double side() const { return size_; }

  struct Hit {
    glm::dvec3 position;
    glm::dvec3 normal;  ///< Unit, upward.
  };
  /// Where a ray that comes from above, or leaves the surface, meets it first.
  bool intersect(const glm::dvec3& origin, const glm::dvec3& direction, Hit& hit) const;

 private:
  double height(std::int64_t i, std::int64_t j) const {
    const std::int64_t mask = std::int64_t{size_} - 1;
    return heights_[static_cast<std::size_t>((j & mask) * size_ + (i & mask))];
  }
  bool intersectCell(std::int64_t i, std::int64_t j, const glm::dvec3& origin, const glm::dvec3& direction, double from,
                     double to, Hit& hit) const;

  std::uint32_t size_;
  std::vector<double> heights_;
  double top_ = 0;
};

/// From an even place of number `i` over the lattice, toward -v: the first facet that a view along v shows.
FacetedSea::Hit facetSeen(const FacetedSea& sea, const glm::dvec3& v, std::uint32_t i);

/// What falls on the sea and what comes out of the water.
struct SeaLighting {
  std::function<glm::dvec3(const glm::dvec3& direction)> sky;  ///< Radiance from above the horizon.
  glm::dvec3 sunDirection{0, 1, 0};
  double sunRadius = 0;         ///< Of the disc [rad].
  glm::dvec3 sunIrradiance{0};  ///< On a plane that faces the sun.
  glm::dvec3 waterRadiance{0};  ///< Of the water under every facet, before the facet lets it through.
};

/// Mean radiance of the sea, by where the light came from.
struct SeaRadiance {
  glm::dvec3 sky{0}, sun{0}, water{0};
  glm::dvec3 sum() const { return sky + sun + water; }
};

/// What a ray from `origin` along `direction` brings back: every facet reflects by Fresnel's law of unpolarised light
/// and lets the rest of the water's light through; what it mirrors may be sea again.
SeaRadiance traceRay(const FacetedSea& sea, const SeaLighting& lighting, glm::dvec3 origin, glm::dvec3 direction);

/// Toward the unit vector v, the mean over `rays` places.
SeaRadiance traceSea(const FacetedSea& sea, const SeaLighting& lighting, const glm::dvec3& v, std::uint32_t rays);

}  // namespace support
