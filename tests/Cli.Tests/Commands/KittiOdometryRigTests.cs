using System.Globalization;
using Harvester.Datasets.Sessions;
using Harvester.Geometry;

namespace Harvester.Cli.Tests.Commands;

/// <summary>
/// Reads an export of KITTI odometry by KITTI's own definitions, in which camera 0 is the reference (Geiger et al., "Vision meets
/// robotics", 2013), and compares it with the rig.
/// </summary>
public sealed class KittiOdometryRigTests : IDisposable
{
    private const string Lidar =
        "\"lidars\":[{\"name\":\"top\",\"position\":[0,0.3,1.7],\"beamsDegrees\":[0,-4,-8],\"columns\":40}]";

    /// <summary>Matrices have six decimals or more, and focal lengths are about 40 pixels.</summary>
    private const double RoundingMetres = 1e-5;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Baselines_and_scanner_are_those_of_the_rig()
    {
        Export("""{"name":"0","position":[0.0,0.6,1.65],A},{"name":"1","position":[0.5,0.6,1.65],A},"""
            + """{"name":"2","position":[-0.06,0.6,1.65],A},{"name":"3","position":[0.47,0.6,1.65],A}""");

        Assert.Equal(0.5, Baseline(0, 1), RoundingMetres);
        Assert.Equal(0.53, Baseline(2, 3), RoundingMetres);

        // Cameras look along z, with x to the right and y down. The scanner stands 0.3 m behind them and 0.05 m higher.
        AssertNear([0, -0.05, -0.3], ScannerIn(0));
        AssertNear([-0.5, -0.05, -0.3], ScannerIn(1));
        AssertNear([0.06, -0.05, -0.3], ScannerIn(2));
        AssertNear([-0.47, -0.05, -0.3], ScannerIn(3));
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
        Export("""{"name":"0","position":[0.0,0.6,1.65],A},{"name":"1","position":[0.5,0.6,1.65],A},"""
            + """{"name":"2","position":[-0.06,0.6,1.65],A},{"name":"3","position":[0.47,0.6,1.65],A}""");
        Pose[] cameras = [.. new SessionReader(_folder.PathOf("session")).ReadLabels().Where(label => label.View == "0")
            .Select(label => label.Camera.Pose)];
        double[][] poses = [.. File.ReadAllLines(_folder.PathOf("out/poses/00.txt")).Select(Numbers)];

        Assert.Equal(cameras.Length, poses.Length);
        foreach ((double[] pose, Pose camera) in poses.Zip(cameras))
        {
            Vector3D moved = cameras[0].ToLocal(camera.Position);
            AssertNear([moved.X, -moved.Z, moved.Y], [pose[3], pose[7], pose[11]], 1e-3);
        }

        Assert.NotEqual(0, poses[^1][11]);
    }

    private static double[] Numbers(string line) =>
        [.. line.Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture))];

    private static void AssertNear(double[] expected, double[] found, double tolerance = RoundingMetres) =>
        Assert.All(expected.Zip(found), pair => Assert.Equal(pair.First, pair.Second, tolerance));

    private void Export(string cameras)
    {
        string rig = _folder.File(
            "rig.json", "{\"name\":\"kitti\",\"cameras\":[" + cameras.Replace(
                "A", "\"verticalFovDegrees\":30,\"width\":80,\"height\":40", StringComparison.Ordinal) + "]," + Lidar + "}");
        CliRun.Of("harvest", "--out", _folder.PathOf("session"), "--rig", rig, "--frames", "3", "--hz", "2", "--seed", "3", "--no-report")
            .AssertDone();
        CliRun.Of("export", _folder.PathOf("session"), "--format", "kitti-odometry", "--out", _folder.PathOf("out")).AssertDone();
        CliRun.Of("validate", _folder.PathOf("out")).AssertDone();
    }

    private double[] Matrix(string name) => Numbers(File.ReadLines(_folder.PathOf("out/sequences/00/calib.txt"))
        .Single(line => line.StartsWith(name + ": ", StringComparison.Ordinal))[(name.Length + 2)..]);

    /// <summary>KITTI's T_cam0_velo is Tr; that of camera i adds P_i(0, 3) / P_i(0, 0) to its x.</summary>
    private double[] ScannerIn(int camera)
    {
        double[] p = Matrix($"P{camera}");
        double[] tr = Matrix("Tr");
        return [tr[3] + (p[3] / p[0]), tr[7], tr[11]];
    }

    /// <summary>KITTI's baseline: the distance of two cameras' origins, here in the frame of the scanner.</summary>
    private double Baseline(int left, int right) =>
        Math.Sqrt(ScannerIn(left).Zip(ScannerIn(right), (a, b) => (a - b) * (a - b)).Sum());
}
