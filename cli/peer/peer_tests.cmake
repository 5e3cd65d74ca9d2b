# SPDX-License-Identifier: MIT
# Label peer: the program against R's spatstat. Optional: without Rscript or spatstat the tests show as skipped. On
# Debian: r-base-core r-cran-spatstat.explore r-cran-spatstat.geom r-cran-spatstat.random r-cran-spatstat.data
# r-cran-jsonlite. spatstat is GPL, and stays a separate program.
find_program(RSCRIPT Rscript)
mark_as_advanced(RSCRIPT)

# A test of a given NAME; further arguments go to the script.
function(phytobench_spatstat_test NAME)
  if(RSCRIPT)
    add_test(NAME ${NAME} COMMAND ${RSCRIPT} --vanilla ${CMAKE_CURRENT_SOURCE_DIR}/peer/compare_with_spatstat.R
                                  $<TARGET_FILE:phytobench> ${ARGN})
  else()
    # Registered all the same, so that what is left out shows.
    add_test(NAME ${NAME} COMMAND sh -c "echo 'skipped: Rscript was not found'; exit 77")
  endif()
  set_tests_properties(${NAME} PROPERTIES LABELS peer SKIP_RETURN_CODE 77 TIMEOUT 300)
endfunction()

phytobench_spatstat_test(peer_spatstat)
# The checker must notice what is wrong: here one moved point in every pattern that the program gets.
phytobench_spatstat_test(peer_spatstat_notices_a_moved_point --moved)
