using System.Text;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>Writes nuScenes: samples and sweeps of every sensor of a rig, and the thirteen tables. See docs/exports/nuscenes.md.</summary>
internal sealed class NuScenesWriter : IDatasetWriter
{
    /// <summary>Name of the version, which is the folder of the tables.</summary>
    public const string Version = "v1.0-gta";

    /// <summary>Samples per second, as in nuScenes.</summary>
    private const double KeyRateHz = 2;

    /// <summary>nuScenes' devkit takes no velocity from samples that are more than 1.5 s apart: box_velocity gives NaN.</summary>
    public const double MinRateHz = 1 / 1.5;

    private const string FramePart = "frame";
    private const string KeyPrefix = "key ";

    /// <summary>The channel of the single camera of a session without a rig.</summary>
    public const string FrontCamera = "CAM_FRONT";

    /// <summary>The first of January 2020, microseconds: a fixed time, because sessions have none.</summary>
    private const long Start = 1_577_836_800_000_000;

    /// <summary>Time between the starts of two sessions, microseconds: longer than any session.</summary>
    private const long SessionStep = 1_000_000_000_000;

    private const double Microseconds = 1e6;
    private const int MetreDecimals = 4;
    private const int QuaternionDecimals = 9;
    private const float MaxIntensity = 255;

    private NuScenesGround? _ground;
    private NuScenesScan? _scan;
    private (SessionReader Session, IReadOnlyDictionary<int, NuScenesEvent> ById)? _events;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        FrameLabel label = frame.Label;
        Rig rig = frame.Rig ?? SingleCamera(label);
        RigCamera camera =
            rig.Cameras.FirstOrDefault(each => each.Name == (label.View ?? FrontCamera))
            ?? throw frame.Problem($"its view '{label.View}' is no camera of the rig.");
        int moment = label.Moment ?? label.Frame;
        bool isKey = IsSample(frame);
        long timestamp = TimestampOf(frame, label.TimeSeconds);
        string image = PathOf(frame, isKey, camera.Name, timestamp, frame.ImageExtension);
        output.Image(image, frame);
        var sensors = new List<NuScenesSensor> { NuScenesSensor.Of(camera, label.Camera, image) };
        foreach (SweepLabel sweep in label.Lidar)
        {
            RigLidar lidar =
                rig.Lidars.FirstOrDefault(each => each.Name == sweep.Sensor)
                ?? throw frame.Problem($"its LiDAR '{sweep.Sensor}' is not in the rig.");
            LidarPoint[] points = frame.ReadPoints(sweep);
            string file = PathOf(frame, isKey, lidar.Name, timestamp, ".pcd.bin");
            output.File(file, stream => WritePoints(stream, points, RingsOf(lidar)));
            sensors.Add(NuScenesSensor.Of(lidar, file));
            if (isKey)
            {
                NuScenesSegments.Write(frame, file, points, output);
            }
        }

        foreach (RadarScan detected in label.Channels.Get<RadarsLabel>()?.Scans ?? [])
        {
            RigRadar radar =
                rig.Radars.FirstOrDefault(each => each.Name == detected.Sensor)
                ?? throw frame.Problem($"its radar '{detected.Sensor}' is not in the rig.");
            string file = PathOf(frame, isKey, radar.Name, timestamp, NuScenesSensor.RadarExtension);
            output.File(file, stream => NuScenesRadar.Write(stream, detected));
            sensors.Add(NuScenesSensor.Of(radar, file));
        }

        NuScenesGround ground = GroundOf(frame.Session);
        Pose ego = PoseOf(label.Ego);
        NuScenesArea area = NuScenesArea.Around(ego.Position, ground.MarginMetres);
        string egoPose = EgoOf(ego, rig);
        NuScenesScan? scan = isKey ? ScanOf(frame, egoPose) : null;
        NuScenesObject[] objects =
        [
            .. frame
                .Objects.Select(item => NuScenesObject.Of(item.Label))
                .OfType<NuScenesObject>()
                .Select(item => scan?.Count(item) ?? item),
        ];
        output.Part(
            FramePart,
            new NuScenesPart(
                frame.RecordingIndex,
                label.Place ?? 0,
                moment,
                isKey,
                timestamp,
                frame.Split,
                $"{label.Environment.Weather}, {label.Environment.TimeOfDay:hh\\:mm}",
                area,
                ground.HasLanes,
                egoPose,
                sensors,
                objects
            )
            {
                Events = EventsOf(frame),
            }.ToString()
        );
        bool isFirst = label.Frame % rig.Cameras.Count == 0;
        NuScenesCanBus.Add(
            output,
            frame,
            area,
            isFirst ? EgoTrack.SamplesOf(label).Select(tick => NuScenesRide.Row(tick, at => TimestampOf(frame, at), rig.Origin)) : []
        );
        NuScenesMap.Add(output, frame, area, isFirst ? ground.Near(label, ego, isKey) : []);
        if (ground.HasLanes)
        {
            IEnumerable<string> lanes =
                isFirst && isKey
                    ? ground.LanesNear(ego) ?? throw frame.Problem("more roads meet around it than a map of lanes takes.")
                    : [];
            NuScenesExpansions.Add(output, frame, area, isKey ? lanes.Concat(ground.SignalsOf(label)) : []);
        }

        if (isKey)
        {
            output.Part(FormattableString.Invariant($"{KeyPrefix}{frame.RecordingIndex:D8} {label.Place ?? 0:D8}"), "");
        }

        return new WrittenObjects(isKey ? objects.Length : 0);
    }

    public IEnumerable<AggregateTables> Tables => [NuScenesTables.Of(FramePart)];

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts)
    {
        // A session at a place is a scene if it has a sample.
        string[] scenes =
        [
            .. parts
                .Keys.Where(part => part.StartsWith(KeyPrefix, StringComparison.Ordinal))
                .Select(part => part[KeyPrefix.Length..])
                .Order(StringComparer.Ordinal),
        ];
        return
        [
            .. NuScenesCanBus.Files(parts.Keys, place => parts.ContainsKey(KeyPrefix + place)),
            .. NuScenesMap.Files(scenes),
            .. NuScenesExpansions.Files(scenes, parts.ContainsKey),
            .. parts.ContainsKey(NuScenesSegments.Part) ? NuScenesSegments.Tables(FramePart) : [],
        ];
    }

    /// <summary>The name of a session at a place as a log.</summary>
    public static string LogOf(int recording, int place) => FormattableString.Invariant($"gta-{recording:D4}-{place:D4}");

    /// <summary>Whether the moment of a frame is a sample: those at two a second are.</summary>
    public static bool IsSample(ExportFrame frame)
    {
        int inScene = (frame.Label.PlaceFrame ?? frame.Label.Frame) / (frame.Rig?.Cameras.Count ?? 1);
        return inScene % Math.Max(1, (int)Math.Round(frame.RateHz / KeyRateHz)) == 0;
    }

    /// <summary>The name of the log of a frame.</summary>
    public static string LogOf(ExportFrame frame) => LogOf(frame.RecordingIndex, frame.Label.Place ?? 0);

    /// <summary>A time of a frame's session, microseconds.</summary>
    public static long TimestampOf(ExportFrame frame, double timeSeconds) =>
        Start + (SessionStep * frame.RecordingIndex) + (long)Math.Round(timeSeconds * Microseconds);

    private static string PathOf(ExportFrame frame, bool isKey, string channel, long timestamp, string extension) =>
        FormattableString.Invariant($"{(isKey ? "samples" : "sweeps")}/{channel}/{LogOf(frame)}__{channel}__{timestamp}{extension}");

    private static Pose PoseOf(EgoLabel ego) => new(ego.Position, ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees));

    /// <summary>The camera of a session without a rig, as one whose mount follows from the poses of car and camera.</summary>
    private static Rig SingleCamera(FrameLabel label)
    {
        Pose ego = PoseOf(label.Ego);
        Pose camera = label.Camera.Pose;
        var mount = new Pose(
            ego.ToLocal(camera.Position),
            Axes.FromVectors(ego.Axes.ToLocal(camera.Axes.Right), ego.Axes.ToLocal(camera.Axes.Forward), ego.Axes.ToLocal(camera.Axes.Up))
        );
        var image = new ImageSize(label.Camera.Width, label.Camera.Height);
        var only = new RigCamera(FrontCamera, mount, label.Camera.VerticalFovDegrees, image, Lens.Ideal);
        return new Rig("single", Vector3D.Zero, [only], []);
    }

    private NuScenesGround GroundOf(SessionReader session) =>
        _ground is { } ground && ground.Session == session ? ground : _ground = NuScenesGround.Of(session);

    private IReadOnlyList<NuScenesEvent>? EventsOf(ExportFrame frame)
    {
        if (frame.Label.Events is not { } open)
        {
            return null;
        }

        if (_events?.Session != frame.Session)
        {
            _events = (frame.Session, NuScenesEvent.In(frame.Session));
        }

        return
        [
            .. open.Select(mark =>
                _events!.Value.ById.TryGetValue(mark.Id, out NuScenesEvent? known)
                    ? known
                    : throw frame.Problem($"its event {mark.Id} is not in events.jsonl.")
            ),
        ];
    }

    /// <summary>The views of a moment follow each other, so its points are read once.</summary>
    private NuScenesScan? ScanOf(ExportFrame frame, string ego) =>
        NuScenesScan.NameOf(frame) is not { } name ? null
        : _scan?.File == name ? _scan
        : _scan = NuScenesScan.Read(frame, ego);

    private static string EgoOf(Pose pose, Rig rig) =>
        JsonLine.Of(json =>
        {
            Vector3D origin = pose.ToWorld(rig.Origin);
            Rotation rotation = Rotation.OfBody(pose.Axes);
            json.WriteStartObject();
            json.Numbers("rotation", [rotation.W, rotation.X, rotation.Y, rotation.Z], QuaternionDecimals);
            json.Numbers("translation", [origin.X, origin.Y, origin.Z], MetreDecimals);
            json.WriteEndObject();
        });

    /// <summary>The ring of each beam: 0 is the lowest.</summary>
    private static float[] RingsOf(RigLidar lidar) =>
        [.. lidar.BeamsDegrees.Select(beam => (float)lidar.BeamsDegrees.Count(other => other < beam))];

    private static void WritePoints(Stream stream, LidarPoint[] points, float[] rings)
    {
        using var writer = new BinaryWriter(stream, Encoding.UTF8, leaveOpen: true);
        foreach (LidarPoint point in points)
        {
            writer.Write(point.X);
            writer.Write(point.Y);
            writer.Write(point.Z);
            writer.Write(point.Intensity * MaxIntensity);
            writer.Write(rings[Math.Min(point.Beam, rings.Length - 1)]);
        }
    }
}
