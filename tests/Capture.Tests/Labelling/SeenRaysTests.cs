using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Tests.Labelling;

public sealed class SeenRaysTests
{
    private const int Ego = 1;
    private static readonly Ray Ahead = new(Vector3D.Zero, new(0, 1, 0));
    private static readonly RayHit Hit = new(10, 7);

    [Theory]
    [InlineData(10, true)]
    [InlineData(9.9, false)]
    [InlineData(500, true)]
    public void Hit_answers_every_length(double length, bool isHit)
    {
        var seen = new SeenRays();
        seen.Add(Ahead, 20, Ego, Hit);

        Assert.True(seen.TryAnswer(Ahead, length, Ego, out RayHit? hit));
        Assert.Equal(isHit ? Hit : null, hit);
    }

    [Theory]
    [InlineData(20, true)]
    [InlineData(20.1, false)]
    public void Miss_answers_lengths_up_to_its_own(double length, bool isKnown)
    {
        var seen = new SeenRays();
        seen.Add(Ahead, 20, Ego, null);

        Assert.Equal(isKnown, seen.TryAnswer(Ahead, length, Ego, out RayHit? hit));
        Assert.Null(hit);
    }

    [Fact]
    public void Other_rays_and_other_moments_are_not_known()
    {
        var seen = new SeenRays();
        seen.Add(Ahead, 20, Ego, Hit);

        Assert.False(seen.TryAnswer(new Ray(new(0, 0, 1e-9), Ahead.Direction), 20, Ego, out _));
        Assert.False(seen.TryAnswer(Ahead, 20, Ego + 1, out _));
        seen.Clear();
        Assert.False(seen.TryAnswer(Ahead, 20, Ego, out _));
    }
}
