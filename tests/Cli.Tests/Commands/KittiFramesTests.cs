using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>
/// Reads exports of KITTI by its own definitions, in which camera 0 is the reference (Geiger et al., "Vision meets robotics",
/// 2013), and compares them with the rig.
/// </summary>
public sealed class KittiFramesTests : IDisposable
{
    private const string Lidar = "\"lidars\":[{\"name\":\"top\",\"position\":[0,0.3,1.7],\"beamsDegrees\":[0,-4,-8],\"columns\":40}]";

    /// <summary>Matrices have six decimals or more, and focal lengths are about 40 pixels.</summary>
    private const double RoundingMetres = 1e-5;

    /// <summary>Positions have three decimals and angles four; objects are more than 2 m away.</summary>
    private const double RoundingRadians = 1e-3;

    /// <summary>The centre of an upright box may be this far from that of a cuboid that leans; the cameras are 0.6 m apart.</summary>
    private const double UprightMetres = 0.2;

    private const string FourCameras =
        """{"name":"0","position":[0.0,0.6,1.65],A},{"name":"1","position":[0.5,0.6,1.65],A},"""
        + """{"name":"2","position":[-0.6,0.6,1.65],A},{"name":"3","position":[0.4,0.6,1.65],A}""";

    private static readonly string[] Calibrations = ["out/sequences/00/calib.txt", "out/training/calib/000002.txt"];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("kitti")]
    [InlineData("kitti-odometry")]
    [Trait("Category", "Heavy")]
    public void Baselines_and_scanner_are_those_of_the_rig(string format)
    {
        Export(FourCameras, format);

        Assert.Equal(0.5, Baseline(0, 1), RoundingMetres);
        Assert.Equal(1, Baseline(2, 3), RoundingMetres);

        // Cameras look along z, with x to the right and y down. The scanner stands 0.3 m behind them and 0.05 m higher.
        AssertNear([0, -0.05, -0.3], ScannerIn(0));
        AssertNear([-0.5, -0.05, -0.3], ScannerIn(1));
        AssertNear([0.6, -0.05, -0.3], ScannerIn(2));
        AssertNear([-0.4, -0.05, -0.3], ScannerIn(3));
    }

    [Fact]
    public void Objects_of_kitti_are_in_the_frame_of_camera_0()
    {
        Export(FourCameras, "kitti");
        ILookup<int, FrameLabel> moments = new SessionReader(_folder.PathOf("session")).ReadLabels().ToLookup(label => label.Frame / 4);
        int compared = 0;
        foreach (FrameLabel[] views in moments.Select(views => views.OrderBy(label => label.Frame).ToArray()))
        {
            // The axes of a session's camera are right, forward, up; those of KITTI right, down, forward.
            double[][] expected =
            [
                .. views[2]
                    .Objects.Select(item => views[0].Camera.Pose.ToLocal(item.Box3D.Centre))
                    .Select(place => new[] { place.X, place.Y }),
            ];
            foreach (
                string[] words in File.ReadAllLines(_folder.PathOf($"out/training/label_2/{views[2].Frame:D6}.txt"))
                    .Select(line => line.Split(' '))
                    .Where(words => words[0] != "DontCare")
            )
            {
                double[] numbers = Numbers(string.Join(' ', words[1..]));
                (double alpha, double x, double z, double turn) = (numbers[2], numbers[10], numbers[12], numbers[13]);
                Assert.Contains(expected, place => Math.Abs(place[0] - x) < UprightMetres && Math.Abs(place[1] - z) < UprightMetres);
                Assert.Equal(0, Math.IEEERemainder(alpha - (turn - Math.Atan2(x, z)), Math.Tau), RoundingRadians);
                compared++;
            }
        }

        Assert.NotEqual(0, compared);
    }

    [Fact]
    public void Grey_cameras_of_a_pair_are_those_in_colour()
    {
        Export("""{"name":"l","position":[-0.06,0.6,1.65],A},{"name":"r","position":[0.47,0.6,1.65],A}""");

        Assert.Equal((0.53, 0.53), (Math.Round(Baseline(0, 1), 5), Math.Round(Baseline(2, 3), 5)));
        AssertNear(ScannerIn(2), ScannerIn(0));
    }

    [Fact]
    public void Poses_are_those_of_camera_0()
    {
        Export(FourCameras);
        Pose[] cameras =
        [
            .. new SessionReader(_folder.PathOf("session"))
                .ReadLabels()
                .Where(label => label.View == "0")
                .Select(label => label.Camera.Pose),
        ];
        double[][] poses = [.. File.ReadAllLines(_folder.PathOf("out/poses/00.txt")).Select(Numbers)];

        Assert.Equal(cameras.Length, poses.Length);
        foreach ((double[] pose, Pose camera) in poses.Zip(cameras))
        {
            Vector3D moved = cameras[0].ToLocal(camera.Position);
            AssertNear([moved.X, -moved.Z, moved.Y], [pose[3], pose[7], pose[11]], 1e-3);
        }

        Assert.NotEqual(0, poses[^1][11]);
    }

    private static double[] Numbers(string line) => [.. line.Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture))];

    private static void AssertNear(double[] expected, double[] found, double tolerance = RoundingMetres) =>
        Assert.All(expected.Zip(found), pair => Assert.Equal(pair.First, pair.Second, tolerance));

    private void Export(string cameras, string format = "kitti-odometry")
    {
        string rig = _folder.File(
            "rig.json",
            "{\"name\":\"kitti\",\"cameras\":["
                + cameras.Replace("A", "\"verticalFovDegrees\":30,\"width\":80,\"height\":40", StringComparison.Ordinal)
                + "],"
                + Lidar
                + "}"
        );
        CliRun
            .Of("harvest", "--out", _folder.PathOf("session"), "--rig", rig, "--frames", "3", "--hz", "2", "--seed", "3", "--no-report")
            .AssertDone();
        CliRun.Of("export", _folder.PathOf("session"), "--format", format, "--out", _folder.PathOf("out")).AssertDone();
        CliRun.Of("validate", _folder.PathOf("out")).AssertDone();
    }

    private double[] Matrix(params string[] names) =>
        Numbers(File.ReadLines(Calibration).Select(line => line.Split(": ")).Single(parts => names.Contains(parts[0]))[1]);

    private string Calibration => Calibrations.Select(_folder.PathOf).Single(File.Exists);

    /// <summary>KITTI's T_cam0_velo is Tr; that of another camera i adds P_i(0, 3) / P_i(0, 0) to its x.</summary>
    private double[] ScannerIn(int camera)
    {
        double[] p = Matrix($"P{camera}");
        double shift = camera == 0 ? 0 : p[3] / p[0];
        double[] tr = Matrix("Tr", "Tr_velo_to_cam");
        return [tr[3] + shift, tr[7], tr[11]];
    }

    /// <summary>KITTI's baseline: the distance of two cameras' origins, here in the frame of the scanner.</summary>
    private double Baseline(int left, int right) => Math.Sqrt(ScannerIn(left).Zip(ScannerIn(right), (a, b) => (a - b) * (a - b)).Sum());
}
