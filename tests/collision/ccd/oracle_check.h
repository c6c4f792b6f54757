// One query, answered and held to the exact oracle.
#pragma once

#include <string>

#include "collision/ccd/exact_oracle.h"
#include "collision/ccd/impact.h"
#include "collision/ccd/random_query.h"

namespace nuno {

struct OracleCheck
{
    bool is_impact;
    std::string fault;  // what is wrong with the answer, or nothing
};

inline OracleCheck check_against_oracle(const Query& query)
{
    const std::optional<double> time = query.kind == PairKind::vertex_face ? vertex_face_impact(query.t0, query.t1)
                                                                           : edge_edge_impact(query.t0, query.t1);
    const ExactOracle oracle(query.kind, query.t0, query.t1);
    const bool is_impact = oracle.has_contact();
    if (is_impact && !time) return {is_impact, "missed"};
    if (!is_impact && time) return {is_impact, "false alarm"};
    if (!time) return {is_impact, ""};
    if (!oracle.has_none_before(*time)) return {is_impact, "late"};
    if (!(*time >= 0) || !oracle.has_one_by(*time + kImpactTimeBracket)) return {is_impact, "too early"};
    return {is_impact, ""};
}

}  // namespace nuno
