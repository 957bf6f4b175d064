using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>Turns of part of the rays compared with turns of all rays.</summary>
public sealed class SparseLidarTests(ITestOutputHelper output)
{
    /// <summary>The requirement: 10 % of the rays give 95 % of the points within 5 cm.</summary>
    private const double Metres = 0.05;
    private const double LeastFraction = 0.95;
    private const double RayFraction = 0.1;

    [Theory]
    [InlineData(41)]
    [InlineData(42)]
    [InlineData(43)]
    [InlineData(44)]
    [InlineData(45)]
    [InlineData(46)]
    [InlineData(47)]
    [InlineData(48)]
    [InlineData(49)]
    [InlineData(50)]
    [InlineData(51)]
    [InlineData(52)]
    [Trait("Category", "Heavy")]
    public void Tenth_of_the_rays_gives_the_points(int seed)
    {
        LidarModel model = LidarModel.Find("HDL-32E")!;
        var all = new RigLidar(
            "all", new Pose(new Vector3D(0, 0, 1.6), Axes.Identity), model.BeamsDegrees, model.ColumnsAt(20), 20, 0.5, model.RangeMetres);
        Rig rig = new("test", Vector3D.Zero, [RigHarvest.Camera("front", new Vector3D(0, 2, 0.4), 0, new ImageSize(64, 48))],
            [all, all with { Name = "tenth", RayFraction = RayFraction }]);
        IReadOnlyList<LidarSweep> sweeps = new RigHarvest(rig, seed).Frames[0].Sweeps;

        Dictionary<(int, int), LidarPoint> full = sweeps[0].Points.ToDictionary(point => ((int)point.Column, (int)point.Beam));
        int near = sweeps[1].Points.Count(point => full.TryGetValue((point.Column, point.Beam), out LidarPoint truth)
            && Distance(point, truth) <= Metres);
        int sameClass = sweeps[1].Points.Count(point => full.TryGetValue((point.Column, point.Beam), out LidarPoint truth) && point.Class == truth.Class);
        output.WriteLine(FormattableString.Invariant(
            $"{seed}: {sweeps[1].RaysCast} of {sweeps[0].RaysCast} rays; {near} of {full.Count} points, {near / (double)full.Count:0.0000}; ")
            + FormattableString.Invariant($"of {sweeps[1].Points.Count}, {near / (double)sweeps[1].Points.Count:0.0000}; class {sameClass / (double)sweeps[1].Points.Count:0.0000}"));

        Assert.InRange(sweeps[1].RaysCast, 1, sweeps[0].RaysCast * RayFraction);
        Assert.InRange(near / (double)full.Count, LeastFraction, 1);
    }

    private static double Distance(LidarPoint a, LidarPoint b) =>
        new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z).Length;
}
