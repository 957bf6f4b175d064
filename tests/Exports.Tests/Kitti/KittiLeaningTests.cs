using System.Globalization;
using System.Text.Json.Nodes;
using Harvester.Exports.Validation;
using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Tests.Kitti;

/// <summary>On slopes objects lean in the camera's frame, and the format's boxes stand upright in it.</summary>
public sealed class KittiLeaningTests : ExportTests
{
    /// <summary>Pixels have two decimals; metres have three, which at 8 m and a focal length of 30 pixels is less.</summary>
    private const double RoundingPixels = 0.02;

    /// <summary>Of a corner at 0.9 m and a focal length of 30 pixels, half a millimetre is 0.016 pixels.</summary>
    private const double RoundingPixelsNear = 0.05;

    private static readonly ExportOptions Cuboids = new() { Boxes = BoxKind.Cuboid };

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    [InlineData(15)]
    [InlineData(-15)]
    public void Upright_box_has_the_projected_centre_of_the_leaning_cuboid(double degrees)
    {
        Box2D truth = PitchCar(degrees);
        Folder.Export("kitti", Session.Open(), Cuboids);

        Box2D written = Written();
        Assert.InRange(Math.Abs(written.XMin + written.XMax - truth.XMin - truth.XMax) / 2, 0, RoundingPixels);
        Assert.InRange(Math.Abs(written.YMin + written.YMax - truth.YMin - truth.YMax) / 2, 0, RoundingPixels);
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(-5)]
    public void Upright_box_of_a_car_before_the_camera_stays_there(double degrees)
    {
        Box2D truth = PitchCar(degrees, metresAhead: 4);
        Folder.Export("kitti", Session.Open(), Cuboids);

        Box2D written = Written();
        Assert.InRange(Math.Abs(written.XMin + written.XMax - truth.XMin - truth.XMax) / 2, 0, RoundingPixelsNear);
        Assert.InRange(Math.Abs(written.YMin + written.YMax - truth.YMin - truth.YMax) / 2, 0, RoundingPixelsNear);
    }

    [Fact]
    public void Object_tilted_too_far_is_listed_with_its_error()
    {
        Box2D truth = PitchCar(30);
        Folder.Export("kitti", Session.Open(), Cuboids);

        string[] row = Folder.Lines("out/training/leaning.csv")[1].Split(',');
        Box2D written = Written();
        double miss = new[]
        {
            written.XMin - truth.XMin,
            written.YMin - truth.YMin,
            written.XMax - truth.XMax,
            written.YMax - truth.YMax,
        }.Max(Math.Abs);
        Assert.Equal(["file", "line", "lean_degrees", "moved_m", "miss_px"], Folder.Lines("out/training/leaning.csv")[0].Split(','));
        Assert.Equal(["000000.txt", "1", "30"], row[..3]);
        Assert.True(miss > 1);
        Assert.Equal(miss, double.Parse(row[4], CultureInfo.InvariantCulture), RoundingPixels);
    }

    [Fact]
    public void Unlisted_projection_error_is_found()
    {
        PitchCar(30);
        Folder.Export("kitti", Session.Open(), Cuboids);
        File.WriteAllText(Folder.PathOf("out/training/leaning.csv"), "file,line,lean_degrees,moved_m,miss_px\n");

        Assert.Equal(
            "training/label_2/000000.txt, line 1: its 3D box, projected with P2, does not fall onto its 2D box.",
            Assert
                .Single(DatasetValidator.Validate(Folder.PathOf("out")).Problems, problem => problem.File != "training/leaning.csv")
                .ToString()
        );
    }

    /// <summary>
    /// Puts a car of 2 x 6 x 2 m before the camera, pitched, and returns its box in KITTI's pixels: u = 39.5 + 30 x / z, v = 29.5 + 30 y /
    /// z.
    /// </summary>
    private Box2D PitchCar(double degrees, double metresAhead = 8)
    {
        (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180);
        var corners = new List<Vector2D>();
        foreach (int right in (int[])[-1, 1])
        {
            foreach (int forward in (int[])[-3, 3])
            {
                foreach (int up in (int[])[-1, 1])
                {
                    double north = metresAhead + (cos * forward) - (sin * up);
                    double height = -0.5 + (sin * forward) + (cos * up);
                    corners.Add(new Vector2D(39.5 + (30 * (1 + right) / north), 29.5 - (30 * height / north)));
                }
            }
        }

        var box = new Box2D(corners.Min(c => c.X), corners.Min(c => c.Y), corners.Max(c => c.X), corners.Max(c => c.Y));
        JsonObject car = Session.Car(0);
        car["box3d"] = new JsonObject
        {
            ["centre"] = new JsonArray(1, metresAhead, -0.5),
            ["halfExtents"] = new JsonArray(1, 3, 1),
            ["right"] = new JsonArray(1, 0, 0),
            ["forward"] = new JsonArray(0, cos, sin),
            ["up"] = new JsonArray(0, -sin, cos),
        };
        car["box2d"] = new JsonArray(box.XMin + 0.5, box.YMin + 0.5, box.XMax + 0.5, box.YMax + 0.5);
        car["box2dAmodal"] = car["box2d"]!.DeepClone();
        return box;
    }

    private Box2D Written() =>
        KittiObject
            .ReadAll(Folder.PathOf("out/training/label_2/000000.txt"))[0]
            .Project(KittiObject.ReadMatrix(Folder.PathOf("out/training/calib/000000.txt"), "P2"));
}
