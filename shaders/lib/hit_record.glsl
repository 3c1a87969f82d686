// SPDX-License-Identifier: MIT
#include "shared/limits.glsl"
#define VITRINE_INLINE
#include "shared/hit_record.glsl"
