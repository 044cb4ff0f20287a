#include "app/clip_flags.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace percussionist::app {

void add_clip_flags(CLI::App& command, ClipOptions& o) {
    static const std::map<std::string, double> units{
        {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"inch", 0.0254}, {"cmu", 0.0254 / 0.45}};
    command
        .add_option("clip", o.files,
                    "a BVH file; or a CSV file of a stick, or two: the left and the right one")
        ->required()
        ->expected(1, 2);
    command.add_option("--map", o.map,
                       "which joint is which: a file, or cmu, mixamo, perception-neuron, bandai, "
                       "biovision, poser, smpl, biped (without: the one that matches most)");
    command
        .add_option("--unit", o.unit, "of a BVH file's lengths: m, cm, mm, inch, cmu, or metres")
        ->transform(CLI::AsNumberWithUnit(units, CLI::AsNumberWithUnit::CASE_INSENSITIVE))
        ->default_str("found out");
    command.add_option("--weight", o.mass, "of the body [kg] (without: from its stature)")
        ->check(CLI::Range(10.0, 300.0));
    command.add_option("--frame-rate", o.rate, "of a CSV file that counts frames [Hz]")
        ->check(CLI::Range(1.0, 10000.0))
        ->capture_default_str();
    command.add_option("--hand", o.hand, "whose a single stick is (without: by the file's name)")
        ->check(CLI::IsMember({"left", "right"}));
    command
        .add_option("--tip-offset", o.tip_offset,
                    "of the tip from what was recorded, in the mallet's own frame: x y z [m]")
        ->expected(3);
}

}  // namespace percussionist::app
