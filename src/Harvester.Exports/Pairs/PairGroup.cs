using System.Globalization;
using System.Text.RegularExpressions;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Pairs;

/// <summary>All pictures of one moment, which share its labels.</summary>
internal sealed class PairGroup
{
    /// <summary>What the frame's own image is named, without its ending.</summary>
    private const string FrameImage = "frame";

    private static readonly Regex SafeName = new(@"\A[A-Za-z0-9][A-Za-z0-9-]{0,79}\.(png|bmp|jpg)\z", RegexOptions.CultureInvariant);

    private PairGroup(string key, LabelLine line, IReadOnlyList<PairImage> images) => (Key, Line, Images) = (key, line, images);

    /// <summary>Its key: the number of the frame.</summary>
    public string Key { get; }

    /// <summary>The label that its pictures share.</summary>
    public LabelLine Line { get; }

    /// <summary>The frame's image, then the others in the order of the label.</summary>
    public IReadOnlyList<PairImage> Images { get; }

    /// <summary>The pictures of a frame.</summary>
    /// <exception cref="DatasetFormatException">A name of the label cannot be used.</exception>
    public static PairGroup Of(LabelLine line)
    {
        FrameLabel label = line.Label!;
        if (label.Frame < 0)
        {
            throw new DatasetFormatException($"Frame {label.Frame} has a negative number. Run 'harvester validate'.");
        }

        var images = new List<PairImage>
        {
            new(
                FrameImage + Path.GetExtension(label.Image),
                label.Image,
                new PairLabel(label.Image, label.Environment.Weather, label.Environment.TimeOfDay, [])
            ),
        };
        images.AddRange(
            label.Pairs.Where(pair => pair.File is not null).Select(pair => new PairImage(Path.GetFileName(pair.File!), pair.File!, pair))
        );
        string? unusable =
            images.Select(image => image.Name).FirstOrDefault(name => !SafeName.IsMatch(name))
            ?? images.GroupBy(image => image.Name).FirstOrDefault(same => same.Count() > 1)?.Key;
        return unusable is null
            ? new PairGroup(label.Frame.ToString("D8", CultureInfo.InvariantCulture), line, images)
            : throw new DatasetFormatException(
                $"Frame {label.Frame} has a picture named '{unusable}', which is no name of a harvest or occurs twice. "
                    + "Run 'harvester validate'."
            );
    }

    /// <summary>The box around all objects that a picture lacks and the label lists, pixels; null if there are none.</summary>
    public Box2D? BoxOf(PairImage image)
    {
        Box2D[] boxes = [.. Line.Label!.Objects.Where(item => image.Pair.Without.Contains(item.Id)).Select(item => item.Box2D)];
        return boxes.Length == 0
            ? null
            : new Box2D(boxes.Min(box => box.XMin), boxes.Min(box => box.YMin), boxes.Max(box => box.XMax), boxes.Max(box => box.YMax));
    }
}
