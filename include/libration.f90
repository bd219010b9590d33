! The C interface of Libration, libration.h, for Fortran 2003 and later: compile this file with your program and link
! -llibration. The functions are documented in libration.h. Handles are type(c_ptr); texts are passed as c_text('1.71')
! and converted back by f_text(). Where libration.h allows NULL, pass c_text('') for a text and c_null_funptr for a
! callback.
module libration
    use, intrinsic :: iso_c_binding
    implicit none

    integer(c_int), parameter :: LIBRATION_OK = 0, LIBRATION_ARGUMENT = 1, LIBRATION_RANGE = 2, &
        LIBRATION_UNDECIDED = 3, LIBRATION_CANCELLED = 4, LIBRATION_NO_MEMORY = 5, LIBRATION_FAULT = 6
    integer(c_int), parameter :: LIBRATION_HEURISTIC = 0, LIBRATION_ROUNDED = 1, LIBRATION_PROVED = 2

    interface
        function libration_version() bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_version
        end function
        function libration_error_message() bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_error_message
        end function
        function libration_error_subject() bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_error_subject
        end function
        function libration_error_value() bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_error_value
        end function
        function libration_error_reason() bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_error_reason
        end function
        function libration_number_read(text, digits, number) bind(c)
            import :: c_char, c_long, c_ptr, c_int
            integer(c_int) :: libration_number_read
            character(kind=c_char), intent(in) :: text(*)
            integer(c_long), value :: digits
            type(c_ptr), intent(out) :: number
        end function
        function libration_number_of(decimal, uncertainty, rigour, number) bind(c)
            import :: c_char, c_int, c_ptr
            integer(c_int) :: libration_number_of
            character(kind=c_char), intent(in) :: decimal(*)
            character(kind=c_char), intent(in) :: uncertainty(*)
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: number
        end function
        function libration_exact_text(mantissa, exponent, text, size) bind(c)
            import :: c_char, c_long, c_size_t, c_int
            integer(c_int) :: libration_exact_text
            character(kind=c_char), intent(in) :: mantissa(*)
            integer(c_long), value :: exponent
            character(kind=c_char), intent(out) :: text(*)
            integer(c_size_t), value :: size
        end function
        function libration_number_decimal(number) bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_number_decimal
            type(c_ptr), value :: number
        end function
        function libration_number_uncertainty(number) bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_number_uncertainty
            type(c_ptr), value :: number
        end function
        function libration_number_rigour(number) bind(c)
            import :: c_ptr, c_int
            integer(c_int) :: libration_number_rigour
            type(c_ptr), value :: number
        end function
        function libration_number_double(number, nearest) bind(c)
            import :: c_ptr, c_double, c_int
            integer(c_int) :: libration_number_double
            type(c_ptr), value :: number
            real(c_double), intent(out) :: nearest
        end function
        function libration_number_bounds(number, lower, upper) bind(c)
            import :: c_ptr, c_double, c_int
            integer(c_int) :: libration_number_bounds
            type(c_ptr), value :: number
            real(c_double), intent(out) :: lower
            real(c_double), intent(out) :: upper
        end function
        function libration_number_exact(number, mantissa, size, exponent, radius, radius_exponent) bind(c)
            import :: c_ptr, c_char, c_size_t, c_long, c_int
            integer(c_int) :: libration_number_exact
            type(c_ptr), value :: number
            character(kind=c_char), intent(out) :: mantissa(*)
            integer(c_size_t), value :: size
            integer(c_long), intent(out) :: exponent
            integer(c_long), intent(out) :: radius
            integer(c_long), intent(out) :: radius_exponent
        end function
        function libration_number_mantissa_size(number) bind(c)
            import :: c_ptr, c_size_t
            integer(c_size_t) :: libration_number_mantissa_size
            type(c_ptr), value :: number
        end function
        subroutine libration_number_free(number) bind(c)
            import :: c_ptr
            type(c_ptr), value :: number
        end subroutine
        function libration_table_rows(table) bind(c)
            import :: c_ptr, c_size_t
            integer(c_size_t) :: libration_table_rows
            type(c_ptr), value :: table
        end function
        function libration_table_columns(table) bind(c)
            import :: c_ptr, c_size_t
            integer(c_size_t) :: libration_table_columns
            type(c_ptr), value :: table
        end function
        function libration_table_name(table, column) bind(c)
            import :: c_ptr, c_size_t
            type(c_ptr) :: libration_table_name
            type(c_ptr), value :: table
            integer(c_size_t), value :: column
        end function
        function libration_table_text(table, row, column) bind(c)
            import :: c_ptr, c_size_t
            type(c_ptr) :: libration_table_text
            type(c_ptr), value :: table
            integer(c_size_t), value :: row
            integer(c_size_t), value :: column
        end function
        function libration_table_number(table, row, column) bind(c)
            import :: c_ptr, c_size_t
            type(c_ptr) :: libration_table_number
            type(c_ptr), value :: table
            integer(c_size_t), value :: row
            integer(c_size_t), value :: column
        end function
        subroutine libration_table_free(table) bind(c)
            import :: c_ptr
            type(c_ptr), value :: table
        end subroutine
        function libration_motion_new(given, motion) bind(c)
            import :: c_char, c_ptr, c_int
            integer(c_int) :: libration_motion_new
            character(kind=c_char), intent(in) :: given(*)
            type(c_ptr), intent(out) :: motion
        end function
        function libration_motion_regime(motion) bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_motion_regime
            type(c_ptr), value :: motion
        end function
        function libration_motion_theta(motion, time, digits, rigour, theta) bind(c)
            import :: c_ptr, c_char, c_long, c_int
            integer(c_int) :: libration_motion_theta
            type(c_ptr), value :: motion
            character(kind=c_char), intent(in) :: time(*)
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: theta
        end function
        function libration_motion_omega(motion, time, digits, rigour, omega) bind(c)
            import :: c_ptr, c_char, c_long, c_int
            integer(c_int) :: libration_motion_omega
            type(c_ptr), value :: motion
            character(kind=c_char), intent(in) :: time(*)
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: omega
        end function
        function libration_motion_states(motion, times, digits, rigour, watch, context, states) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_motion_states
            type(c_ptr), value :: motion
            character(kind=c_char), intent(in) :: times(*)
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: states
        end function
        function libration_motion_period(motion, digits, rigour, period) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_motion_period
            type(c_ptr), value :: motion
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: period
        end function
        function libration_motion_effective_period(motion, digits, rigour, period) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_motion_effective_period
            type(c_ptr), value :: motion
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: period
        end function
        function libration_motion_energy(motion, digits, rigour, energy) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_motion_energy
            type(c_ptr), value :: motion
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: energy
        end function
        function libration_motion_gap(motion, digits, rigour, gap) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_motion_gap
            type(c_ptr), value :: motion
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: gap
        end function
        function libration_motion_radius(motion, point, digits, rigour, radius) bind(c)
            import :: c_ptr, c_char, c_long, c_int
            integer(c_int) :: libration_motion_radius
            type(c_ptr), value :: motion
            character(kind=c_char), intent(in) :: point(*)
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: radius
        end function
        function libration_motion_coefficients(motion, point, first, last, digits, rigour, coefficients) bind(c)
            import :: c_ptr, c_char, c_long, c_int
            integer(c_int) :: libration_motion_coefficients
            type(c_ptr), value :: motion
            character(kind=c_char), intent(in) :: point(*)
            integer(c_long), value :: first
            integer(c_long), value :: last
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: coefficients
        end function
        subroutine libration_motion_free(motion) bind(c)
            import :: c_ptr
            type(c_ptr), value :: motion
        end subroutine
        function libration_problem_new(text, settings, problem) bind(c)
            import :: c_char, c_ptr, c_int
            integer(c_int) :: libration_problem_new
            character(kind=c_char), intent(in) :: text(*)
            character(kind=c_char), intent(in) :: settings(*)
            type(c_ptr), intent(out) :: problem
        end function
        function libration_problem_size(problem) bind(c)
            import :: c_ptr, c_size_t
            integer(c_size_t) :: libration_problem_size
            type(c_ptr), value :: problem
        end function
        function libration_problem_name(problem, i) bind(c)
            import :: c_ptr, c_size_t
            type(c_ptr) :: libration_problem_name
            type(c_ptr), value :: problem
            integer(c_size_t), value :: i
        end function
        function libration_problem_states(problem, times, digits, rigour, watch, context, states) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_states
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: times(*)
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: states
        end function
        function libration_problem_known_states(problem, times, digits, rigour, watch, context, states) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_known_states
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: times(*)
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: states
        end function
        function libration_problem_derivatives(problem, times, numbers, digits, watch, context, derivatives) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_derivatives
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: times(*)
            character(kind=c_char), intent(in) :: numbers(*)
            integer(c_long), value :: digits
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: derivatives
        end function
        function libration_problem_coefficients(problem, point, corners, first, &
            last, digits, rigour, coefficients) bind(c)
            import :: c_ptr, c_char, c_long, c_int
            integer(c_int) :: libration_problem_coefficients
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: point(*)
            character(kind=c_char), intent(in) :: corners(*)
            integer(c_long), value :: first
            integer(c_long), value :: last
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: coefficients
        end function
        function libration_problem_fractions(problem, first, last, coefficients) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_problem_fractions
            type(c_ptr), value :: problem
            integer(c_long), value :: first
            integer(c_long), value :: last
            type(c_ptr), intent(out) :: coefficients
        end function
        function libration_problem_radius(problem, last, digits, tests) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_problem_radius
            type(c_ptr), value :: problem
            integer(c_long), value :: last
            integer(c_long), value :: digits
            type(c_ptr), intent(out) :: tests
        end function
        function libration_problem_radius_bounds(problem, digits, lower, upper) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_problem_radius_bounds
            type(c_ptr), value :: problem
            integer(c_long), value :: digits
            type(c_ptr), intent(out) :: lower
            type(c_ptr), intent(out) :: upper
        end function
        function libration_problem_singularities(problem, within, digits, rigour, singularities, complete) bind(c)
            import :: c_ptr, c_char, c_long, c_int
            integer(c_int) :: libration_problem_singularities
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: within(*)
            integer(c_long), value :: digits
            integer(c_int), value :: rigour
            type(c_ptr), intent(out) :: singularities
            integer(c_int), intent(out) :: complete
        end function
        function libration_problem_limits(problem, digits, limits) bind(c)
            import :: c_ptr, c_long, c_int
            integer(c_int) :: libration_problem_limits
            type(c_ptr), value :: problem
            integer(c_long), value :: digits
            type(c_ptr), intent(out) :: limits
        end function
        function libration_problem_enclosures(problem, times, most_parts, digits, watch, context, bounds) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_enclosures
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: times(*)
            integer(c_long), value :: most_parts
            integer(c_long), value :: digits
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: bounds
        end function
        function libration_problem_enclosed_events(problem, condition, count, most_parts, digits, watch, context, &
                                                   bounds) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_enclosed_events
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: condition(*)
            integer(c_long), value :: count
            integer(c_long), value :: most_parts
            integer(c_long), value :: digits
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: bounds
        end function
        function libration_problem_find(problem, unknowns, conditions, digits, watch, context, values) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_find
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: unknowns(*)
            character(kind=c_char), intent(in) :: conditions(*)
            integer(c_long), value :: digits
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: values
        end function
        function libration_problem_branch(problem, unknowns, conditions, along, digits, watch, context, points) bind(c)
            import :: c_ptr, c_char, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_branch
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: unknowns(*)
            character(kind=c_char), intent(in) :: conditions(*)
            character(kind=c_char), intent(in) :: along(*)
            integer(c_long), value :: digits
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: points
        end function
        function libration_problem_orbit(problem, digits, watch, context, orbit) bind(c)
            import :: c_ptr, c_long, c_int, c_funptr
            integer(c_int) :: libration_problem_orbit
            type(c_ptr), value :: problem
            integer(c_long), value :: digits
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: orbit
        end function
        subroutine libration_problem_free(problem) bind(c)
            import :: c_ptr
            type(c_ptr), value :: problem
        end subroutine
        function libration_catalogue_size() bind(c)
            import :: c_size_t
            integer(c_size_t) :: libration_catalogue_size
        end function
        function libration_catalogue_name(i) bind(c)
            import :: c_size_t, c_ptr
            type(c_ptr) :: libration_catalogue_name
            integer(c_size_t), value :: i
        end function
        function libration_catalogue_text(i) bind(c)
            import :: c_size_t, c_ptr
            type(c_ptr) :: libration_catalogue_text
            integer(c_size_t), value :: i
        end function
        function libration_list_radius(coefficients, digits, tests) bind(c)
            import :: c_char, c_long, c_ptr, c_int
            integer(c_int) :: libration_list_radius
            character(kind=c_char), intent(in) :: coefficients(*)
            integer(c_long), value :: digits
            type(c_ptr), intent(out) :: tests
        end function
        function libration_motion_verify(motion, names, times, values, rules, watch, context, compared) bind(c)
            import :: c_ptr, c_char, c_funptr, c_int
            integer(c_int) :: libration_motion_verify
            type(c_ptr), value :: motion
            character(kind=c_char), intent(in) :: names(*)
            character(kind=c_char), intent(in) :: times(*)
            character(kind=c_char), intent(in) :: values(*)
            character(kind=c_char), intent(in) :: rules(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: compared
        end function
        function libration_problem_verify(problem, names, times, values, rules, watch, context, compared) bind(c)
            import :: c_ptr, c_char, c_funptr, c_int
            integer(c_int) :: libration_problem_verify
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: names(*)
            character(kind=c_char), intent(in) :: times(*)
            character(kind=c_char), intent(in) :: values(*)
            character(kind=c_char), intent(in) :: rules(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: compared
        end function
        function libration_motion_verify_doubles(motion, names, rows, times, &
            values, rules, watch, context, compared) bind(c)
            import :: c_ptr, c_char, c_size_t, c_double, c_funptr, c_int
            integer(c_int) :: libration_motion_verify_doubles
            type(c_ptr), value :: motion
            character(kind=c_char), intent(in) :: names(*)
            integer(c_size_t), value :: rows
            real(c_double), intent(in) :: times(*)
            real(c_double), intent(in) :: values(*)
            character(kind=c_char), intent(in) :: rules(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: compared
        end function
        function libration_problem_verify_doubles(problem, names, rows, times, &
            values, rules, watch, context, compared) bind(c)
            import :: c_ptr, c_char, c_size_t, c_double, c_funptr, c_int
            integer(c_int) :: libration_problem_verify_doubles
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: names(*)
            integer(c_size_t), value :: rows
            real(c_double), intent(in) :: times(*)
            real(c_double), intent(in) :: values(*)
            character(kind=c_char), intent(in) :: rules(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: compared
        end function
        function libration_sampler_new(motion, sampler) bind(c)
            import :: c_ptr, c_int
            integer(c_int) :: libration_sampler_new
            type(c_ptr), value :: motion
            type(c_ptr), intent(out) :: sampler
        end function
        function libration_sampler_at(sampler, count, times, theta, omega) bind(c)
            import :: c_ptr, c_size_t, c_double, c_int
            integer(c_int) :: libration_sampler_at
            type(c_ptr), value :: sampler
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: times(*)
            real(c_double), intent(out) :: theta(*)
            real(c_double), intent(out) :: omega(*)
        end function
        subroutine libration_sampler_free(sampler) bind(c)
            import :: c_ptr
            type(c_ptr), value :: sampler
        end subroutine
        function libration_problem_events(problem, condition, count, digits, events) bind(c)
            import :: c_ptr, c_char, c_long, c_int
            integer(c_int) :: libration_problem_events
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: condition(*)
            integer(c_long), value :: count
            integer(c_long), value :: digits
            type(c_ptr), intent(out) :: events
        end function
        function libration_problem_certificate(problem, times, digits, path, watch, context, states) bind(c)
            import :: c_ptr, c_char, c_long, c_funptr, c_int
            integer(c_int) :: libration_problem_certificate
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: times(*)
            integer(c_long), value :: digits
            character(kind=c_char), intent(in) :: path(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: states
        end function
        function libration_problem_event_certificate(problem, condition, count, digits, path, watch, context, events) &
            bind(c)
            import :: c_ptr, c_char, c_long, c_funptr, c_int
            integer(c_int) :: libration_problem_event_certificate
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: condition(*)
            integer(c_long), value :: count
            integer(c_long), value :: digits
            character(kind=c_char), intent(in) :: path(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: events
        end function
        function libration_problem_find_certificate(problem, unknowns, conditions, digits, path, watch, context, values) &
            bind(c)
            import :: c_ptr, c_char, c_long, c_funptr, c_int
            integer(c_int) :: libration_problem_find_certificate
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: unknowns(*)
            character(kind=c_char), intent(in) :: conditions(*)
            integer(c_long), value :: digits
            character(kind=c_char), intent(in) :: path(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: values
        end function
        function libration_problem_orbit_certificate(problem, digits, path, watch, context, orbit) bind(c)
            import :: c_ptr, c_char, c_long, c_funptr, c_int
            integer(c_int) :: libration_problem_orbit_certificate
            type(c_ptr), value :: problem
            integer(c_long), value :: digits
            character(kind=c_char), intent(in) :: path(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            type(c_ptr), intent(out) :: orbit
        end function
        function libration_problem_flow(problem, begin, solutions, starts, count, times, watch, context, values) bind(c)
            import :: c_ptr, c_size_t, c_double, c_int, c_funptr
            integer(c_int) :: libration_problem_flow
            type(c_ptr), value :: problem
            real(c_double), value :: begin
            integer(c_size_t), value :: solutions
            real(c_double), intent(in) :: starts(*)
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: times(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            real(c_double), intent(out) :: values(*)
        end function
        function libration_problem_varied_flow(problem, names, numbers, begin, solutions, starts, count, times, watch, &
                context, values) bind(c)
            import :: c_ptr, c_char, c_size_t, c_double, c_int, c_funptr
            integer(c_int) :: libration_problem_varied_flow
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: names(*)
            real(c_double), intent(in) :: numbers(*)
            real(c_double), value :: begin
            integer(c_size_t), value :: solutions
            type(c_ptr), value :: starts
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: times(*)
            type(c_funptr), value :: watch
            type(c_ptr), value :: context
            real(c_double), intent(out) :: values(*)
        end function
        function libration_problem_start(problem, time, values) bind(c)
            import :: c_ptr, c_double, c_int
            integer(c_int) :: libration_problem_start
            type(c_ptr), value :: problem
            real(c_double), intent(out) :: time
            real(c_double), intent(out) :: values(*)
        end function
        function libration_steps_new(problem, begin, start, end, steps) bind(c)
            import :: c_ptr, c_double, c_int
            integer(c_int) :: libration_steps_new
            type(c_ptr), value :: problem
            real(c_double), value :: begin
            real(c_double), intent(in) :: start(*)
            real(c_double), value :: end
            type(c_ptr), intent(out) :: steps
        end function
        function libration_steps_count(steps) bind(c)
            import :: c_ptr, c_size_t
            integer(c_size_t) :: libration_steps_count
            type(c_ptr), value :: steps
        end function
        function libration_steps_order(steps) bind(c)
            import :: c_ptr, c_size_t
            integer(c_size_t) :: libration_steps_order
            type(c_ptr), value :: steps
        end function
        function libration_steps_times(steps) bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_steps_times
            type(c_ptr), value :: steps
        end function
        function libration_steps_coefficients(steps) bind(c)
            import :: c_ptr
            type(c_ptr) :: libration_steps_coefficients
            type(c_ptr), value :: steps
        end function
        subroutine libration_steps_free(steps) bind(c)
            import :: c_ptr
            type(c_ptr), value :: steps
        end subroutine
    end interface

contains

    ! A Fortran text as a C string.
    pure function c_text(text) result(ended)
        character(len=*), intent(in) :: text
        character(kind=c_char) :: ended(len(text) + 1)
        integer :: i
        do i = 1, len(text)
            ended(i) = text(i:i)
        end do
        ended(len(text) + 1) = c_null_char
    end function

    ! A C string as a Fortran text.
    function f_text(from) result(text)
        type(c_ptr), intent(in) :: from
        character(len=:), allocatable :: text
        character(kind=c_char), pointer :: letters(:)
        integer :: i, length
        call c_f_pointer(from, letters, [huge(0)])
        length = 0
        do while (letters(length + 1) /= c_null_char)
            length = length + 1
        end do
        allocate(character(len=length) :: text)
        do i = 1, length
            text(i:i) = letters(i)
        end do
    end function

end module
