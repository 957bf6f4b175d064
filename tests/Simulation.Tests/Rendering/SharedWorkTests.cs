using System.Runtime.Intrinsics;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>How the renderer divides its work and what it skips never shows in the picture.</summary>
public sealed class SharedWorkTests
{
    /// <summary>The power times log2 e, up to 115, is rounded to single precision: by up to 4e-6; the rest is the series.</summary>
    private const double ExpTolerance = 1e-5;

    [Fact]
    public async Task Picture_is_the_same_on_one_core_and_on_many()
    {
        RenderScene scene = TestScene.Seeded(5);
        RenderCamera camera = TestScene.SeededCamera(5);
        var oneByOne = new ConcurrentExclusiveSchedulerPair(TaskScheduler.Default, 1);

        RenderTarget many = TestScene.Render(scene, camera);
        RenderTarget one = await Task.Factory.StartNew(
            () => TestScene.Render(scene, camera),
            CancellationToken.None,
            TaskCreationOptions.None,
            oneByOne.ConcurrentScheduler
        );

        Assert.Equal(many.Colour, one.Colour);
        Assert.Equal(many.Depth, one.Depth);
        Assert.Equal(many.Handles, one.Handles);
    }

    [Fact]
    public void What_shows_past_a_wall_is_drawn()
    {
        // Field of view 90 degrees, 240 rows: focal length 120 px, centre (160, 120). The wall is 2 m high and as wide, 10 m ahead: pixels
        // 148 to 172 and 108 to 132. The box behind it, 100 m ahead, has its corners at x = +-11 m: pixels 146.8 to 173.2.
        Mesh wall = new MeshBuilder().AddBox(new(-1, 10, -1), new(1, 10.1, 1), TestScene.White).Build();
        Mesh behind = new MeshBuilder().AddBox(new(-11, 100, -5), new(11, 101, 5), TestScene.White).Build();

        RenderTarget target = TestScene.Render(TestScene.Camera, TestScene.AtOrigin(wall, 1), TestScene.AtOrigin(behind, 2));

        int row = 120 * target.Width;
        int[] columns = [145, 147, 148, 171, 172, 174];
        Assert.Equal([0, 2, 1, 1, 2, 0], columns.Select(column => target.Handles[row + column]));
    }

    [Fact]
    public void Exponential_is_within_its_tolerance()
    {
        for (float power = -80; power <= 0; power += 0.0625f)
        {
            double expected = Math.Exp(power);
            Assert.InRange(Wide.Exp(Vector256.Create(power))[3], expected * (1 - ExpTolerance), expected * (1 + ExpTolerance));
        }

        Assert.InRange(Wide.Exp(Vector256.Create(float.NegativeInfinity))[0], 0, 1e-37f);
    }
}
