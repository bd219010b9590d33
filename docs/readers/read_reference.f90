! Reads results/reference_problems/NAME.txt into real(16), 33 digits: gfortran read_reference.f90; ./a.out < NAME.txt
program read_reference
    implicit none
    integer, parameter :: quad = selected_real_kind(33)
    character(65536) :: line, names
    real(quad), allocatable :: row(:)
    integer :: status, i
    do
        read (*, '(a)', iostat=status) line
        if (status /= 0) exit
        if (line(1:1) == '#') then
            names = line(2:)  ! the last comment names the columns
            cycle
        end if
        if (.not. allocated(row)) allocate (row(count([(names(i:i) /= ' ' .and. names(i + 1:i + 1) == ' ', i = 1, 65535)])))
        read (line, *) row
        write (*, '(*(es44.33e3))') row
    end do
end program
