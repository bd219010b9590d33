#include "formula_cursor.hpp"

#include "formula_refusals.hpp"

namespace libration::ode {

expression formula_cursor::before_end(const place& opened) const {
    if (next >= last) {
        refuse("(", opened, "is not closed: add a )");
    }
    expression value = sum();
    if (next >= last) {
        refuse("(", opened, "is not closed: add a )");
    }
    return value;
}

void formula_cursor::close(const place& opened) const {
    if (take(')')) {
        return;
    }
    if (next >= last) {
        refuse("(", opened, "is not closed: add a )");
    }
    refuse_token(words, next, last);
}

}  // namespace libration::ode
