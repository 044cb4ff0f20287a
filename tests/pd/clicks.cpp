// clicks PATCH: writes a list for Pd's qlist in which every message box of the patch and of its
// subpatches is clicked, in the order of the file and once more, 50 ms apart; then Pd quits. Not
// those that wait for a number, $1.
#include <iostream>
#include <vector>

#include "support/pd_patch.hpp"

namespace {

/// Under which name Pd hears messages for a window: the file's, or the subpatch's own.
std::string receiver(const std::string& window) {
    const auto slash = window.rfind(" / ");
    return "pd-" + (slash == std::string::npos ? window : window.substr(slash + 3));
}

}  // namespace

int main(int count, char** arguments) try {
    if (count != 2) throw std::runtime_error("usage: clicks PATCH");
    auto windows = percussionist::test::read_pd_patch(arguments[1], {});
    const auto once = windows;
    windows.insert(windows.end(), once.begin(), once.end());
    for (const auto& window : windows) {
        const std::string name = receiver(window.name);
        std::cout << name << " vis 1;\n";  // Pd lets nobody click in a window that is shut
        for (const auto& box : window.boxes) {
            if (box.kind != "msg" || box.text.find('$') != std::string::npos) continue;
            const double x = box.place.left + 3, y = box.place.top + 10;
            std::cout << "50 " << name << " mouse " << x << ' ' << y << " 1 0;\n"
                      << name << " mouseup " << x << ' ' << y << " 1;\n";
        }
    }
    std::cout << "50 pd quit;\n";
    return 0;
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
