using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

public sealed class RendererTests
{
    /// <summary>Depth is stored in single precision, whose unit in the last place at 100 m is 8e-6 m.</summary>
    private const double DepthTolerance = 1e-4;

    [Fact]
    public void Render_shows_a_triangle_at_the_pixels_computed_by_hand()
    {
        // Field of view 90 degrees, 240 rows: focal length 120 px, centre (160, 120). Corners at depth 10:
        // (-1, 10, 1) -> (148, 108); (3, 10, 1) -> (196, 108); (-1, 10, -3) -> (148, 156). The hypotenuse is u + v = 304.
        Mesh mesh = new MeshBuilder().AddTriangle(new(-1, 10, 1), new(3, 10, 1), new(-1, 10, -3), TestScene.White).Build();

        RenderTarget target = TestScene.Render(TestScene.Camera, TestScene.AtOrigin(mesh, 7));

        for (int row = 0; row < target.Height; row++)
        {
            for (int column = 0; column < target.Width; column++)
            {
                double u = column + 0.5;
                double v = row + 0.5;
                bool isOnEdge = u + v == 304;
                bool expected = u > 148 && v > 108 && u + v < 304;
                if (!isOnEdge)
                {
                    Assert.Equal(expected ? 7 : 0, target.Handles[(row * target.Width) + column]);
                }
            }
        }
    }

    [Fact]
    public void Render_gives_forward_axis_depth_of_a_slanted_plane()
    {
        // Ground 2 m below a level camera: the pixel centre v looks down by (v - 120) / 120 a metre ahead, so depth = 240 / (v - 120).
        Mesh ground = new MeshBuilder()
            .AddQuad(new(-900, -900, -2), new(900, -900, -2), new(900, 900, -2), new(-900, 900, -2), TestScene.White)
            .Build();

        RenderTarget target = TestScene.Render(TestScene.Camera, TestScene.AtOrigin(ground, 0));

        for (int row = 122; row < target.Height; row++)
        {
            for (int column = 0; column < target.Width; column += 13)
            {
                double expected = 240 / (row + 0.5 - 120);
                Assert.InRange(target.Depth[(row * target.Width) + column], expected - DepthTolerance, expected + DepthTolerance);
            }
        }

        Assert.Equal(float.PositiveInfinity, target.Depth[(100 * target.Width) + 100]);
    }

    [Theory]
    [InlineData(1.5, true)]
    [InlineData(2.5, false)]
    public void Render_draws_nothing_nearer_than_the_near_plane(double nearClip, bool isSeen)
    {
        Mesh wall = new MeshBuilder().AddQuad(new(-9, 2, -9), new(9, 2, -9), new(9, 2, 9), new(-9, 2, 9), TestScene.White).Build();

        RenderTarget target = TestScene.Render(TestScene.Camera with { NearClip = nearClip }, TestScene.AtOrigin(wall, 5));

        Assert.All(target.Handles, handle => Assert.Equal(isSeen ? 5 : 0, handle));
    }

    [Fact]
    public void Render_cuts_a_triangle_that_crosses_the_near_plane()
    {
        // A strip of ground 1 m below that runs from behind the camera to ahead; near plane 0.8 m, where it appears at
        // v = 120 + 120 / 0.8 = 270, below the image; with 2 m at v = 180, and rows below that see through to nothing.
        Mesh strip = new MeshBuilder().AddQuad(new(-1, -50, -1), new(1, -50, -1), new(1, 50, -1), new(-1, 50, -1), TestScene.White).Build();

        RenderTarget target = TestScene.Render(TestScene.Camera with { NearClip = 2 }, TestScene.AtOrigin(strip, 5));

        Assert.Equal(5, target.Handles[(179 * target.Width) + 160]);
        Assert.Equal(0, target.Handles[(180 * target.Width) + 160]);
        Assert.InRange(target.Depth[(179 * target.Width) + 160], 2, 2 + (120 / 59.5) - 2 + DepthTolerance);
    }

    [Fact]
    public void Render_leaves_no_gap_between_triangles_that_share_edges()
    {
        var random = new Random(11);
        var builder = new MeshBuilder();
        var grid = new Vector3D[20, 20];
        for (int i = 0; i < 20; i++)
        {
            for (int j = 0; j < 20; j++)
            {
                bool isInside = i is > 0 and < 19 && j is > 0 and < 19;
                grid[i, j] = new(
                    i - 9.5 + (isInside ? random.NextDouble() * 0.7 : 0),
                    5,
                    j - 9.5 + (isInside ? random.NextDouble() * 0.7 : 0)
                );
            }
        }

        for (int i = 0; i < 19; i++)
        {
            for (int j = 0; j < 19; j++)
            {
                builder.AddQuad(grid[i, j], grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1], TestScene.White);
            }
        }

        RenderTarget target = TestScene.Render(TestScene.Camera, TestScene.AtOrigin(builder.Build(), 3));

        Assert.All(target.Handles, handle => Assert.Equal(3, handle));
    }

    [Fact]
    public void Render_shows_the_nearer_of_two_whatever_their_order()
    {
        Mesh near = new MeshBuilder().AddBox(new(-1, 9, -1), new(1, 10, 1), TestScene.White).Build();
        Mesh far = new MeshBuilder().AddBox(new(-5, 20, -5), new(5, 21, 5), TestScene.White).Build();

        RenderTarget a = TestScene.Render(TestScene.Camera, TestScene.AtOrigin(near, 1), TestScene.AtOrigin(far, 2));
        RenderTarget b = TestScene.Render(TestScene.Camera, TestScene.AtOrigin(far, 2), TestScene.AtOrigin(near, 1));

        Assert.Equal(a.Handles, b.Handles);
        Assert.Equal(1, a.Handles[(120 * a.Width) + 160]);
        Assert.Equal(2, a.Handles[(120 * a.Width) + 180]);
    }

    [Theory]
    [InlineData("clear", 14)]
    [InlineData("rain", 12)]
    [InlineData("snow", 22)]
    public void Render_gives_the_same_bytes_for_the_same_scene(string weather, double hour)
    {
        RenderTarget Picture()
        {
            RenderScene scene = TestScene.Seeded(4);
            scene.Lighting = Weather.LightingOf(weather, 121, TimeSpan.FromHours(hour)) with { PrecipitationSeed = 9 };
            scene.Lights = [LightSource.StreetLamp(new(0, 12, 6)), LightSource.Headlights(new(0, 1, 0), new(0, 1, 0))];
            return TestScene.Render(scene, TestScene.SeededCamera(4));
        }

        RenderTarget first = Picture();
        RenderTarget second = Picture();

        Assert.Equal(first.Colour, second.Colour);
        Assert.Equal(first.Handles, second.Handles);
        Assert.Equal(first.Depth, second.Depth);
    }

    [Fact]
    public void Render_shows_weather_and_hour_in_the_colours_only()
    {
        RenderScene scene = TestScene.Seeded(4);
        RenderTarget day = TestScene.Render(scene, TestScene.Camera);
        double dayBrightness = day.Colour.Average(value => value);
        scene.Lighting = Weather.LightingOf("clear", 121, TimeSpan.FromHours(23));
        RenderTarget night = TestScene.Render(scene, TestScene.Camera);

        Assert.True(night.Colour.Average(value => value) < dayBrightness / 3, "A night is darker than a third of the day.");
        Assert.Equal(day.Handles, night.Handles);
        Assert.Equal(day.Depth, night.Depth);
    }

    [Fact]
    public void Render_into_a_target_of_another_size_is_refused()
    {
        Assert.Throws<ArgumentException>(() => new Renderer().Render(new RenderScene([]), TestScene.Camera, new RenderTarget(10, 10)));
    }
}
