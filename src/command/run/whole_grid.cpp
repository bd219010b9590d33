#include "run/whole_grid.hpp"
#include "libration/scalar/error.hpp"

#include <algorithm>
#include <string>

#include "libration/number/grid.hpp"

namespace libration {

namespace {

bool is_whole(const exact& value) {
    return value.measure == unit::one && denominator(value.coefficient) == 1 && value.coefficient >= 0;
}

bool all_whole(const std::vector<exact>& values) { return std::all_of(values.begin(), values.end(), is_whole); }

// FIRST:LAST:COUNT[log] with another count. The ends are whole.
class whole_range {
public:
    whole_range(std::string_view item, const std::vector<exact>& values)
        : ends_(item.substr(0, item.rfind(':') + 1)),
          logarithmic_(item.ends_with("log")),
          count_(static_cast<long>(values.size())),
          span_(abs(numerator(rational(values.back().coefficient - values.front().coefficient)))) {}

    /// The nearest counts whose values are whole, in words. Two is always one of them.
    std::string nearest_counts() const {
        const long fewer = nearest(-1);
        const long more = nearest(1);
        return std::to_string(fewer) + (more == 0 ? "" : " and " + std::to_string(more));
    }

private:
    bool comes_out_whole(long count) const {
        return logarithmic_ ? all_whole(read_grid(ends_ + std::to_string(count) + "log")) : span_ % (count - 1) == 0;
    }
    // In steps of 1 or -1, 0 where there is none: logarithmic ranges are only tried so far.
    long nearest(long step) const {
        constexpr long tried = 100;
        const long most = logarithmic_ ? count_ + tried : most_grid_values;
        for (long count = count_ + step; count >= 2 && count <= most && (step < 0 || count <= span_ + 1);
             count += step) {
            if (comes_out_whole(count)) {
                return count;
            }
        }
        return step < 0 ? 2 : 0;
    }

    std::string ends_;
    bool logarithmic_;
    long count_;
    integer span_;
};

[[noreturn]] void refuse_range(std::string_view item, const std::vector<exact>& values) {
    const std::string start = "has the range '" + std::string(item) + "', ";
    if (!is_whole(values.front()) || !is_whole(values.back())) {
        throw error(error_kind::argument, "list", "", start + "whose ends are not whole numbers from 0 on");
    }
    throw error(error_kind::argument, "list", "",
                start + "whose values are not whole; the nearest counts whose values are: " +
                    whole_range(item, values).nearest_counts());
}

void require_bound(const exact& value, long largest) {
    if (largest > 0 && value.coefficient > largest) {
        throw error(error_kind::argument, "list", "",
                    "has '" + value.text + "', which is not between 0 and " + std::to_string(largest));
    }
}

}  // namespace

std::vector<grid_item> read_grid_items(std::string_view text) {
    read_grid(text);  // complains about the list as a whole
    std::vector<grid_item> items;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view item = text.substr(begin, end - begin);
        items.push_back({read_grid(item), item.find(':') != std::string_view::npos});
        begin = end + 1;
    }
    return items;
}

std::vector<grid_item> read_whole_items(std::string_view text, long largest) {
    std::vector<grid_item> items = read_grid_items(text);
    std::size_t begin = 0;
    for (const grid_item& item : items) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (!all_whole(item.values)) {
            if (item.is_range) {
                refuse_range(text.substr(begin, end - begin), item.values);
            }
            throw error(error_kind::argument, "list", "",
                        "has '" + item.values.front().text + "', which is not a whole number");
        }
        for (const exact& value : item.values) {
            require_bound(value, largest);
        }
        begin = end + 1;
    }
    return items;
}

}  // namespace libration
