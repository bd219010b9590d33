! Proved digits from Fortran: gfortran libration.f90 pendulum.f90 -llibration, libration.f90 from the folder of libration.h
program pendulum
    use libration
    implicit none
    type(c_ptr) :: swing, number, sampler, problem, states
    real(c_double) :: theta(3), omega(3)

    call need(libration_motion_new(c_text('theta0 = 90deg; omega0 = 0'), swing))
    call need(libration_motion_period(swing, 40_c_long, LIBRATION_PROVED, number))
    print '(3a)', 'period   ', f_text(libration_number_decimal(number))
    call libration_number_free(number)
    call need(libration_sampler_new(swing, sampler))
    call need(libration_sampler_at(sampler, 3_c_size_t, [0.0_c_double, 0.7_c_double, 1e9_c_double], theta, omega))
    print '(a,3f19.15)', 'sampler  ', theta
    call libration_sampler_free(sampler)
    call libration_motion_free(swing)

    call need(libration_problem_new(c_text('lorenz'), c_text('r = 28'), problem))
    call need(libration_problem_states(problem, c_text('1,2'), 30_c_long, LIBRATION_PROVED, c_null_funptr, &
        c_null_ptr, states))
    print '(3a)', 'x(2)     ', f_text(libration_table_text(states, 1_c_size_t, 1_c_size_t))
    call libration_table_free(states)
    call libration_problem_free(problem)

contains

    subroutine need(code)
        integer(c_int), intent(in) :: code
        if (code /= LIBRATION_OK) then
            print '(2a)', 'error: ', f_text(libration_error_message())
            stop 1
        end if
    end subroutine

end program
