using System.Windows.Forms;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Tests.Faces.Survey;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

public sealed class SurveyPhotoTests
{
    private const string Sign = "prop_sign_road_03g";

    [Theory]
    [InlineData("plate")]
    [InlineData("beside")]
    [InlineData("ahead")]
    public void Measured_cuboid_lies_on_the_plate_in_the_photographs(string shape)
    {
        var screen = new RenderedScreen();
        using var driver = new ScriptDriver(screen: screen);
        screen.Game = driver.Game;
        driver.Game.Props[Sign] = KnownProps.All[shape];
        driver.Press(Keys.Multiply);
        driver.UntilMessage("are surveyed");

        driver.WaitForDisk();
        string folder = Path.Combine(driver.Output, "spaces");
        ModelFace face = Assert.Single(new SurveyFolder(folder).Table.Of(Sign));
        foreach (SurveyPhoto photo in SurveyPhoto.ReadAll(folder))
        {
            TestPngDecoder picture = TestPngDecoder.Decode(File.ReadAllBytes(Path.Combine(folder, SurveyPhoto.FolderName, photo.File)));
            var size = new ImageSize(picture.Width, picture.Height);
            var camera = new Camera(photo.Camera, new CameraIntrinsics(photo.VerticalFovDegrees, size, size.Aspect, 0.05, Lens.Ideal));
            Box2D drawn = CuboidProjector.Project(camera, face.CuboidAt(new Pose(Vector3D.Zero, Axes.Identity))).Box!.Value;
            Box2D seen = WhiteAbove(picture, drawn.YMax - 2);

            // A ray's cell is 12 mm wide. The face takes two thirds of 320 pixels, 0.76 m of the smallest of the plates: 12 mm are 3.4
            // pixels.
            const double cell = 3.4;
            Assert.Equal(drawn.XMin, seen.XMin, cell);
            Assert.Equal(drawn.XMax, seen.XMax, cell);
            Assert.Equal(drawn.YMin, seen.YMin, cell);
        }
    }

    /// <summary>What is white over a row: the plate, and not its post.</summary>
    private static Box2D WhiteAbove(TestPngDecoder picture, double row)
    {
        const int samples = 3;
        (int X, int Y)[] white =
        [
            .. Enumerable
                .Range(0, picture.Width * picture.Height)
                .Where(pixel => picture.Samples[pixel * samples] > 0 && pixel / picture.Width < row)
                .Select(pixel => (pixel % picture.Width, pixel / picture.Width)),
        ];
        return new Box2D(
            white.Min(pixel => pixel.X),
            white.Min(pixel => pixel.Y),
            white.Max(pixel => pixel.X) + 1,
            white.Max(pixel => pixel.Y) + 1
        );
    }
}
