// Writes the texts that the fuzzers of limits, maps, gestures, modes, routes, poses and drum models
// start from into a folder.
#include <filesystem>
#include <fstream>
#include <string>

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    std::ofstream(folder / "limits")
        << "# joints\nleft_forearm euler 0 145 -10 10 -90 90\nleft_hand quaternion 1 0 0 0  1 0 0 "
           "0 1 0 0 0 1  40 30 20\n";
    std::ofstream(folder / "map") << "pelvis: Hips, pelvis # the root\nleft_forearm: mixamorig:Left"
                                     "ForeArm\nright_stick: RStick\n";
    std::ofstream(folder / "gestures")
        << "flick 0.3 2.5 1.9 2.4 0.43 recorded: a.csv\n# none\nlegato 0.40 2.4 1.9 2.4 0.43\n";
    std::ofstream(folder / "modes")
        << "percussionist modes 1\nname drum\norigin computed: so\nradius 0.22\nplaces 0 0.5 1\n"
           "mode 74.3 0.9 0 1.2 1.1 0\nheard 0.8\nmode 118.4 0.5 1 0 1e-1 0\n# end\n";
    std::ofstream(folder / "contact_route")
        << "contact to 192.168.1.5:9000 /hit velocity*0.2+0.1 r/0.33 when hand 1 1 when velocity 1 "
           "1e1";
    std::ofstream(folder / "pose_route")
        << "pose to localhost:9002 /stick x y z body when body right_stick";
    std::ofstream(folder / "poses") << "time [s],station,x [m],y [m],z [m],qw,qx,qy,qz\n"
                                       "0.008333,1,0.412,-0.03,0.221,0.9239,0,0.3827,0\n"
                                       "0.016667,2,0.412,-0.03,0.221,1,0,0,0\r\n"
                                       "0.025,1,0.412,-0.03,0.221,-1,0,0,0\n";
    std::ofstream(folder / "drums")
        << "percussionist drums 1\nlive 1\nlayer 2 2\n0.5 0.001 BAgA\n-0.5 0.001 gAgB\nfirst 1\n";
    return 0;
}
