// `percussionist fastrak-sim` alone, for the tests of the Pd half.
#include <iostream>

#include "physics-server/app/fastrak_sim_command.hpp"

int main(int argc, char** argv) {
    CLI::App program{"The simulated FASTRAK"};
    program.require_subcommand(1);
    percussionist::app::add_fastrak_sim_command(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Error& e) {
        return program.exit(e);
    } catch (const std::exception& e) {
        std::cerr << "fastrak-sim: " << e.what() << '\n';
        return 1;
    }
    return 0;
}
