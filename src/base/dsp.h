/* SPDX-License-Identifier: MIT */
/* Packed arithmetic: two 16-bit or four 8-bit lanes in a 32-bit word.  Microcontrollers
 * with Arm's DSP extension take one instruction each.  Other machines run the same
 * functions in plain C, and packed loop bodies are tested there too.  Larger Arms are
 * excluded: they have vectors, and compilers that name the lane types differently.  TP_WIDE
 * tells processors with eight-lane vectors. */
#ifndef TP_BASE_DSP_H
#define TP_BASE_DSP_H
#include "base/base.h"

#if defined(__ARM_FEATURE_DSP) && __ARM_FEATURE_DSP && __ARM_ARCH_PROFILE == 'M'
#define TP_DSP 1
#include <arm_acle.h>
#else
#define TP_DSP 0
#endif

/* Adds four unsigned bytes; each sum saturates at 255. */
TP_ALWAYS_INLINE uint32_t tp_uqadd8(uint32_t a, uint32_t b)
{
#if TP_DSP
    return __uqadd8(a, b);
#else
    uint32_t sum = 0;
    for (int i = 0; i < 32; i += 8) {
        uint32_t s = (a >> i & 0xff) + (b >> i & 0xff);
        sum |= (s < 255 ? s : 255) << i;
    }
    return sum;
#endif
}

/* Means of four pairs of bytes, rounded down. */
TP_ALWAYS_INLINE uint32_t tp_uhadd8(uint32_t a, uint32_t b)
{
#if TP_DSP
    return __uhadd8(a, b);
#else
    return (a & b) + ((a ^ b) >> 1 & 0x7f7f7f7f);
#endif
}

/* Sum of the absolute differences of four pairs of bytes. */
TP_ALWAYS_INLINE uint32_t tp_usad8(uint32_t a, uint32_t b)
{
#if TP_DSP
    return __usad8(a, b);
#else
    uint32_t sum = 0;
    for (int i = 0; i < 32; i += 8) {
        int32_t d = (int32_t)(a >> i & 0xff) - (int32_t)(b >> i & 0xff);
        sum += (uint32_t)(d < 0 ? -d : d);
    }
    return sum;
#endif
}

/* Adds two pairs of signed 16-bit halves; each sum saturates to 16 bits. */
TP_ALWAYS_INLINE uint32_t tp_qadd16(uint32_t a, uint32_t b)
{
#if TP_DSP
    return (uint32_t)__qadd16((int16x2_t)a, (int16x2_t)b);
#else
    int32_t high = ((int32_t)a >> 16) + ((int32_t)b >> 16);
    int32_t low = (int16_t)a + (int16_t)b;
    high = high < INT16_MIN ? INT16_MIN : high > INT16_MAX ? INT16_MAX : high;
    low = low < INT16_MIN ? INT16_MIN : low > INT16_MAX ? INT16_MAX : low;
    return (uint32_t)high << 16 | (uint16_t)low;
#endif
}

/* Returns sum + (upper half of a) (lower half of b), signed halves; the sum wraps.
 * tp_smlabb takes the lower half of a. */
TP_ALWAYS_INLINE uint32_t tp_smlatb(uint32_t a, uint32_t b, uint32_t sum)
{
#if TP_DSP
    return (uint32_t)__smlatb((int32_t)a, (int32_t)b, (int32_t)sum);
#else
    return sum + (uint32_t)(((int32_t)a >> 16) * (int16_t)b);
#endif
}

TP_ALWAYS_INLINE uint32_t tp_smlabb(uint32_t a, uint32_t b, uint32_t sum)
{
#if TP_DSP
    return (uint32_t)__smlabb((int32_t)a, (int32_t)b, (int32_t)sum);
#else
    return sum + (uint32_t)((int16_t)a * (int16_t)b);
#endif
}

static inline int32_t tp_low16(uint32_t a)
{
    return (int32_t)(a << 16) >> 16;
}

static inline int32_t tp_high16(uint32_t a)
{
    return (int32_t)a >> 16;
}

static inline uint32_t tp_pair16(int32_t high, int32_t low)
{
    return (uint32_t)high << 16 | ((uint32_t)low & 0xffff);
}

/* Packs the lower halves of a and b into a word, b's half on top; tp_pack_high_halves packs
 * the upper halves. */
TP_ALWAYS_INLINE uint32_t tp_pack_low_halves(uint32_t a, uint32_t b)
{
#if TP_DSP
    uint32_t halves;
    __asm__("pkhbt %0, %1, %2, lsl #16" : "=r"(halves) : "r"(a), "r"(b));
    return halves;
#else
    return (a & 0xffff) | b << 16;
#endif
}

TP_ALWAYS_INLINE uint32_t tp_pack_high_halves(uint32_t a, uint32_t b)
{
#if TP_DSP
    uint32_t halves;
    __asm__("pkhtb %0, %2, %1, asr #16" : "=r"(halves) : "r"(a), "r"(b));
    return halves;
#else
    return a >> 16 | (b & 0xffff0000u);
#endif
}

/* Swaps the bytes of both halves. */
TP_ALWAYS_INLINE uint32_t tp_swap_bytes_of_halves(uint32_t a)
{
#if TP_DSP
    __asm__("rev16 %0, %1" : "=r"(a) : "r"(a));
    return a;
#else
    return (a & 0x00ff00ffu) << 8 | (a >> 8 & 0x00ff00ffu);
#endif
}

/* Keeps a constant in a register.  Otherwise the compiler turns products with a
 * known constant into shifts and sums, which gains nothing on a core that
 * multiplies in one cycle. */
TP_ALWAYS_INLINE uint32_t tp_keep_in_register(uint32_t constant)
{
#if TP_DSP
    __asm__("" : "+r"(constant));
#endif
    return constant;
}

/* Keeps an address in a register of its own. */
TP_ALWAYS_INLINE const void *tp_keep_pointer(const void *at)
{
#if TP_DSP
    __asm__("" : "+r"(at));
#endif
    return at;
}

/* Returns the product of the upper halves + the product of the lower halves +
 * c; the sum wraps. */
TP_ALWAYS_INLINE int32_t tp_smlad(uint32_t a, uint32_t b, int32_t sum)
{
#if TP_DSP
    return __smlad((int16x2_t)a, (int16x2_t)b, sum);
#else
    return (int32_t)((uint32_t)(tp_high16(a) * tp_high16(b))
                     + (uint32_t)(tp_low16(a) * tp_low16(b)) + (uint32_t)sum);
#endif
}

TP_ALWAYS_INLINE int32_t tp_smuad(uint32_t a, uint32_t b)
{
#if TP_DSP
    return __smuad((int16x2_t)a, (int16x2_t)b);
#else
    return tp_smlad(a, b, 0);
#endif
}

/* Returns a times the lower half of b, over 65536; tp_smulwt takes the upper half.
 * The C version stays in 32 bits because 65535 x 32768 < 2^31, and compilers
 * vectorise 32-bit code. */
TP_ALWAYS_INLINE int32_t tp_smulwb(int32_t a, uint32_t b)
{
#if TP_DSP
    int32_t product;
    __asm__("smulwb %0, %1, %2" : "=r"(product) : "r"(a), "r"(b));
    return product;
#else
    int32_t low = tp_low16(b);
    return (a >> 16) * low + ((a & 0xffff) * low >> 16);
#endif
}

TP_ALWAYS_INLINE int32_t tp_smulwt(int32_t a, uint32_t b)
{
#if TP_DSP
    int32_t product;
    __asm__("smulwt %0, %1, %2" : "=r"(product) : "r"(a), "r"(b));
    return product;
#else
    int32_t high = tp_high16(b);
    return (a >> 16) * high + ((a & 0xffff) * high >> 16);
#endif
}

/* Returns sum + tp_smulwb(a, b); tp_smlawt takes the upper half of b.  The sum wraps. */
TP_ALWAYS_INLINE int32_t tp_smlawb(int32_t a, uint32_t b, int32_t sum)
{
#if TP_DSP
    __asm__("smlawb %0, %1, %2, %0" : "+r"(sum) : "r"(a), "r"(b));
    return sum;
#else
    return (int32_t)((uint32_t)sum + (uint32_t)tp_smulwb(a, b));
#endif
}

TP_ALWAYS_INLINE int32_t tp_smlawt(int32_t a, uint32_t b, int32_t sum)
{
#if TP_DSP
    __asm__("smlawt %0, %1, %2, %0" : "+r"(sum) : "r"(a), "r"(b));
    return sum;
#else
    return (int32_t)((uint32_t)sum + (uint32_t)tp_smulwt(a, b));
#endif
}

/* Adds two pairs of 16-bit halves; the sums wrap. */
TP_ALWAYS_INLINE uint32_t tp_sadd16(uint32_t a, uint32_t b)
{
#if TP_DSP
    return (uint32_t)__sadd16((int16x2_t)a, (int16x2_t)b);
#else
    return ((a & 0x7fff7fffu) + (b & 0x7fff7fffu)) ^ ((a ^ b) & 0x80008000u);
#endif
}

/* Subtracts the halves of b from the halves of a; the differences wrap. */
TP_ALWAYS_INLINE uint32_t tp_ssub16(uint32_t a, uint32_t b)
{
#if TP_DSP
    return (uint32_t)__ssub16((int16x2_t)a, (int16x2_t)b);
#else
    return ((a | 0x80008000u) - (b & 0x7fff7fffu)) ^ ((a ^ ~b) & 0x80008000u);
#endif
}

/* Half of each difference of the signed halves, a - b, rounded down. */
TP_ALWAYS_INLINE uint32_t tp_shsub16(uint32_t a, uint32_t b)
{
#if TP_DSP
    return (uint32_t)__shsub16((int16x2_t)a, (int16x2_t)b);
#else
    return tp_pair16((tp_high16(a) - tp_high16(b)) >> 1,
                     (tp_low16(a) - tp_low16(b)) >> 1);
#endif
}

/* Half of each sum of the signed halves, rounded down. */
TP_ALWAYS_INLINE uint32_t tp_shadd16(uint32_t a, uint32_t b)
{
#if TP_DSP
    return (uint32_t)__shadd16((int16x2_t)a, (int16x2_t)b);
#else
    return tp_pair16((tp_high16(a) + tp_high16(b)) >> 1,
                     (tp_low16(a) + tp_low16(b)) >> 1);
#endif
}

/* Spreads bytes 0 and 2 into two 16-bit halves; tp_odd_bytes spreads bytes 1 and 3.
 * tp_halves_add_odd_bytes adds bytes 1 and 3 of b to the halves of a. */
TP_ALWAYS_INLINE uint32_t tp_even_bytes(uint32_t a)
{
#if TP_DSP
    return (uint32_t)__uxtb16((uint8x4_t)a);
#else
    return a & 0x00ff00ffu;
#endif
}

TP_ALWAYS_INLINE uint32_t tp_odd_bytes(uint32_t a)
{
#if TP_DSP
    uint32_t bytes;
    __asm__("uxtb16 %0, %1, ror #8" : "=r"(bytes) : "r"(a));
    return bytes;
#else
    return a >> 8 & 0x00ff00ffu;
#endif
}

/* The sums must not overflow their 16-bit halves. */
TP_ALWAYS_INLINE uint32_t tp_halves_add_odd_bytes(uint32_t halves, uint32_t bytes)
{
#if TP_DSP
    uint32_t sum;
    __asm__("uxtab16 %0, %1, %2, ror #8" : "=r"(sum) : "r"(halves), "r"(bytes));
    return sum;
#else
    return halves + tp_odd_bytes(bytes);
#endif
}

/* x / 2^shift, saturated to -2^(bits - 1)..2^(bits - 1) - 1; shift and bits are
 * literals. */
TP_ALWAYS_INLINE int32_t tp_ssat(int32_t x, int shift, int bits)
{
#if TP_DSP
    int32_t held;
    __asm__("ssat %0, %2, %1, asr %3" : "=r"(held) : "r"(x), "i"(bits), "i"(shift));
    return held;
#else
    int32_t y = x >> shift, end = (int32_t)(1u << (bits - 1));
    y = y > -end ? y : -end;
    return y < end ? y : end - 1;
#endif
}

/* x / 2^shift, saturated to 0..2^bits - 1; shift and bits are literals. */
TP_ALWAYS_INLINE int32_t tp_usat(int32_t x, int shift, int bits)
{
#if TP_DSP
    int32_t held;
    if (shift == 0)
        __asm__("usat %0, %2, %1" : "=r"(held) : "r"(x), "i"(bits));
    else
        __asm__("usat %0, %2, %1, asr %3" : "=r"(held)
                : "r"(x), "i"(bits), "i"(shift ? shift : 1));
    return held;
#else
    int32_t y = x >> shift, end = (int32_t)((1u << bits) - 1);
    y = y > 0 ? y : 0;
    return y < end ? y : end;
#endif
}

/* -- two forms of some loops --------------------------------------------------------- */

/* TP_WIDE selects between two forms of some loops: for processors with eight-lane vectors
 * and for all others.  If TP_WIDE is 1, selects are cheaper than branches, and two small
 * loops are cheaper than one loop with a table look-up. */

#if defined(__AVX2__)
#define TP_WIDE 1
#else
#define TP_WIDE 0
#endif

#endif
