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

// F(0) ... F(15). Loops over registers are written out like this, because a driver that leaves one as a loop puts the
// registers into memory.
#define FFT_EACH_4(F, a) F(a) F(a + 1) F(a + 2) F(a + 3)
#define FFT_EACH(F) \
  F(0) F(1) F(2) F(3) F(4) F(5) F(6) F(7) F(8) F(9) F(10) F(11) F(12) F(13) F(14) F(15)

void transform2(inout vec4 a, inout vec4 b) {
  const vec4 sum = a + b;
  b = a - b;
  a = sum;
}

void transform4(inout vec4 a, inout vec4 b, inout vec4 c, inout vec4 d) {
  const vec4 sumEven = a + c;
  const vec4 differenceEven = a - c;
  const vec4 sumOdd = b + d;
  const vec4 differenceOdd = quarterTurn(b - d);
  a = sumEven + sumOdd;
  b = differenceEven + differenceOdd;
  c = sumEven - sumOdd;
  d = differenceEven - differenceOdd;
}

void transform8(inout vec4 a, inout vec4 b, inout vec4 c, inout vec4 d, inout vec4 e, inout vec4 f, inout vec4 g,
                inout vec4 h) {
  transform4(a, c, e, g);
  transform4(b, d, f, h);
  d = turned(d, vec2(kEighth, kEighth));
  f = quarterTurn(f);
  h = turned(h, vec2(-kEighth, kEighth));
  transform2(a, b);
  transform2(c, d);
  transform2(e, f);
  transform2(g, h);
  // Now a, c, e, g hold samples 0 ... 3 and b, d, f, h samples 4 ... 7.
  const vec4 sample1 = c, sample2 = e, sample3 = g, sample4 = b, sample5 = d, sample6 = f;
  b = sample1;
  c = sample2;
  d = sample3;
  e = sample4;
  f = sample5;
  g = sample6;
}

void swapped(inout vec4 a, inout vec4 b) {
  const vec4 keep = a;
  a = b;
  b = keep;
}

void transform16() {
  transform4(v[0], v[4], v[8], v[12]);
  transform4(v[1], v[5], v[9], v[13]);
  transform4(v[2], v[6], v[10], v[14]);
  transform4(v[3], v[7], v[11], v[15]);
  const float c1 = 0.92387953251128674, s1 = 0.38268343236508977;  // of 2 pi / 16
  v[5] = turned(v[5], vec2(c1, s1));
  v[6] = turned(v[6], vec2(kEighth, kEighth));
  v[7] = turned(v[7], vec2(s1, c1));
  v[9] = turned(v[9], vec2(kEighth, kEighth));
  v[10] = quarterTurn(v[10]);
  v[11] = turned(v[11], vec2(-kEighth, kEighth));
  v[13] = turned(v[13], vec2(s1, c1));
  v[14] = turned(v[14], vec2(-kEighth, kEighth));
  v[15] = turned(v[15], vec2(-c1, -s1));
  transform4(v[0], v[1], v[2], v[3]);
  transform4(v[4], v[5], v[6], v[7]);
  transform4(v[8], v[9], v[10], v[11]);
  transform4(v[12], v[13], v[14], v[15]);
  swapped(v[1], v[4]);
  swapped(v[2], v[8]);
  swapped(v[3], v[12]);
  swapped(v[6], v[9]);
  swapped(v[7], v[13]);
  swapped(v[11], v[14]);
}

// v[k] times w^k.
void twiddle16(vec2 w1) {
  const vec2 w2 = times(w1, w1), w3 = times(w1, w2), w4 = times(w2, w2), w5 = times(w2, w3), w6 = times(w3, w3),
             w7 = times(w3, w4), w8 = times(w4, w4);
  v[1] = turned(v[1], w1);
  v[2] = turned(v[2], w2);
  v[3] = turned(v[3], w3);
  v[4] = turned(v[4], w4);
  v[5] = turned(v[5], w5);
  v[6] = turned(v[6], w6);
  v[7] = turned(v[7], w7);
  v[8] = turned(v[8], w8);
  v[9] = turned(v[9], times(w4, w5));
  v[10] = turned(v[10], times(w5, w5));
  v[11] = turned(v[11], times(w5, w6));
  v[12] = turned(v[12], times(w6, w6));
  v[13] = turned(v[13], times(w6, w7));
  v[14] = turned(v[14], times(w7, w7));
  v[15] = turned(v[15], times(w7, w8));
}

// The last pass where N is no power of 16: 16/radix butterflies a thread, whose sample k is turned by w_m^k with
// w_m = w e^{2 pi i m/16} for butterfly m.
void last2(vec2 w) {
#define FFT_LAST_2(m)                                                \
  v[m + 8] = turned(v[m + 8], times(w, unit(kTwoPi * float(m) / 16))); \
  transform2(v[m], v[m + 8]);
  FFT_EACH_4(FFT_LAST_2, 0)
  FFT_EACH_4(FFT_LAST_2, 4)
}

void last4(vec2 w) {
#define FFT_LAST_4(m)                                        \
  {                                                          \
    const vec2 w1 = times(w, unit(kTwoPi * float(m) / 16));  \
    const vec2 w2 = times(w1, w1);                           \
    v[m + 4] = turned(v[m + 4], w1);                         \
    v[m + 8] = turned(v[m + 8], w2);                         \
    v[m + 12] = turned(v[m + 12], times(w1, w2));            \
    transform4(v[m], v[m + 4], v[m + 8], v[m + 12]);         \
  }
  FFT_EACH_4(FFT_LAST_4, 0)
}

void last8(vec2 w) {
#define FFT_LAST_8(m)                                                                                                 \
  {                                                                                                                   \
    const vec2 w1 = times(w, unit(kTwoPi * float(m) / 16));                                                           \
    const vec2 w2 = times(w1, w1), w3 = times(w1, w2), w4 = times(w2, w2);                                            \
    v[m + 2] = turned(v[m + 2], w1);                                                                                  \
    v[m + 4] = turned(v[m + 4], w2);                                                                                  \
    v[m + 6] = turned(v[m + 6], w3);                                                                                  \
    v[m + 8] = turned(v[m + 8], w4);                                                                                  \
    v[m + 10] = turned(v[m + 10], times(w2, w3));                                                                     \
    v[m + 12] = turned(v[m + 12], times(w3, w3));                                                                     \
    v[m + 14] = turned(v[m + 14], times(w3, w4));                                                                     \
    transform8(v[m], v[m + 2], v[m + 4], v[m + 6], v[m + 8], v[m + 10], v[m + 12], v[m + 14]);                        \
  }
  FFT_LAST_8(0)
  FFT_LAST_8(1)
}

// Puts sample k of this thread's radix-16 butterfly at its place behind `done` finished samples.
void exchange(uint done) {
  const uint first = (FFT_THREAD / done) * done * 16 + FFT_THREAD % done;
#define FFT_PUT(k) FFT_EXCHANGE(first + k * done) = v[k];
  FFT_EACH(FFT_PUT)
  barrier();
#define FFT_TAKE(e) v[e] = FFT_EXCHANGE(FFT_THREAD + e * FFT_THREADS);
  FFT_EACH(FFT_TAKE)
}

// Every thread of the work-group calls it. Before a second call in one shader: barrier().
void transformLine() {
  transform16();
  exchange(1);
  const vec2 w = unit(kTwoPi * float(FFT_THREAD) / float(kSize));
  if (kSize == 64) {
    last4(w);
  } else if (kSize == 128) {
    last8(w);
  } else {
    twiddle16(unit(kTwoPi * float(FFT_THREAD % 16) / 256));
    transform16();
  }
  if (kSize > 256) {
    barrier();
    exchange(16);
    if (kSize == 512) {
      last2(w);
    } else {
      last4(w);
    }
  }
}

#endif
