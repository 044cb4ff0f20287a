// Built where Avahi's library is not.
#include "osc/announcement.hpp"

namespace percussionist::osc {

class Announcement::Avahi {};

Announcement::Announcement(int /*port*/) {}
Announcement::~Announcement() = default;

}  // namespace percussionist::osc
