// Writes the motion files that the fuzzers start from into a folder.
#include <filesystem>
#include <fstream>

int main(int argc, char** argv) {
    if (argc != 2) {
        return 1;
    }
    const std::filesystem::path folder = argv[1];
    std::ofstream(folder / "small.bvh")
        << "HIERARCHY\r\nROOT Hips {\nOFFSET 0 0 0\nCHANNELS 6 Zrotation Xrotation Yrotation "
           "Xposition Yposition Zposition\nJOINT Left Arm\n{\nOFFSET 1 2 3\nCHANNELS 3 Xrotation "
           "Yrotation Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: 2\nFrame "
           "Time: 0.01\n1 2 3 4 5 6 7 8 9\n1 nan 3 4 5 6 7 8 -9e1\n";
    std::ofstream(folder / "mallet.csv")
        << "mallet\n250\nFrame,RX,RY,RZ,TX,TY,TZ\n,deg,deg,deg,mm,mm,mm\n"
           "1,1,2,3,10,20,30\n2,1,2,3,11,20,30\n3,,,,,,\n4,1,2,3,400,20,30\n5,1,2,3,12,20,30\n";
    std::ofstream(folder / "tips.csv") << "time_s;left_x_mm;left_y_mm;left_z_mm;qw;qx;qy;qz\n0;1;2;"
                                          "3;1;0;0;0\n0.01;1;2;3;1;0;0;0\n";
    return 0;
}
