using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Writes MCAP: a file per place, with all sensors of a rig, and a chunk per frame. See docs/exports/mcap.md.</summary>
internal sealed class McapWriter : IDatasetWriter
{
    private const double NanosecondsPerSecond = 1e9;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        FrameLabel label = frame.Label;
        if (label.TimeSeconds < 0)
        {
            throw frame.Problem("its time is negative, and mcap has unsigned times.");
        }

        if (label.Drive?.Ticks.Any(tick => tick.TimeSeconds < label.TimeSeconds) ?? false)
        {
            throw frame.Problem("a tick after it has an earlier time.");
        }

        long nanoseconds = Nanoseconds(label.TimeSeconds);
        int view = frame.Rig is { } rig ? ViewOf(frame, rig) : 0;
        CameraChannels camera = frame.Rig is null ? CameraChannels.Single : CameraChannels.Of(frame.Rig, view);
        var messages = new FoxgloveMessages(label, nanoseconds, camera.FrameId, frame.IsFirstView);
        (byte[] image, string format) = ImageOf(frame, output);
        var all = new List<McapMessage>
        {
            new(camera.Image, messages.Image(image, format)),
            new(camera.Calibration, messages.Calibration()),
            new(McapChannel.Transforms, messages.Transforms(label.Lidar.Select(sweep => PlaceOf(frame, LidarOf(frame, sweep))))),
            new(McapChannel.Objects, messages.Objects(frame.Objects)),
        };
        if (label.Lanes is { } lanes)
        {
            all.Add(new(McapChannel.Lanes, messages.Lanes(lanes)));
        }

        all.Add(new(camera.Annotations, messages.Annotations(frame.Objects)));
        if (frame.IsFirstView)
        {
            all.AddRange(OfVehicle(frame, nanoseconds));
        }

        if (frame.ReadDepth() is { } depth)
        {
            all.Add(new(camera.Depth, DepthMessage.Of(depth, camera.FrameId, nanoseconds)));
        }

        foreach (SweepLabel sweep in label.Lidar)
        {
            RigLidar lidar = LidarOf(frame, sweep);
            all.Add(
                new(
                    CameraChannels.OfLidar(frame.Rig!, lidar),
                    PointMessage.Of(frame.ReadPoints(sweep), CameraChannels.LidarFrame(lidar), nanoseconds)
                )
            );
        }

        // The views of a place follow each other as sequences, and its file has the number of the first.
        output.StagedPart(
            $"{frame.Split}/{frame.SequenceIndex - view:D4}.mcap",
            frame.Name + ".chunk",
            stream =>
            {
                if (frame.Rig is not null)
                {
                    McapChunk.WriteChannels(stream, all);
                }

                McapChunk.Write(stream, nanoseconds, frame.FrameInSequence, all);
            }
        );
        return new WrittenObjects(frame.Objects.Count);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts.Keys.Select(file => new AggregateFile(file, [AggregateSection.Container(file, McapFile.Write)]));

    /// <summary>The messages about the vehicle and its surroundings, which all views share.</summary>
    private static IEnumerable<McapMessage> OfVehicle(ExportFrame frame, long nanoseconds)
    {
        FrameLabel label = frame.Label;
        if (label.Lanes is { Status: LaneStatus.Known } known)
        {
            yield return new(McapChannel.Indicators, IndicatorMessage.Of(label, known, nanoseconds));
        }

        if (label.Drive is { } drive)
        {
            foreach (McapMessage message in DriveMessages.Of(drive, nanoseconds, Nanoseconds))
            {
                yield return message;
            }
        }

        if (label.Events is { } events)
        {
            yield return new(McapChannel.Events, EventMessage.Of(events, nanoseconds));
        }

        if (label.Channels.Get<BirdsEyeLabel>() is { } map)
        {
            yield return new(McapChannel.BirdsEye, GridMessage.Of(frame, map, nanoseconds));
        }

        if (label.Channels.Get<OccupancyLabel>() is { } voxels)
        {
            yield return new(McapChannel.Occupancy, VoxelGridMessage.Of(frame, voxels, nanoseconds));
        }
    }

    private static int ViewOf(ExportFrame frame, Rig rig)
    {
        int view = rig.Cameras.TakeWhile(camera => camera.Name != frame.Label.View).Count();
        return view < rig.Cameras.Count ? view : throw frame.Problem($"its view '{frame.Label.View}' is no camera of the rig.");
    }

    private static RigLidar LidarOf(ExportFrame frame, SweepLabel sweep) =>
        frame.Rig?.Lidars.FirstOrDefault(each => each.Name == sweep.Sensor)
        ?? throw frame.Problem($"its LiDAR '{sweep.Sensor}' is not in the rig.");

    private static (string Frame, Pose Pose) PlaceOf(ExportFrame frame, RigLidar lidar)
    {
        EgoLabel ego = frame.Label.Ego;
        var vehicle = new Pose(ego.Position, ego.Axes ?? Axes.FromHeading(ego.HeadingDegrees));
        return (CameraChannels.LidarFrame(lidar), vehicle.Compose(frame.Rig!.OnVehicle(lidar.Mount)));
    }

    private static long Nanoseconds(double seconds) => (long)Math.Round(seconds * NanosecondsPerSecond);

    /// <summary>The image as PNG or JPEG, which are the formats that readers know.</summary>
    private static (byte[] Bytes, string Format) ImageOf(ExportFrame frame, FrameOutput output)
    {
        if (frame.ImageExtension == ImageFormat.Bmp.Extension())
        {
            using var png = new MemoryStream();
            new PictureEncoder(ImageFormat.Png).Write(frame.ReadImage(), png);
            return (png.ToArray(), "png");
        }

        return (output.ImageBytes(frame), frame.ImageExtension == ImageFormat.Png.Extension() ? "png" : "jpeg");
    }
}
