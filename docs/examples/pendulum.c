/* Proved digits from C: cc -std=c99 pendulum.c $(pkg-config --cflags --libs libration) */
#include <libration.h>
#include <stdio.h>
#include <stdlib.h>

/* Ends the program where a call failed. */
static void need(int code) {
    if (code != LIBRATION_OK) {
        fprintf(stderr, "error %d: %s\n", code, libration_error_message());
        exit(1);
    }
}

static void show(const char *name, libration_number *number) {
    printf("%-8s %s +- %s\n", name, libration_number_decimal(number), libration_number_uncertainty(number));
    libration_number_free(number);
}

static void motion(void) {
    const double times[] = {0, 0.7, 1e9};
    double theta[3];
    double omega[3];
    libration_motion *swing;
    libration_number *number;
    libration_sampler *sampler;
    need(libration_motion_new("theta0 = 90deg; omega0 = 0", &swing));
    need(libration_motion_period(swing, 40, LIBRATION_PROVED, &number));
    show("period", number);
    need(libration_motion_theta(swing, "1e12", 40, LIBRATION_PROVED, &number));
    show("theta", number);
    need(libration_sampler_new(swing, &sampler));
    need(libration_sampler_at(sampler, 3, times, theta, omega));
    printf("sampler  %.15g %.15g %.15g\n", theta[0], theta[1], theta[2]);
    libration_sampler_free(sampler);
    libration_motion_free(swing);
}

static void equation(void) {
    libration_problem *tangent;
    libration_table *states;
    libration_table *terms;
    libration_number *lower;
    libration_number *upper;
    need(libration_problem_new("x' = a + x^2; x(0) = 0; a = 2", "a = 1", &tangent));
    need(libration_problem_states(tangent, "pi/4,1", 30, LIBRATION_PROVED, NULL, NULL, &states));
    printf("x(pi/4)  %s\n", libration_table_text(states, 0, 1));
    printf("x(1)     %s\n", libration_table_text(states, 1, 1));
    need(libration_problem_fractions(tangent, 0, 7, &terms));
    printf("a_7      %s\n", libration_table_text(terms, 7, 1));
    need(libration_problem_radius_bounds(tangent, 10, &lower, &upper));
    show("R >=", lower);
    show("R <=", upper);
    libration_table_free(states);
    libration_table_free(terms);
    libration_problem_free(tangent);
}

int main(void) {
    motion();
    equation();
    return 0;
}
