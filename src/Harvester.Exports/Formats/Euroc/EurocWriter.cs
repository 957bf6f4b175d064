using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Euroc;

/// <summary>
/// Writes visual-inertial sequences in the layout of the EuRoC datasets: a sequence for each place, with the images of its cameras, the
/// samples of the inertial unit and the true states. See docs/exports/euroc.md.
/// </summary>
internal sealed class EurocWriter : IDatasetWriter
{
    private const char Between = '|';
    private const string ImagePart = "image";
    private const string ImuPart = "imu";
    private const string GnssPart = "gnss";
    private const string StatePart = "state";
    private const string NoisePart = "noise";
    private const int RateDecimals = 9;
    private const int ForceDecimals = 7;
    private const int DegreeDecimals = 10;
    private const int VelocityDecimals = 5;
    private const int MetreDecimals = 4;
    private const int QuaternionDecimals = 9;
    private const int RateOfUnitDecimals = 3;
    private const int Biases = 6;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        int view = frame.Rig is { } rig ? Math.Max(0, rig.Cameras.TakeWhile(camera => camera.Name != frame.Label.View).Count()) : 0;
        string sequence = $"{frame.SequenceIndex - view:D4}";
        string folder = EurocFiles.FolderOf(frame.Split, sequence);
        string camera = EurocFiles.Camera(view);
        EgoLabel ego = frame.Label.Ego;
        var body = new Pose(ego.Position, ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees));
        string time = Nanoseconds(frame.Label.TimeSeconds);
        string image = time + frame.ImageExtension;
        output.Image($"{folder}/{camera}/data/{image}", frame);
        output.Part(NameOf(ImagePart, folder, camera), $"{time},{image}");
        if (frame.FrameInSequence == 0)
        {
            output.Text($"{folder}/{camera}/{EurocFiles.Sensor}", Lines(EurocSensor.Camera(frame.Label.Camera, body, frame.RateHz)));
        }

        if (view == 0)
        {
            WriteUnit(frame, output, folder);
            output.Part(NameOf(StatePart, folder, EurocFiles.States), $"{time},{State(ego, body, frame.ImuNoise is null)}");
        }

        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts.Keys.Order(StringComparer.Ordinal).SelectMany(part => FilesOf(part, part.Split(Between)));

    private static IEnumerable<AggregateFile> FilesOf(string part, string[] names)
    {
        (string kind, string place) = (names[0], $"{names[1]}/{names[2]}");
        return kind switch
        {
            NoisePart =>
            [
                new AggregateFile(
                    $"{place}/{EurocFiles.Sensor}",
                    [AggregateSection.Lines(part), AggregateSection.Summary(NameOf(ImuPart, names[1], names[2]), WriteRate)]
                ),
            ],
            _ =>
            [
                new AggregateFile(
                    $"{place}/{EurocFiles.Table}",
                    [
                        AggregateSection.Literal(
                            kind switch
                            {
                                ImagePart => EurocFiles.ImageColumns,
                                ImuPart => EurocFiles.ImuColumns,
                                GnssPart => EurocFiles.GnssColumns,
                                _ => EurocFiles.StateColumns,
                            } + "\n"
                        ),
                        AggregateSection.Lines(part),
                    ]
                ),
            ],
        };
    }

    private static void WriteUnit(ExportFrame frame, FrameOutput output, string folder)
    {
        foreach (ImuSample sample in frame.Label.Channels.Get<ImuLabel>()!.Samples)
        {
            Vector3D rate = EurocSensor.InBody(sample.AngularRate);
            Vector3D force = EurocSensor.InBody(sample.SpecificForce);
            output.Part(
                NameOf(ImuPart, folder, EurocFiles.Imu),
                $"{Nanoseconds(sample.TimeSeconds)},{Row(RateDecimals, rate.X, rate.Y, rate.Z)},"
                    + Row(ForceDecimals, force.X, force.Y, force.Z)
            );
        }

        foreach (GnssSample sample in frame.Label.Channels.Get<GnssLabel>()?.Samples ?? [])
        {
            output.Part(
                NameOf(GnssPart, folder, EurocFiles.Gnss),
                $"{Nanoseconds(sample.TimeSeconds)},{Row(DegreeDecimals, sample.LatitudeDegrees, sample.LongitudeDegrees)},"
                    + $"{Row(MetreDecimals, sample.Altitude)},"
                    + Row(VelocityDecimals, sample.Velocity.X, sample.Velocity.Y, sample.Velocity.Z)
            );
        }

        if (frame.FrameInSequence == 0)
        {
            foreach (string line in EurocSensor.Imu(frame.ImuNoise))
            {
                output.Part(NameOf(NoisePart, folder, EurocFiles.Imu), line);
            }
        }
    }

    /// <summary>Position, quaternion and velocity, and the biases, which are known for an ideal unit only.</summary>
    private static string State(EgoLabel ego, Pose body, bool isIdeal)
    {
        Rotation rotation = Rotation.OfBody(body.Axes);
        string[] columns =
        [
            Row(MetreDecimals, body.Position.X, body.Position.Y, body.Position.Z),
            Row(QuaternionDecimals, rotation.W, rotation.X, rotation.Y, rotation.Z),
            Row(MetreDecimals, ego.Velocity.X, ego.Velocity.Y, ego.Velocity.Z),
            .. Enumerable.Repeat(isIdeal ? "0" : "nan", Biases),
        ];
        return string.Join(',', columns);
    }

    /// <summary>The mean rate of the samples, from the first and the last time.</summary>
    private static void WriteRate(TextWriter text, IEnumerable<string> samples)
    {
        (long first, long last, int intervals) = (0, 0, -1);
        foreach (string sample in samples)
        {
            last = long.Parse(sample.AsSpan(0, sample.IndexOf(',')), CultureInfo.InvariantCulture);
            first = intervals < 0 ? last : first;
            intervals++;
        }

        double rate = last > first ? intervals * 1e9 / (last - first) : 0;
        text.Write($"rate_hz: {Numbers.Row(RateOfUnitDecimals, rate)}\n");
    }

    private static string NameOf(string kind, string folder, string sensor) => $"{kind}{Between}{folder}{Between}{sensor}";

    private static string Row(int decimals, params ReadOnlySpan<double> values) => Numbers.Row(decimals, values).Replace(' ', ',');

    private static string Nanoseconds(double seconds) => ((long)Math.Round(seconds * 1e6) * 1000).ToString(CultureInfo.InvariantCulture);

    private static string Lines(IEnumerable<string> lines) => string.Concat(lines.Select(line => line + "\n"));
}
