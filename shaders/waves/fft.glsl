// Inverse discrete Fourier transform (e^{+i}, not normalised) of lines of N = 64 ... 1024 samples, two complex numbers a
// vec4. A line is shared by N/16 threads with 16 samples in registers each; a first pass of radix 16, a second of radix
// 4, 8 or 16 and above N = 256 a third of radix 2 or 4 (Stockham's order) exchange them through shared memory.
// Before and after, thread t holds the samples t + e N/16 in v[e].
// The includer defines: FFT_THREADS (N/16), FFT_THREAD (this thread's t), FFT_EXCHANGE(i), the shared slot of sample i.
#ifndef PELAGIC_WAVES_FFT_GLSL
#define PELAGIC_WAVES_FFT_GLSL

const uint kSize = FFT_THREADS * kSamplesPerThread;
const float kTwoPi = 6.28318530717958648;
const float kEighth = 0.70710678118654752;  // cos(2 pi / 8)

vec4 v[16];

vec2 unit(float angle) { return vec2(cos(angle), sin(angle)); }
vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec4 turned(vec4 a, vec2 w) {
  return vec4(a.x * w.x - a.y * w.y, a.x * w.y + a.y * w.x, a.z * w.x - a.w * w.y, a.z * w.y + a.w * w.x);
}
vec4 quarterTurn(vec4 a) { return vec4(-a.y, a.x, -a.w, a.z); }

void transform4(uint a, uint b, uint c, uint d) {
  const vec4 sumEven = v[a] + v[c];
  const vec4 differenceEven = v[a] - v[c];
  const vec4 sumOdd = v[b] + v[d];
  const vec4 differenceOdd = quarterTurn(v[b] - v[d]);
  v[a] = sumEven + sumOdd;
  v[b] = differenceEven + differenceOdd;
  v[c] = sumEven - sumOdd;
  v[d] = differenceEven - differenceOdd;
}

// Samples first, first + 2, ... in natural order.
void transform8(uint first) {
  transform4(first, first + 4, first + 8, first + 12);
  transform4(first + 2, first + 6, first + 10, first + 14);
  const vec4 odd0 = v[first + 2];
  const vec4 odd1 = turned(v[first + 6], vec2(kEighth, kEighth));
  const vec4 odd2 = quarterTurn(v[first + 10]);
  const vec4 odd3 = turned(v[first + 14], vec2(-kEighth, kEighth));
  const vec4 even0 = v[first];
  const vec4 even1 = v[first + 4];
  const vec4 even2 = v[first + 8];
  const vec4 even3 = v[first + 12];
  v[first] = even0 + odd0;
  v[first + 2] = even1 + odd1;
  v[first + 4] = even2 + odd2;
  v[first + 6] = even3 + odd3;
  v[first + 8] = even0 - odd0;
  v[first + 10] = even1 - odd1;
  v[first + 12] = even2 - odd2;
  v[first + 14] = even3 - odd3;
}

void exchangeRegisters(uint a, uint b) {
  const vec4 keep = v[a];
  v[a] = v[b];
  v[b] = keep;
}

void transform16() {
  [[unroll]] for (uint i = 0; i < 4; ++i) transform4(i, i + 4, i + 8, i + 12);
  const float c1 = 0.92387953251128674, s1 = 0.38268343236508977;
  v[5] = turned(v[5], vec2(c1, s1));
  v[6] = turned(v[6], vec2(kEighth, kEighth));
  v[7] = turned(v[7], vec2(s1, c1));
  v[9] = turned(v[9], vec2(kEighth, kEighth));
  v[10] = quarterTurn(v[10]);
  v[11] = turned(v[11], vec2(-kEighth, kEighth));
  v[13] = turned(v[13], vec2(s1, c1));
  v[14] = turned(v[14], vec2(-kEighth, kEighth));
  v[15] = turned(v[15], vec2(-c1, -s1));
  [[unroll]] for (uint i = 0; i < 4; ++i) transform4(4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3);
  [[unroll]] for (uint i = 0; i < 4; ++i) {
    [[unroll]] for (uint j = i + 1; j < 4; ++j) exchangeRegisters(4 * i + j, 4 * j + i);
  }
}

// v[k] times w^k, k = 0 ... 15.
void twiddle16(vec2 w) {
  vec2 power[16];
  power[1] = w;
  v[1] = turned(v[1], w);
  [[unroll]] for (uint k = 2; k < 16; ++k) {
    power[k] = times(power[k / 2], power[k - k / 2]);
    v[k] = turned(v[k], power[k]);
  }
}

// For butterflies of `radix` (2, 4 or 8) that end the transform: v[m + k b] times w_m^k with b = 16/radix butterflies a
// thread and w_m = w e^{2 pi i m/16}.
void twiddleLast(uint radix, vec2 w) {
  const uint butterflies = 16 / radix;
  [[unroll]] for (uint m = 0; m < butterflies; ++m) {
    const vec2 base = times(w, unit(kTwoPi * float(m) / 16));
    vec2 power = base;
    [[unroll]] for (uint k = 1; k < radix; ++k) {
      v[m + k * butterflies] = turned(v[m + k * butterflies], power);
      power = times(power, base);
    }
  }
}

// Puts sample k of this thread's radix-16 butterfly at its place behind `done` finished samples.
void exchange(uint done) {
  const uint first = (FFT_THREAD / done) * done * 16 + FFT_THREAD % done;
  [[unroll]] for (uint k = 0; k < 16; ++k) FFT_EXCHANGE(first + k * done) = v[k];
  barrier();
  [[unroll]] for (uint e = 0; e < 16; ++e) v[e] = FFT_EXCHANGE(FFT_THREAD + e * FFT_THREADS);
}

// Every thread of the work-group calls it. Before a second call in one shader: barrier().
void transformLine() {
  transform16();
  exchange(1);
  if (kSize == 64) {
    twiddleLast(4, unit(kTwoPi * float(FFT_THREAD) / float(kSize)));
    [[unroll]] for (uint m = 0; m < 4; ++m) transform4(m, m + 4, m + 8, m + 12);
  } else if (kSize == 128) {
    twiddleLast(8, unit(kTwoPi * float(FFT_THREAD) / float(kSize)));
    transform8(0);
    transform8(1);
  } else {
    twiddle16(unit(kTwoPi * float(FFT_THREAD % 16) / 256));
    transform16();
  }
  if (kSize > 256) {
    barrier();
    exchange(16);
    const vec2 w = unit(kTwoPi * float(FFT_THREAD) / float(kSize));
    if (kSize == 512) {
      twiddleLast(2, w);
      [[unroll]] for (uint m = 0; m < 8; ++m) {
        const vec4 sum = v[m] + v[m + 8];
        v[m + 8] = v[m] - v[m + 8];
        v[m] = sum;
      }
    } else {
      twiddleLast(4, w);
      [[unroll]] for (uint m = 0; m < 4; ++m) transform4(m, m + 4, m + 8, m + 12);
    }
  }
}

#endif
