using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Wheel tracks on asphalt and in snow, and lamps that light the road.</summary>
public sealed class RoadLookTests
{
    private const double LaneWidth = 5.4;

    /// <summary>The eye is so far above the road, metres.</summary>
    private const double EyeHeight = 1;

    /// <summary>
    /// Wheels run 0.145 lanes, or 0.78 m, beside the middle of a lane, which lies at 2.7 m.
    /// </summary>
    private const double Track = 1.92;
    private const double Middle = 2.7;

    /// <summary>Least difference between snow and the tracks in it, of 255; where both are the same, noise makes up to the other.</summary>
    private const double Distinct = 40;
    private const double Noise = 6;

    [Fact]
    public void Wheels_leave_tracks_in_snow()
    {
        RenderTarget picture = Render(Detail.Full, new Lighting { SnowFraction = 0.8 });

        double snow = BrightnessAt(picture, Middle, 3, 12);
        Assert.True(snow > BrightnessAt(picture, Track, 3, 12) + Distinct);
        Assert.True(snow > BrightnessAt(Render(Detail.Full, new Lighting()), Middle, 3, 12) + Distinct);
    }

    [Fact]
    public void Wheels_darken_asphalt()
    {
        RenderTarget picture = Render(Detail.Full, new Lighting());

        Assert.True(BrightnessAt(picture, Middle, 3, 12) > BrightnessAt(picture, Track, 3, 12) + Noise);
    }

    [Fact]
    public void Plain_detail_shows_no_tracks()
    {
        RenderTarget picture = Render(Detail.Plain, new Lighting { SnowFraction = 0.8 });

        Assert.InRange(BrightnessAt(picture, Middle, 3, 12) - BrightnessAt(picture, Track, 3, 12), -Noise, Noise);
    }

    [Theory]
    [InlineData(Detail.Plain)]
    [InlineData(Detail.Full)]
    public void Headlights_light_the_road_ahead(Detail detail)
    {
        Lighting night = Night;
        RenderTarget dark = Render(detail, night);
        RenderTarget lit = Render(detail, night, LightSource.Headlights(new Vector3D(0, 0, -0.4), new Vector3D(0, 1, 0)));

        Assert.True(BrightnessAt(lit, 0.7, 12, 18) > (2 * BrightnessAt(dark, 0.7, 12, 18)) + 10);

        // They fade: at 65 m they have no effect any more.
        Assert.Equal(BrightnessAt(dark, 0.7, 70, 90), BrightnessAt(lit, 0.7, 70, 90), 1.0);
    }

    [Fact]
    public void Street_lamp_lights_the_road_below_it_most()
    {
        RenderTarget dark = Render(Detail.Full, Night);
        RenderTarget lit = Render(Detail.Full, Night, LightSource.StreetLamp(new Vector3D(4, 15, 7)));

        double below = BrightnessAt(lit, 3, 14, 16) - BrightnessAt(dark, 3, 14, 16);
        double beyond = BrightnessAt(lit, 3, 30, 34) - BrightnessAt(dark, 3, 30, 34);
        Assert.True(below > 30, $"{below} brighter below the lamp.");
        Assert.InRange(beyond, 0.5, below / 2);
    }

    [Fact]
    public void Lamps_give_no_light_by_day()
    {
        RenderTarget day = Render(Detail.Full, new Lighting());
        RenderTarget lamps = Render(Detail.Full, new Lighting(), LightSource.StreetLamp(new Vector3D(4, 15, 7)));

        Assert.Equal(day.Colour, lamps.Colour);
    }

    private static Lighting Night =>
        new()
        {
            SunColour = default,
            AmbientColour = new Rgb(30, 30, 30),
            NightFraction = 1,
        };

    /// <summary>Mean brightness of the road so far to the right of the camera, from one distance ahead to another.</summary>
    private static double BrightnessAt(RenderTarget picture, double right, double from, double to)
    {
        // Field of view 90 degrees, 240 rows: focal length 120 px.
        const double focal = TestScene.Height / 2.0;
        const int samples = 60;
        return Enumerable
            .Range(0, samples)
            .Average(i =>
            {
                double ahead = from + ((to - from) * i / samples);
                int row = (int)((TestScene.Height / 2.0) + (focal * EyeHeight / ahead));
                int column = (int)((TestScene.Width / 2.0) + (focal * right / ahead));
                int pixel = 3 * ((row * TestScene.Width) + column);
                return (picture.Colour[pixel] + picture.Colour[pixel + 1] + picture.Colour[pixel + 2]) / 3.0;
            });
    }

    /// <summary>A road with a lane each way, seen from above its line.</summary>
    private static RenderTarget Render(Detail detail, Lighting lighting, params LightSource[] lights)
    {
        Vector3D nearLeft = new(-LaneWidth, 1, -EyeHeight);
        Vector3D nearRight = new(LaneWidth, 1, -EyeHeight);
        Vector3D farRight = new(LaneWidth, 150, -EyeHeight);
        Vector3D farLeft = new(-LaneWidth, 150, -EyeHeight);
        var asphalt = new Rgb(90, 90, 90);
        var road = new Mesh([
            new MeshTriangle(nearLeft, nearRight, farRight, asphalt, Surface.Asphalt) { Lanes = new LaneOffsets(-1, 1, 1, 0, 1) },
            new MeshTriangle(nearLeft, farRight, farLeft, asphalt, Surface.Asphalt) { Lanes = new LaneOffsets(-1, 1, -1, 0, 1) },
        ]);
        var scene = new RenderScene([TestScene.AtOrigin(road, 0)]) { Lighting = lighting with { FogDensity = 0 }, Lights = lights };

        var target = new RenderTarget(TestScene.Width, TestScene.Height);
        new Renderer(detail).Render(scene, TestScene.Camera, target);
        return target;
    }
}
