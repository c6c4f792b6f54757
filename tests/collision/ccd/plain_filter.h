// The filter as it is compiled for machines without AVX.
#pragma once

#include "collision/ccd/filter.h"
#include "collision/ccd/random_query.h"

namespace nuno {

FilterVerdict plainly_filtered(const Query& query);

}  // namespace nuno
