#include "app/commands.hpp"

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>

#include "core/motion/bodhran_player.hpp"
#include "tracker/recorded_motion.hpp"
#include "tracker/simulated_device.hpp"

namespace percussionist::app {

namespace {

using namespace tracker;

struct Options {
    SimulatedDeviceSettings device;
    int receivers = 1;
    int baud = 0;
    double garbage = 0.0, cut = 0.0;  // [%]
    std::vector<double> silence, unplug;
    std::string play;
    std::string error;
    double duration = 0.0;
};

volatile std::sig_atomic_t stop_asked = 0;

void ask_to_stop(int) {
    stop_asked = 1;
}

void end_on_signals() {
    struct sigaction action {};
    action.sa_handler = ask_to_stop;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        sigaction(signal, &action, nullptr);
    }
}

std::optional<Span> span(const std::vector<double>& at_and_duration) {
    return at_and_duration.size() == 2 ? std::optional(Span{at_and_duration[0], at_and_duration[1]})
                                       : std::nullopt;
}

/// Whole lines of standard input, as they come; false once it says quit.
class OrderReader {
  public:
    bool read(SimulatedDevice& device, double now) {
        char bytes[256];
        const ssize_t count = ::read(STDIN_FILENO, bytes, sizeof bytes);
        open_ = count > 0;
        text_.append(bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        for (auto end = text_.find('\n'); end != std::string::npos; end = text_.find('\n')) {
            const std::string line = text_.substr(0, end);
            text_.erase(0, end + 1);
            if (line == "quit") {
                return false;
            }
            try {
                device.order(line, now);
            } catch (const std::runtime_error& e) {
                std::cerr << e.what() << std::endl;
            }
        }
        return true;
    }
    bool open() const { return open_; }

  private:
    bool open_ = true;
    std::string text_;
};

Motion motion_for(Options& options) {
    if (options.play.empty()) {
        return [player = std::make_shared<const motion::BodhranPlayer>()](
                   int station, double time) { return player->receiver(station, time); };
    }
    Recording recording = read_recording(options.play);
    options.receivers = std::max(options.receivers, recording.receivers);
    return recording.motion;
}

void run(Options options) {
    Motion motion = motion_for(options);
    options.device.unit.receivers = options.receivers;
    options.device.faults.garbage = options.garbage / 100;
    options.device.faults.cut = options.cut / 100;
    options.device.silence = span(options.silence);
    options.device.unplug = span(options.unplug);
    options.device.strict_baud = options.baud != 0;
    options.device.unit.baud = options.baud != 0 ? options.baud : 115200;
    end_on_signals();
    SimulatedDevice device(options.device, std::move(motion), [](const std::string& name) {
        std::cout << name << std::endl;  // at once: someone waits for it
    });
    if (!options.error.empty()) {
        device.order("error " + options.error, 0.0);
    }
    OrderReader orders;
    const auto start = std::chrono::steady_clock::now();
    double now = 0.0;
    while (stop_asked == 0 && (options.duration <= 0.0 || now < options.duration)) {
        pollfd waits[] = {{device.descriptor(), POLLIN, 0},
                          {orders.open() ? STDIN_FILENO : -1, POLLIN, 0}};
        const timespec half_a_millisecond{0, 500'000};
        ppoll(waits, 2, &half_a_millisecond, nullptr);
        now = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (waits[1].revents != 0 && !orders.read(device, now)) {
            break;
        }
        device.run(now);
    }
}

}  // namespace

void add_fastrak_sim_command(CLI::App& program) {
    auto options = std::make_shared<Options>();
    CLI::App* const command = program.add_subcommand(
        "fastrak-sim",
        "A simulated Polhemus FASTRAK on a pseudo-terminal, whose name it prints. It plays a "
        "bodhran player's stick (station 1), chest, left hand and head. On standard input it "
        "takes: garbage PERCENT, cut PERCENT, silence SECONDS, unplug SECONDS, baud RATE, error "
        "LETTER, quit.");
    command->add_option("--link", options->device.link, "A name for the port: a symbolic link");
    command->add_option("--receivers", options->receivers, "Receivers plugged in")
        ->check(CLI::Range(1, 4))
        ->capture_default_str();
    command->add_option("--play", options->play, "Play a recording of [fastrak~], again and again")
        ->check(CLI::ExistingFile);
    command
        ->add_option("--baud", options->baud,
                     "The unit's rate; another rate sees garbage. Without it the unit runs at "
                     "115200 and answers at any")
        ->check(CLI::IsMember({2400, 4800, 9600, 19200, 38400, 57600, 115200}));
    command->add_flag("!--no-16bit", options->device.unit.has_16bit,
                      "A newer unit: no items 18, 19 and 20");
    command->add_flag("--cosine-rows", options->device.unit.cosine_rows,
                      "Direction cosines are the matrix's rows");
    command->add_option("--garbage", options->garbage, "Garbage bytes [% of all]")
        ->check(CLI::Range(0.0, 50.0));
    command->add_option("--cut", options->cut, "Records cut short [% of all]")
        ->check(CLI::Range(0.0, 100.0));
    command->add_option("--seed", options->device.faults.seed, "Of the faults");
    command->add_option("--silence", options->silence, "AT FOR: silent from then on, so long [s]")
        ->expected(2);
    command->add_option("--unplug", options->unplug, "AT FOR: unplugged from then on, so long [s]")
        ->expected(2);
    command->add_option("--error", options->error, "A letter that every record shows, as j");
    command->add_option("--duration", options->duration, "End after so long [s]");
    command->callback([options] { run(*options); });
}

}  // namespace percussionist::app
