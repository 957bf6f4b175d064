using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Road markings that are thinner than a pixel.</summary>
public sealed class MarkingTests
{
    /// <summary>Half the width of the line, metres: 18 px wide 1 m below the eye at a depth of 1 m, 0.18 px at 100 m.</summary>
    private const double HalfWidth = 0.075;
    private const double Focal = TestScene.Height / 2.0;

    /// <summary>
    /// Colours are rounded to 1 of 255, in up to three pixels of a row; coverage by an edge that crosses a pixel at a slant is approximate.
    /// </summary>
    private const double WidthTolerance = 0.03;

    private static readonly Lighting Flat = new()
    {
        SunColour = default,
        AmbientColour = TestScene.White,
        FogDensity = 0,
    };

    [Theory]
    [InlineData(0)]
    [InlineData(0.37)]
    [InlineData(-0.9)]
    public void Covered_width_is_the_lines_width_in_each_row(double x)
    {
        RenderTarget picture = Render(LineAlong(x));

        // The ground at row r is 120 / (r + 0.5 - 120) m ahead; between 4 and 90 m the line is 0.2 to 4.5 px wide.
        foreach (int row in Enumerable.Range(122, 28))
        {
            double depth = Focal / (row + 0.5 - (TestScene.Height / 2.0));
            double covered = CoveredIn(picture, row);

            Assert.InRange(covered, (2 * HalfWidth * Focal / depth) - WidthTolerance, (2 * HalfWidth * Focal / depth) + WidthTolerance);
        }
    }

    [Fact]
    public void Covered_height_of_a_stop_line_is_its_height()
    {
        // 1 m below the eye and 10 to 10.3 m ahead: 12 to 11.65 px below the middle.
        const double height = (Focal / 10) - (Focal / 10.3);

        RenderTarget picture = Render(Quad(new(-3, 10, -1), new(3, 10, -1), new(3, 10.3, -1), new(-3, 10.3, -1)));

        double covered = Enumerable.Range(121, 30).Sum(row => picture.Colour[((row * picture.Width) + (picture.Width / 2)) * 3] / 255.0);
        Assert.InRange(covered, height - WidthTolerance, height + WidthTolerance);
    }

    [Fact]
    public void Marking_behind_a_body_is_hidden()
    {
        Mesh body = new MeshBuilder().AddBox(new(-2, 8, -1), new(2, 9, 1), new Rgb(0, 0, 0)).Build();

        RenderTarget picture = Render(LineAlong(0), TestScene.AtOrigin(body, 1));

        // The body's foot is at row 120 + 120 / 8 = 135.
        Assert.Equal(0, CoveredIn(picture, 130), 3);
        Assert.InRange(CoveredIn(picture, 140), 1, 4);
    }

    [Fact]
    public void Body_changes_no_marking_beside_it()
    {
        // A wall whose foot is at row 122.497 hides all but a tenth of a pixel of a marking, in columns 161 to 168. A body in columns 168
        // to 178 hides all else that is farther than the marking in that part of the picture.
        var white = new Rgb(255, 255, 255);
        MeshInstance marking = Quad(new(0.5, 48.1, -1), new(4, 48.1, -1), new(4, 50, -1), new(0.5, 50, -1));
        MeshInstance wall = TestScene.AtOrigin(
            new MeshBuilder().AddQuad(new(0, 48.05, -1), new(3.2, 48.05, -1), new(3.2, 48.05, 4), new(0, 48.05, 4), white).Build(),
            1
        );
        MeshInstance body = TestScene.AtOrigin(new MeshBuilder().AddBox(new(1.33, 20, -1), new(3, 21, 2), new Rgb(0, 0, 0)).Build(), 2);
        Range beside = ((122 * TestScene.Width) + 162)..((122 * TestScene.Width) + 167);

        int[] without = [.. Render(marking, wall).Colour.Chunk(3).Take(beside).Select(pixel => (int)pixel[0])];
        int[] with = [.. Render(marking, wall, body).Colour.Chunk(3).Take(beside).Select(pixel => (int)pixel[0])];

        Assert.All(without, red => Assert.InRange(red, 1, 254));
        Assert.Equal(without, with);
    }

    [Fact]
    public void Depths_are_those_of_the_ground_below()
    {
        RenderTarget picture = Render(LineAlong(0));

        int pixel = (150 * TestScene.Width) + (TestScene.Width / 2);
        Assert.Equal(Focal / 30.5, picture.Depth[pixel], 4);
        Assert.Equal(255, picture.Colour[pixel * 3]);
    }

    private static MeshInstance LineAlong(double x) =>
        Quad(new(x - HalfWidth, 1, -1), new(x + HalfWidth, 1, -1), new(x + HalfWidth, 200, -1), new(x - HalfWidth, 200, -1));

    private static MeshInstance Quad(Vector3D a, Vector3D b, Vector3D c, Vector3D d)
    {
        Mesh line = new MeshBuilder().AddQuad(a, b, c, d, TestScene.White, Surface.Marking).Build();
        return new MeshInstance(line, new Pose(new Vector3D(0, 0, 0.002), Axes.Identity), 0);
    }

    private static double CoveredIn(RenderTarget picture, int row) =>
        Enumerable.Range(row * picture.Width, picture.Width).Sum(pixel => picture.Colour[pixel * 3] / 255.0);

    private static RenderTarget Render(params MeshInstance[] instances)
    {
        // Black ground: grain multiplies its colour.
        Mesh ground = new MeshBuilder()
            .AddQuad(new(-300, 0, -1), new(300, 0, -1), new(300, 300, -1), new(-300, 300, -1), new Rgb(0, 0, 0), Surface.Ground)
            .Build();
        var scene = new RenderScene([TestScene.AtOrigin(ground, 0), .. instances]) { Lighting = Flat };
        var target = new RenderTarget(TestScene.Width, TestScene.Height);
        new Renderer(Detail.Full).Render(scene, TestScene.Camera, target);
        return target;
    }
}
