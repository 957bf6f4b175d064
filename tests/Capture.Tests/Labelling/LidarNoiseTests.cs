using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Tests.Labelling;

public sealed class LidarNoiseTests
{
    private const int MaxShift = 200;

    [Theory]
    [InlineData("top", 100, "top", 101)]
    [InlineData("top", 100, "top", 130)]
    [InlineData("top", 0, "top", 30)]
    [InlineData("top", 100, "left", 100)]
    [InlineData("a", 100, "b", 100)]
    [InlineData("a", 100, "b", 130)]
    public void Sequences_share_no_part(string name, long frame, string otherName, long otherFrame)
    {
        // Of 1,000 independent losses with a chance of a half, 500 agree, with a standard deviation of 16.
        const int compared = 1_000;
        const int least = 400;
        bool[] one = Losses(name, frame, compared + MaxShift);
        bool[] other = Losses(otherName, otherFrame, compared + MaxShift);
        for (int shift = -MaxShift; shift <= MaxShift; shift++)
        {
            (int first, int second) = (Math.Max(shift, 0), Math.Max(-shift, 0));
            int same = Enumerable.Range(0, compared).Count(i => one[first + i] == other[second + i]);
            Assert.InRange(same, least, compared - least);
        }
    }

    [Fact]
    public void Same_moment_has_the_same_errors() => Assert.Equal(Losses("top", 7, MaxShift), Losses("top", 7, MaxShift));

    private static bool[] Losses(string name, long frame, int count)
    {
        var lidar = new RigLidar(name, new Pose(Vector3D.Zero, Axes.Identity), [0], 1, 10, 0.5, 100) { DropOutFraction = 0.5 };
        var noise = new LidarNoise(lidar, frame);
        return [.. Enumerable.Range(0, count).Select(_ => noise.IsLost())];
    }
}
