#include "app.hpp"

int main(int argc, char** argv) { return alate::cli::run(argc, argv); }
