// [realtime-mark~ 1] begins what rtcheck's guard watches, [realtime-mark~ 0] ends it; signals pass.
// [realtime-mark~ 2] allocates, [realtime-mark~ 3] makes a system call, as no perform routine may:
// to see the guard find it.
#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "pdx/object.hpp"

namespace {

using namespace percussionist::pdx;

class RealtimeMark : public Object {
  public:
    RealtimeMark(Box& box, const Arguments& creation)
        : Object(box),
          what_(creation.integer(0)),
          enter_(reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "realtime_enter"))),
          leave_(reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "realtime_leave"))) {
        if (!enter_ || !leave_) {
            throw std::runtime_error("rtcheck's guard is not preloaded");
        }
    }

    void process(const Block& block) noexcept override {
        std::copy_n(block.inputs[0], block.size, block.outputs[0]);
        if (what_ == 0) {
            leave_();
        } else if (what_ == 1) {
            enter_();
        } else if (what_ == 2) {
            memory_ = std::make_unique<int>(2);
        } else if (what_ == 3) {
            parent_ = getppid();
        }
    }

  private:
    int what_;
    void (*enter_)();
    void (*leave_)();
    std::unique_ptr<int> memory_;
    int parent_ = 0;
};

}  // namespace

PDX_SETUP(setup_realtime0x2dmark_tilde) {
    add_class(describe<RealtimeMark>("realtime-mark~", "bounds of what rtcheck watches")
                  .creation({number("what").from(0).to(3)})
                  .signal_inlet("passed on")
                  .signal_outlet("the same"));
}
