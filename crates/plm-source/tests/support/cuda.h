/* Stands in for CUDA on a processor: a kernel runs thread by thread, and memory is that of the program. */
#ifndef STAND_IN_CUDA_H
#define STAND_IN_CUDA_H

#include <cmath>
#include <cstdlib>

#define __CUDACC__ 12
#define __device__
#define __global__
#define __noinline__

struct stand_in_index { unsigned x; };
static stand_in_index blockIdx, threadIdx;
static const stand_in_index blockDim = { 4 }, gridDim = { 64 };

static inline double __dsqrt_rn(double x) { return std::sqrt(x); }
static inline float __fsqrt_rn(float x) { return std::sqrt(x); }

typedef int cudaError_t;
#define cudaSuccess 0
static inline cudaError_t cudaMallocManaged(void **place, size_t size)
{
    *place = std::malloc(size);
    return (*place == nullptr) ? 1 : 0;
}
static inline cudaError_t cudaDeviceSynchronize() { return 0; }
static inline const char *cudaGetErrorString(cudaError_t) { return "none"; }

/* Threads from the last to the first, some of them beyond the last mechanism. */
#define CALL(kernel)                                                            \
    [](auto... words) {                                                         \
        for (blockIdx.x = gridDim.x; blockIdx.x-- > 0;) {                       \
            for (threadIdx.x = blockDim.x; threadIdx.x-- > 0;) {                \
                kernel(words...);                                               \
            }                                                                   \
        }                                                                       \
    }

#endif
