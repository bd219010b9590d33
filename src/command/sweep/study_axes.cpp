// The axes that studies of any problem may have.
#include "libration/number/exact.hpp"
#include "libration/scalar/error.hpp"
#include "sweep/study_order.hpp"

namespace libration {

namespace {

constexpr long largest_study_order = 100'000;
constexpr long largest_number_of_lists = 100'000;
constexpr long largest_digits = 10'000;

void require_digits(const exact& digits) {
    if (digits.coefficient < 1) {
        throw error(error_kind::argument, "list", "", "is less than one digit");
    }
}

void require_step(const exact& step) {
    if (step.measure != unit::one || step.coefficient <= 0) {
        throw error(error_kind::argument, "list", "", "is not a positive number");
    }
}

void require_recurrence(const exact& name) {
    for (const char* const known : {"printed", "squares", "omega", "lattice"}) {
        if (name.text == known) {
            return;
        }
    }
    throw error(error_kind::argument, "list", "",
                "has '" + name.text + "', which is not printed, squares, omega or lattice");
}

}  // namespace

const std::vector<axis>& study_axes() {
    static const std::vector<axis> all{{.name = "order",
                                        .option = "--orders",
                                        .help = "orders N",
                                        .form = axis_form::whole,
                                        .remedy = "write orders such as 5,10,20 or 5:40:8",
                                        .coordinate = "order",
                                        .largest = largest_study_order},
                                       {.name = "digits",
                                        .option = "--digits",
                                        .help = "numbers of correct digits",
                                        .form = axis_form::whole,
                                        .remedy = "write numbers such as 10,20,50",
                                        .check = require_digits,
                                        .coordinate = "digits",
                                        .largest = largest_digits},
                                       {.name = "step",
                                        .option = "--step",
                                        .help = "step of the Runge-Kutta method",
                                        .form = axis_form::one_number,
                                        .remedy = "write a step such as 1e-5",
                                        .check = require_step,
                                        .coordinate = "step"},
                                       {.name = "recurrence",
                                        .option = "--recurrence",
                                        .help = "recurrences of the pendulum's coefficients",
                                        .forms = "printed, squares, omega and lattice, with commas between them",
                                        .form = axis_form::words,
                                        .remedy = "write some of printed,squares,omega,lattice",
                                        .check = require_recurrence,
                                        .coordinate = "recurrence"},
                                       {.name = "lists",
                                        .option = "--lists",
                                        .help = "number of random lists",
                                        .form = axis_form::whole,
                                        .remedy = "write a number such as 300",
                                        .coordinate = "lists",
                                        .largest = largest_number_of_lists},
                                       {.name = "prove",
                                        .option = "--prove",
                                        .help = "proves the law of all coefficients, and prints it with them",
                                        .forms = "without an argument",
                                        .form = axis_form::words,
                                        .remedy = "write --prove without an argument",
                                        .coordinate = "prove"},
                                       {.name = "seed",
                                        .option = "--seed",
                                        .help = "number from which random lists are drawn",
                                        .form = axis_form::whole,
                                        .remedy = "write a number such as 7",
                                        .coordinate = "seed",
                                        .largest = largest_study_order}};
    return all;
}

}  // namespace libration
