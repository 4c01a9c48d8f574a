# One interface target carries the language level, the warnings (errors, all of them) and the sanitizers.
add_library(alate_options INTERFACE)
target_compile_features(alate_options INTERFACE cxx_std_20)
target_compile_options(alate_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
  -Wcast-align -Woverloaded-virtual -Wdouble-promotion -Wimplicit-fallthrough -Werror
  # Designated initialisers leave out what stays at its default; that is their point.
  -Wno-missing-field-initializers
  # The same bits whatever instruction set a kernel is compiled for.
  -ffp-contract=off)
if(ALATE_SANITIZE)
  # Instrumented code makes gcc 12 see uninitialised values inside <regex> that are not there, and the thread sanitizer
  # does not follow the one fence in Boost.Asio.
  target_compile_options(alate_options INTERFACE
    -fsanitize=${ALATE_SANITIZE} -fno-omit-frame-pointer -Wno-maybe-uninitialized -Wno-tsan)
  target_link_options(alate_options INTERFACE -fsanitize=${ALATE_SANITIZE})
endif()
