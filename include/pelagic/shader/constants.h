// Constants of nature that shaders and C++ share.
#ifndef PELAGIC_SHADER_CONSTANTS_H
#define PELAGIC_SHADER_CONSTANTS_H
#include "pelagic/shader/types.h"

PELAGIC_SHADER_BEGIN

PELAGIC_SHADER_CONSTANT float kEarthRadius = 6371000.0f;      // mean, at sea level [m]
PELAGIC_SHADER_CONSTANT float kSunAngularRadius = 0.004675f;  // of the disc [rad]
PELAGIC_SHADER_CONSTANT uint kMostHostLights = 16u;

PELAGIC_SHADER_END

#endif
