using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands;

/// <summary>harvester project: projects points of the world to pixels, as CSV.</summary>
internal static class ProjectCommand
{
    private const double DefaultNearClip = 0.15;

    private const string Notes =
        "Input: one point per line, x,y,z in metres, with x east, y north and z up. Blank lines and lines that begin with # are ignored.\n"
        + "Output: one row per point with u and v (pixels from the upper left corner, empty for a point behind the near plane), depth\n"
        + "(metres in front of the camera) and outcome (inImage, outsideImage or behindNearPlane).\n\n"
        + "Example:\n"
        + "  echo 0,10,0 | harvester project --position 0,0,0 --rotation 0,0,0 --fov 50 --size 800x600";

    /// <summary>A generous limit: three numbers with all their digits have fewer than 100 characters.</summary>
    private const int MaxLineCharacters = 1 << 16;

    public static Command Create(Terminal terminal)
    {
        Option<Vector3D> position = Required(ValueParsers.Vector("--position", "X,Y,Z", "Position of the camera in the world, metres"));
        Option<Vector3D> rotation = Required(
            ValueParsers.Vector(
                "--rotation",
                "PITCH,ROLL,YAW",
                "Rotation of the camera, degrees; the matrix is Rz(yaw) Rx(pitch) Ry(roll), as in the game"
            )
        );
        Option<double> fov = Required(CameraOptions.Fov());
        Option<ImageSize> size = Required(CameraOptions.Size());
        Option<double?> aspect = ValueParsers.Optional(
            "--aspect",
            "A",
            "Aspect ratio of the game's window, width / height [default: that of --size]",
            Positive,
            "a number greater than 0"
        );
        Option<double> near = ValueParsers.Number(
            "--near",
            "N",
            "Distance of the near plane, metres",
            value => value > 0,
            "a number greater than 0"
        );
        near.DefaultValueFactory = _ => DefaultNearClip;
        var points = new Option<FileInfo?>("--points") { Description = "File with points [default: standard input]", HelpName = "FILE" };

        var command = new ResultCommand("project", "Project points of the world into an image: CSV in, CSV out.")
        {
            position,
            rotation,
            fov,
            size,
            aspect,
            near,
            points,
        };
        var lens = new LensOptions();
        lens.AddTo(command);
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            ImageSize image = parsed.GetValue(size);
            Vector3D angles = parsed.GetValue(rotation);
            var pose = new Pose(parsed.GetValue(position), Axes.FromEuler(new EulerAngles(angles.X, angles.Y, angles.Z)));
            var camera = new Camera(
                pose,
                new CameraIntrinsics(
                    parsed.GetValue(fov),
                    image,
                    parsed.GetValue(aspect) ?? image.Aspect,
                    parsed.GetValue(near),
                    lens.Parse(parsed)
                )
            );

            FileInfo? file = parsed.GetValue(points);
            string source = file?.Name ?? "standard input";
            using TextReader reader = file is null ? terminal.In : InputFile.OpenText(file.FullName);
            Project(camera, reader, source, terminal.Out);
            return ExitCode.Done;
        });
        return command;
    }

    /// <summary>Projects points.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="points">Their text, one a line.</param>
    /// <param name="source">Where the text comes from, for messages.</param>
    /// <param name="output">Where the pixels go, as CSV.</param>
    /// <exception cref="DatasetFormatException">A line is not a point, or is too long.</exception>
    internal static void Project(Camera camera, TextReader points, string source, TextWriter output)
    {
        using TextReader limited = InputFile.Limited(points, source, MaxLineCharacters);
        WriteProjections(camera, ReadPoints(limited, source), output);
    }

    private static IEnumerable<Vector3D> ReadPoints(TextReader reader, string source)
    {
        int number = 0;
        while (reader.ReadLine() is { } line)
        {
            number++;
            if (string.IsNullOrWhiteSpace(line) || line.StartsWith('#'))
            {
                continue;
            }

            double[] point =
                NumberText.ReadList(line, 3)
                ?? throw new DatasetFormatException($"{source}, line {number}: expected x,y,z, found '{line.Trim()}'.");
            yield return new Vector3D(point[0], point[1], point[2]);
        }
    }

    private static void WriteProjections(Camera camera, IEnumerable<Vector3D> points, TextWriter output)
    {
        output.WriteLine("u,v,depth,outcome");
        foreach (Vector3D point in points)
        {
            Projection projection = camera.Project(point);
            bool hasPixel = projection.Outcome != ProjectionOutcome.BehindNearPlane;
            string u = hasPixel ? Text(projection.U) : "";
            string v = hasPixel ? Text(projection.V) : "";
            output.WriteLine($"{u},{v},{Text(projection.Depth)},{JsonName.Of(projection.Outcome)}");
        }
    }

    private static Option<T> Required<T>(Option<T> option)
    {
        option.Required = true;
        return option;
    }

    private static double? Positive(string text) => NumberText.Read(text) is { } value && value > 0 ? value : null;

    // Adding 0 turns minus zero into zero.
    private static string Text(double value) => (value + 0.0).ToString("R", CultureInfo.InvariantCulture);
}
