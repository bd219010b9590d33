// The members of all elements of a list, such as their names.
#pragma once

#include <functional>
#include <type_traits>
#include <vector>

namespace libration {

/// One member of each element, or of what it points to, in their order: members_of(studies, &study::name).
template <class Range, class Member>
auto members_of(const Range& all, Member member) {
    std::vector<std::remove_cvref_t<std::invoke_result_t<Member, typename Range::const_reference>>> members;
    members.reserve(all.size());
    for (const auto& each : all) {
        members.push_back(std::invoke(member, each));
    }
    return members;
}

}  // namespace libration
