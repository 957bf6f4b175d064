using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Writes MCAP: a file per place with a chunk per frame. See docs/exports/mcap.md.</summary>
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
        var messages = new FoxgloveMessages(label, nanoseconds);
        (byte[] image, string format) = ImageOf(frame, output);
        var all = new List<McapMessage>
        {
            new(McapChannel.Image, messages.Image(image, format)),
            new(McapChannel.Calibration, messages.Calibration()),
            new(McapChannel.Transforms, messages.Transforms()),
            new(McapChannel.Objects, messages.Objects(frame.Objects)),
        };
        if (label.Lanes is { } lanes)
        {
            all.Add(new(McapChannel.Lanes, messages.Lanes(lanes)));
        }

        all.Add(new(McapChannel.Annotations, messages.Annotations(frame.Objects)));
        if (label.Lanes is { Status: Harvester.Geometry.Lanes.LaneStatus.Known } known)
        {
            all.Add(new(McapChannel.Indicators, IndicatorMessage.Of(label, known, nanoseconds)));
        }

        if (label.Drive is { } drive)
        {
            all.AddRange(DriveMessages.Of(drive, nanoseconds, Nanoseconds));
        }

        if (label.Events is { } events)
        {
            all.Add(new(McapChannel.Events, EventMessage.Of(events, nanoseconds)));
        }

        if (label.Channels.Get<BirdsEyeLabel>() is { } map)
        {
            all.Add(new(McapChannel.BirdsEye, GridMessage.Of(frame, map, nanoseconds)));
        }

        output.StagedPart(
            $"{frame.Split}/{frame.SequenceIndex:D4}.mcap",
            frame.Name + ".chunk",
            stream => McapChunk.Write(stream, nanoseconds, frame.FrameInSequence, all)
        );
        return new WrittenObjects(frame.Objects.Count);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts.Keys.Select(file => new AggregateFile(file, [AggregateSection.Container(file, McapFile.Write)]));

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
