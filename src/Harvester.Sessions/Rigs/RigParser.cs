using System.Text.RegularExpressions;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Rigs;

/// <summary>Reads a rig file, as docs/rigs.md describes it.</summary>
public static class RigParser
{
    /// <summary>Maximum number of cameras.</summary>
    public const int MaxCameras = 32;

    /// <summary>Maximum number of LiDARs.</summary>
    public const int MaxLidars = 8;

    /// <summary>Maximum number of radars.</summary>
    public const int MaxRadars = 8;

    private const double MaxOffsetMetres = 20;
    private const double MinFovDegrees = 1;
    private const double MaxFovDegrees = 170;
    private const int MinSide = 32;
    private const int MaxSide = 8192;
    private const int MaxBeams = 256;
    private const double MaxElevationDegrees = 89.9;
    private const int MaxColumns = 20_000;
    private const int MaxRays = LidarFile.MaxPoints;
    private const double MinRateHz = 0.1;
    private const double MaxRateHz = 100;
    private const double MaxRangeMetres = 1000;
    private const double MinRayFraction = 0.01;
    private const double MaxClutter = 100;
    private const int MaxDetections = 1000;
    private const double UsualMinRangeMetres = 0.5;
    private const double UsualRateHz = 10;
    private const double UsualRangeMetres = 100;

    private static readonly Regex NameForm = new(@"\A[A-Za-z0-9][A-Za-z0-9_-]{0,39}\z", RegexOptions.CultureInvariant);

    /// <summary>Names of devices, which Windows does not allow for folders.</summary>
    private static readonly Regex DeviceName = new(
        @"\A(CON|NUL|AUX|PRN|COM[1-9]|LPT[1-9])\z",
        RegexOptions.CultureInvariant | RegexOptions.IgnoreCase
    );

    /// <summary>Reads the text of a rig file.</summary>
    /// <exception cref="FormatException">The text is not a rig; the message names the field.</exception>
    public static Rig Parse(string text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        CheckedJson file = CheckedJson.Parse(text, "a rig");
        string name = NameOf(file);
        Vector3D origin = file.Has("origin") ? file.Vector("origin", MaxOffsetMetres) : Vector3D.Zero;
        CheckedJson[] cameras = file.List("cameras");
        CheckedJson[] lidars = file.List("lidars");
        CheckedJson[] radars = file.List("radars");
        file.End();
        if (cameras.Length is 0 or > MaxCameras)
        {
            throw file.Wrong("cameras", FormattableString.Invariant($"a list of 1 to {MaxCameras} cameras"));
        }

        if (lidars.Length > MaxLidars)
        {
            throw file.Wrong("lidars", FormattableString.Invariant($"a list of at most {MaxLidars} LiDARs"));
        }

        if (radars.Length > MaxRadars)
        {
            throw file.Wrong("radars", FormattableString.Invariant($"a list of at most {MaxRadars} radars"));
        }

        var names = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        RigCamera[] made = [.. cameras.Select(camera => CameraOf(camera, names))];
        return new Rig(name, origin, made, [.. lidars.Select(lidar => LidarOf(lidar, names))])
        {
            Radars = [.. radars.Select(radar => RadarOf(radar, names))],
        };
    }

    private static RigCamera CameraOf(CheckedJson camera, HashSet<string> names)
    {
        var made = new RigCamera(
            UniqueNameOf(camera, names),
            MountOf(camera),
            camera.Number("verticalFovDegrees", MinFovDegrees, MaxFovDegrees),
            new ImageSize(camera.Whole("width", MinSide, MaxSide), camera.Whole("height", MinSide, MaxSide)),
            LensOf(camera.Fields("lens"))
        );
        camera.End();
        return made;
    }

    private static Lens LensOf(CheckedJson? lens)
    {
        if (lens is null)
        {
            return Lens.Ideal;
        }

        var made = new Lens(
            lens.Number("focalScale", 0.01, 100, 1),
            lens.Number("centreOffsetX", -1, 1, 0),
            lens.Number("centreOffsetY", -1, 1, 0),
            lens.Number("k1", -1, 1, 0),
            lens.Number("k2", -1, 1, 0)
        );
        lens.End();
        return made;
    }

    private static RigLidar LidarOf(CheckedJson lidar, HashSet<string> names)
    {
        string name = UniqueNameOf(lidar, names);
        string? modelName = lidar.Has("model") ? lidar.Text("model") : null;
        LidarModel? model = modelName is null
            ? null
            : LidarModel.Find(modelName)
                ?? throw lidar.Wrong(
                    "model",
                    $"one of {string.Join(", ", LidarModel.All.Select(each => each.Name))}; "
                        + "for another sensor leave it out and give beamsDegrees and columns"
                );
        IReadOnlyList<double> beams = lidar.Has("beamsDegrees") || model is null ? BeamsOf(lidar) : model.BeamsDegrees;
        double rate = lidar.Number("rateHz", MinRateHz, MaxRateHz, model?.RateHz ?? UsualRateHz);
        int columns = lidar.Has("columns") || model is null ? lidar.Whole("columns", 1, MaxColumns) : model.ColumnsAt(rate);
        if (columns > MaxColumns)
        {
            throw lidar.Wrong("rateHz", FormattableString.Invariant($"higher: a turn has {columns} firings, the most are {MaxColumns}"));
        }

        if ((long)columns * beams.Count > MaxRays)
        {
            throw lidar.Wrong("columns", FormattableString.Invariant($"fewer: with {beams.Count} beams, at most {MaxRays / beams.Count}"));
        }

        double nearest = lidar.Number("minRangeMetres", 0, MaxRangeMetres, UsualMinRangeMetres);
        double range = lidar.Number("rangeMetres", 0, MaxRangeMetres, model?.RangeMetres ?? UsualRangeMetres);
        if (range <= nearest)
        {
            throw lidar.Wrong("rangeMetres", FormattableString.Invariant($"greater than minRangeMetres, which is {nearest}"));
        }

        var made = new RigLidar(name, MountOf(lidar), beams, columns, rate, nearest, range)
        {
            Model = modelName,
            RangeNoiseMetres = lidar.Number("rangeNoiseMetres", 0, 1, 0),
            DropOutFraction = lidar.Number("dropOutFraction", 0, 1, 0),
            RayFraction = lidar.Number("rayFraction", MinRayFraction, 1, 1),
            MotionDistortion = lidar.Flag("motionDistortion", false),
        };
        lidar.End();
        return made;
    }

    private static RigRadar RadarOf(CheckedJson radar, HashSet<string> names)
    {
        var usual = new RigRadar(
            UniqueNameOf(radar, names),
            MountOf(radar),
            radar.Number("azimuthDegrees", 1, 180, 120),
            radar.Number("elevationDegrees", 1, 60, 20),
            radar.Number("rangeMetres", 1, MaxRangeMetres, 250)
        );
        RigRadar made = usual with
        {
            AzimuthStepDegrees = radar.Number("azimuthStepDegrees", 0.1, 45, usual.AzimuthStepDegrees),
            RangeStepMetres = radar.Number("rangeStepMetres", 0.05, 10, usual.RangeStepMetres),
            RangeNoiseMetres = radar.Number("rangeNoiseMetres", 0, 10, 0),
            AzimuthNoiseDegrees = radar.Number("azimuthNoiseDegrees", 0, 10, 0),
            VelocityNoise = radar.Number("velocityNoise", 0, 10, 0),
            GhostFraction = radar.Number("ghostFraction", 0, 1, 0),
            Clutter = radar.Number("clutter", 0, MaxClutter, 0),
            MaxDetections = radar.Has("maxDetections") ? radar.Whole("maxDetections", 1, MaxDetections) : usual.MaxDetections,
        };
        radar.End();
        return made;
    }

    private static double[] BeamsOf(CheckedJson lidar)
    {
        double[] beams = lidar.Numbers("beamsDegrees", -MaxElevationDegrees, MaxElevationDegrees);
        return beams.Length is 0 or > MaxBeams ? throw lidar.Wrong("beamsDegrees", FormattableString.Invariant($"1 to {MaxBeams} angles"))
            : beams.Distinct().Count() < beams.Length ? throw lidar.Wrong("beamsDegrees", "angles that all differ")
            : beams;
    }

    private static Pose MountOf(CheckedJson sensor) =>
        new(
            sensor.Vector("position", MaxOffsetMetres),
            Axes.FromEuler(
                new EulerAngles(
                    sensor.Number("pitchDegrees", -90, 90, 0),
                    sensor.Number("rollDegrees", -180, 180, 0),
                    sensor.Number("yawDegrees", -360, 360, 0)
                )
            )
        );

    private static string UniqueNameOf(CheckedJson sensor, HashSet<string> names)
    {
        string name = NameOf(sensor);
        return names.Add(name)
            ? name
            : throw sensor.Wrong("name", $"unlike that of every other sensor, in capitals or not; '{name}' occurs twice");
    }

    private static string NameOf(CheckedJson named)
    {
        string name = named.Text("name");
        return DeviceName.IsMatch(name) ? throw named.Wrong("name", $"another one: Windows reserves '{name}' for a device")
            : NameForm.IsMatch(name) ? name
            : throw named.Wrong("name", $"1 to 40 letters, digits, - and _, beginning with a letter or digit, not '{name}'");
    }
}
