// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Embree 3 and 4 under one set of names; private to render/, included in .cpp files only.

#pragma once

#include "openltc/render/embree_version.h"

#if OPENLTC_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace openltc::render {

#if OPENLTC_EMBREE_MAJOR >= 4

/// A ray query's context, which filter functions receive; extend by inheritance.
using QueryContext = RTCRayQueryContext;
inline void init_query(QueryContext& context) { rtcInitRayQueryContext(&context); }

inline void intersect_16(const int* valid, RTCScene scene, QueryContext& context, bool coherent,
                         RTCRayHit16& rays) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  rtcIntersect16(valid, scene, &rays, &arguments);
}
// Never as a coherent packet: Embree then traverses once per octant of directions and offers every
// ray's hits to the filter each time, so that one that counts would count them up to eight times.
inline void occluded_16(const int* valid, RTCScene scene, QueryContext& context, RTCRay16& rays) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
  rtcOccluded16(valid, scene, &rays, &arguments);
}

#else

using QueryContext = RTCIntersectContext;
inline void init_query(QueryContext& context) { rtcInitIntersectContext(&context); }

inline void intersect_16(const int* valid, RTCScene scene, QueryContext& context, bool coherent,
                         RTCRayHit16& rays) {
  context.flags =
      coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcIntersect16(valid, scene, &context, &rays);
}
inline void occluded_16(const int* valid, RTCScene scene, QueryContext& context, RTCRay16& rays) {
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcOccluded16(valid, scene, &context, &rays);
}

#endif

} // namespace openltc::render
