using Harvester.Geometry;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Tests.Rigs;

public sealed class RigParserTests
{
    private const string Camera = """{"name":"front","position":[1,2,3],"verticalFovDegrees":50,"width":80,"height":60}""";
    private const string Lidar = """{"name":"top","position":[0,0,2],"beamsDegrees":[1,-1],"columns":4}""";

    [Fact]
    public void Camera_is_read_with_its_mount()
    {
        Rig rig = RigParser.Parse(
            """
            {"name":"two","origin":[0,-1,-0.5],"cameras":[{"name":"left","position":[-1,2,3],"yawDegrees":90,"verticalFovDegrees":40,
            "width":64,"height":32,"lens":{"k1":-0.1}}]}
            """
        );

        RigCamera camera = Assert.Single(rig.Cameras);
        Assert.Equal(
            ("left", 40.0, 64, 32, -0.1),
            (camera.Name, camera.VerticalFovDegrees, camera.Image.Width, camera.Image.Height, camera.Lens.K1)
        );

        // A quarter turn to the left: forward is the vehicle's left, -x. The origin is added: (-1, 2 - 1, 3 - 0.5).
        const double rounding = 1e-12;
        Assert.InRange((camera.Mount.Axes.Forward - new Vector3D(-1, 0, 0)).Length, 0, rounding);
        Assert.Equal(new Vector3D(-1, 1, 2.5), rig.OnVehicle(camera.Mount).Position);
    }

    [Theory]
    // 1 / (20 · 46.08 µs) = 1085.07, 1 / (10 · 55.296 µs) = 1808.4.
    [InlineData("HDL-32E", 32, 1085, 10.67, -30.67)]
    [InlineData("VLP-16", 16, 1808, 15, -15)]
    [InlineData("HDL-64E", 64, 2083, 2, -24.33)]
    public void Model_gives_beams_and_columns(string model, int beams, int columns, double top, double bottom)
    {
        RigLidar lidar = RigParser.Parse(With(Camera, $$"""{"name":"top","position":[0,0,2],"model":"{{model}}"}""")).Lidars[0];

        Assert.Equal((beams, columns), (lidar.BeamsDegrees.Count, lidar.Columns));
        const double rounding = 1e-9;
        Assert.InRange(lidar.BeamsDegrees[0] - top, -rounding, rounding);
        Assert.InRange(lidar.BeamsDegrees[^1] - bottom, -rounding, rounding);
    }

    [Theory]
    [InlineData("thesis", 1, 0)]
    [InlineData("stereo", 2, 0)]
    [InlineData("nuscenes", 6, 1)]
    [InlineData("nuscenes-half", 6, 1)]
    [InlineData("kitti", 4, 1)]
    [InlineData("radar", 1, 0)]
    public void Examples_are_read(string name, int cameras, int lidars)
    {
        Rig rig = RigParser.Parse(File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "rigs", $"{name}.json")));

        Assert.Equal((name, cameras, lidars), (rig.Name, rig.Cameras.Count, rig.Lidars.Count));
        Assert.InRange(RigBudget.SecondsPerMoment(rig), 0.01, RigBudget.MaxSeconds);
    }

    [Fact]
    public void Written_rig_is_read_back()
    {
        Rig rig = RigParser.Parse(
            With(
                Camera.Replace("[1,2,3]", "[1,2,3],\"pitchDegrees\":-2.5", StringComparison.Ordinal),
                Lidar.Replace("}", ",\"rayFraction\":0.25,\"motionDistortion\":true}", StringComparison.Ordinal)
            )
        );
        var json = new JsonText();
        RigJson.Append(json, rig);
        Rig read = RigParser.Parse(json.ToString());
        var again = new JsonText();
        RigJson.Append(again, read);

        Assert.Equal(json.ToString(), again.ToString());
        Assert.Equal(rig.Lidars[0].BeamsDegrees, read.Lidars[0].BeamsDegrees);
        Assert.Equal((0.25, true), (read.Lidars[0].RayFraction, read.Lidars[0].MotionDistortion));
        Assert.Equal(rig.Cameras[0].Image, read.Cameras[0].Image);
    }

    [Theory]
    [InlineData("""{"name":"r","cameras":[]}""", "cameras must be a list of 1 to 32 cameras.")]
    [InlineData("""{"cameras":[CAMERA]}""", "name is missing.")]
    [InlineData("""{"name":"r","cameras":[CAMERA,CAMERA]}""", "cameras[1].name must be unlike that of every other sensor")]
    [InlineData("""{"name":"r","cameras":[CAMERA],"lens":1}""", "lens is not a field of a rig.")]
    [InlineData("""{"name":"../r","cameras":[CAMERA]}""", "name must be 1 to 40 letters")]
    [InlineData(
        """{"name":"r","cameras":[{"name":"a","position":[1,2],"verticalFovDegrees":50,"width":80,"height":60}]}""",
        "cameras[0].position must be three numbers"
    )]
    [InlineData(
        """{"name":"r","cameras":[{"name":"a","position":[1,2,3],"verticalFovDegrees":171,"width":80,"height":60}]}""",
        "cameras[0].verticalFovDegrees must be a number from 1 to 170."
    )]
    [InlineData(
        """{"name":"r","cameras":[{"name":"a","position":[1,2,3],"verticalFovDegrees":50,"width":80.5,"height":60}]}""",
        "cameras[0].width must be a whole number."
    )]
    [InlineData("""{"name":"Nul","cameras":[CAMERA]}""", "name must be another one: Windows reserves 'Nul' for a device.")]
    [InlineData(
        """{"name":"r","cameras":[{"name":"COM1","position":[1,2,3],"verticalFovDegrees":50,"width":80,"height":60}]}""",
        "cameras[0].name must be another one: Windows reserves 'COM1' for a device."
    )]
    [InlineData("[]", "the file must be an object.")]
    public void Bad_rig_is_refused_with_its_field(string text, string message)
    {
        FormatException refused = Assert.Throws<FormatException>(() =>
            RigParser.Parse(text.Replace("CAMERA", Camera, StringComparison.Ordinal))
        );

        Assert.StartsWith(message, refused.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"beamsDegrees\":[91],\"columns\":4", "lidars[0].beamsDegrees[0] must be a number from -89.9 to 89.9.")]
    [InlineData("\"beamsDegrees\":[1,1],\"columns\":4", "lidars[0].beamsDegrees must be angles that all differ.")]
    [InlineData("\"beamsDegrees\":[],\"columns\":4", "lidars[0].beamsDegrees must be 1 to 256 angles.")]
    [InlineData("\"beamsDegrees\":[1]", "lidars[0].columns is missing.")]
    [InlineData("\"model\":\"HDL-64E\",\"rateHz\":0.5", "lidars[0].rateHz must be higher")]
    [InlineData("\"model\":\"HDL-64E\",\"columns\":20000,\"beamsDegrees\":BEAMS", "lidars[0].columns must be fewer: with 101 beams")]
    [InlineData("\"model\":\"VLP-16\",\"rayFraction\":0", "lidars[0].rayFraction must be a number from 0.01 to 1.")]
    [InlineData("\"model\":\"VLP-16\",\"motionDistortion\":1", "lidars[0].motionDistortion must be true or false.")]
    [InlineData("\"model\":\"X\"", "lidars[0].model must be one of HDL-32E, HDL-64E, VLP-16")]
    [InlineData("\"model\":\"VLP-16\",\"rateHz\":0.1", "lidars[0].rateHz must be higher")]
    [InlineData("\"model\":\"VLP-16\",\"minRangeMetres\":120", "lidars[0].rangeMetres must be greater than minRangeMetres")]
    public void Impossible_beams_are_refused(string fields, string message)
    {
        string beams = $"[{string.Join(',', Enumerable.Range(-50, 101))}]";
        string lidar = fields.Replace("BEAMS", beams, StringComparison.Ordinal);
        FormatException refused = Assert.Throws<FormatException>(() =>
            RigParser.Parse(With(Camera, $$"""{"name":"top","position":[0,0,2],{{lidar}}}"""))
        );

        Assert.StartsWith(message, refused.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"azimuthDegrees\":181", "radars[0].azimuthDegrees must be a number from 1 to 180.")]
    [InlineData("\"ghostFraction\":2", "radars[0].ghostFraction must be a number from 0 to 1.")]
    [InlineData("\"clutter\":-1", "radars[0].clutter must be a number from 0 to 100.")]
    [InlineData("\"maxDetections\":0", "radars[0].maxDetections must be a number from 1 to 1000.")]
    [InlineData("\"range\":100", "radars[0].range is not a field of a rig.")]
    public void Impossible_radar_is_refused(string field, string message)
    {
        FormatException refused = Assert.Throws<FormatException>(() => RigParser.Parse(WithRadar(field)));

        Assert.StartsWith(message, refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Radar_survives_writing_and_reading()
    {
        const string fields =
            "\"yawDegrees\":90,\"azimuthDegrees\":100,\"elevationDegrees\":10,\"rangeMetres\":70,\"azimuthStepDegrees\":2,"
            + "\"rangeStepMetres\":0.5,\"rangeNoiseMetres\":0.1,\"azimuthNoiseDegrees\":0.2,\"velocityNoise\":0.3,\"ghostFraction\":0.4,"
            + "\"clutter\":5,\"maxDetections\":60";
        Rig rig = RigParser.Parse(WithRadar(fields));
        var json = new JsonText();
        RigJson.Append(json, rig);

        RigRadar radar = Assert.Single(rig.Radars);
        RigRadar again = Assert.Single(RigParser.Parse(json.ToString()).Radars);

        Assert.Equal(
            (100, 10, 70, 2, 0.5),
            (radar.AzimuthDegrees, radar.ElevationDegrees, radar.RangeMetres, radar.AzimuthStepDegrees, radar.RangeStepMetres)
        );
        Assert.Equal(
            (0.1, 0.2, 0.3, 0.4, 5, 60),
            (
                radar.RangeNoiseMetres,
                radar.AzimuthNoiseDegrees,
                radar.VelocityNoise,
                radar.GhostFraction,
                radar.Clutter,
                radar.MaxDetections
            )
        );
        Assert.Equal(radar with { Mount = default }, again with { Mount = default });
        Assert.InRange((radar.Mount.Axes.Forward - again.Mount.Axes.Forward).Length, 0, 1e-9);
    }

    private static string WithRadar(string fields) =>
        $$"""{"name":"r","cameras":[{{Camera}}],"radars":[{"name":"ahead","position":[0,2,0.5],{{fields}}}]}""";

    private static string With(string camera, string lidar) => $$"""{"name":"r","cameras":[{{camera}}],"lidars":[{{lidar}}]}""";
}
