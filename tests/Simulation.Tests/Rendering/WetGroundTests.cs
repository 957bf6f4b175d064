using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Wet asphalt mirrors what stands on it.</summary>
public sealed class WetGroundTests
{
    /// <summary>
    /// How much redder than green the reflection of a red wall is at least, and other ground at most, of 255: the wall's own difference is
    /// about 200, and ground at this angle reflects a tenth of it.
    /// </summary>
    private const double Reddish = 8;
    private const double NotReddish = 2;

    [Fact]
    public void Wall_is_mirrored_below_its_foot_and_no_farther()
    {
        // Field of view 90 degrees, 240 rows: focal length 120 px. The wall, 10 m ahead, stands on ground 1 m below the eye: foot at row
        // 132. It is 2 m high: its top is at row 108, and its mirrored top at row 156.
        RenderTarget wet = Render(1);

        Assert.InRange(RednessOf(wet, 136, 150), Reddish, 255);
        Assert.InRange(RednessOf(wet, 160, 175), -NotReddish, NotReddish);
    }

    [Fact]
    public void Ground_seen_below_a_body_mirrors_what_is_behind_it()
    {
        // The body, 5 m ahead, would have its foot at row 144, and its lower edge, half a metre above the ground, is at row 132: rows 132
        // to 144 show ground behind it. Its mirror image reaches from row 156 to row 192.
        RenderTarget wet = Render(1, body: new MeshBuilder().AddBox(new(-4, 5, -0.5), new(4, 5.1, 1), new Rgb(255, 40, 40)).Build());

        Assert.InRange(RednessOf(wet, 134, 142), -NotReddish, NotReddish);
        Assert.InRange(RednessOf(wet, 158, 164), Reddish, 255);
    }

    [Fact]
    public void Dry_asphalt_mirrors_nothing() => Assert.InRange(RednessOf(Render(0), 136, 150), -NotReddish, NotReddish);

    [Fact]
    public void Wet_grass_mirrors_nothing() => Assert.InRange(RednessOf(Render(1, Surface.Ground), 136, 150), -NotReddish, NotReddish);

    [Fact]
    public void Reflections_change_colours_only()
    {
        RenderTarget wet = Render(1);
        RenderTarget dry = Render(0);

        Assert.Equal(dry.Handles, wet.Handles);
        Assert.Equal(dry.Depth, wet.Depth);
    }

    private static double RednessOf(RenderTarget picture, int top, int bottom)
    {
        const int left = 150;
        const int right = 170;
        return Enumerable
            .Range(top, bottom - top)
            .SelectMany(row => Enumerable.Range((row * picture.Width) + left, right - left))
            .Average(pixel => picture.Colour[pixel * 3] - (double)picture.Colour[(pixel * 3) + 1]);
    }

    private static RenderTarget Render(double rain, Surface surface = Surface.Asphalt, Mesh? body = null)
    {
        Mesh ground = new MeshBuilder()
            .AddQuad(new(-300, 0, -1), new(300, 0, -1), new(300, 300, -1), new(-300, 300, -1), new Rgb(60, 60, 60), surface)
            .Build();
        body ??= new MeshBuilder().AddBox(new(-4, 10, -1), new(4, 11, 1), new Rgb(255, 40, 40)).Build();
        var scene = new RenderScene([TestScene.AtOrigin(ground, 0), TestScene.AtOrigin(body, 0)])
        {
            Lighting = new Lighting
            {
                SunColour = default,
                AmbientColour = TestScene.White,
                ZenithColour = new Rgb(128, 128, 128),
                HorizonColour = new Rgb(128, 128, 128),
                FogDensity = 0,
                RainFraction = rain,
            },
        };
        var target = new RenderTarget(TestScene.Width, TestScene.Height);
        new Renderer(Detail.Full).Render(scene, TestScene.Camera, target);
        return target;
    }
}
