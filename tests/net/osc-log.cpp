// [osc-log]: notes the logical time of each list and its first number; "write FILE" writes them.
#include <fstream>
#include <iomanip>
#include <vector>

#include "pdx/object.hpp"

namespace {

using namespace percussionist::pdx;

class OscLog : public Object {
  public:
    OscLog(Box& box, const Arguments&) : Object(box) { lines_.reserve(100000); }
    void list(const Arguments& a) { lines_.emplace_back(now(), a.number(0)); }
    void write(const Arguments& a) {
        std::ofstream file(a.word(0));
        for (const auto& [time, number] : lines_) {
            file << std::setprecision(12) << time << ' ' << number << '\n';
        }
    }

  private:
    std::vector<std::pair<double, double>> lines_;
};

}  // namespace

PDX_SETUP(setup_osc0x2dlog) {
    add_class(describe<OscLog>("osc-log", "a test's notes of what came when")
                  .message("list", {number("number"), anything("rest")}, "", &OscLog::list)
                  .message("write", {word("file")}, "", &OscLog::write));
}
