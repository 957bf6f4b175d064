using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;

namespace Harvester.Exports.Formats.Coco;

/// <summary>
/// A panoptic image: the colour of a pixel is the id of its segment, red + 256 green + 65536 blue. Black pixels have no segment.
/// </summary>
internal sealed class SegmentMap
{
    /// <summary>Reads the segments of an image.</summary>
    public SegmentMap(PixelBuffer picture)
    {
        Picture = picture;
        Segments = Find(picture);
    }

    /// <summary>Draws a mask.</summary>
    /// <param name="mask">The mask.</param>
    /// <param name="segmentOf">The segment of a mask value.</param>
    /// <param name="classes">The class map, which is drawn where the mask is 0; null without one.</param>
    /// <param name="surfaceOf">The segment of a value of the class map.</param>
    public SegmentMap(InstanceMap mask, Func<int, int> segmentOf, InstanceMap? classes, Func<int, int> surfaceOf)
        : this(Draw(mask, segmentOf, classes, surfaceOf)) { }

    /// <summary>The image.</summary>
    public PixelBuffer Picture { get; }

    /// <summary>The segments by id.</summary>
    public IReadOnlyDictionary<int, Segment> Segments { get; }

    private static PixelBuffer Draw(InstanceMap mask, Func<int, int> segmentOf, InstanceMap? classes, Func<int, int> surfaceOf)
    {
        var picture = new PixelBuffer(mask.Image);
        (ushort value, int segment) = ((ushort)0, segmentOf(0));
        for (int i = 0; i < mask.Ids.Length; i++)
        {
            if (mask.Ids[i] != value)
            {
                value = mask.Ids[i];
                segment = segmentOf(value);
            }

            int at = i * PixelBuffer.BytesPerPixel;
            int drawn = classes is not null && value == 0 ? surfaceOf(classes.Ids[i]) : segment;
            picture.Bytes[at] = (byte)drawn;
            picture.Bytes[at + 1] = (byte)(drawn >> 8);
            picture.Bytes[at + 2] = (byte)(drawn >> 16);
        }

        return picture;
    }

    private static Dictionary<int, Segment> Find(PixelBuffer picture)
    {
        var segments = new Dictionary<int, Segment>();
        for (int row = 0; row < picture.Size.Height; row++)
        {
            for (int column = 0, end; column < picture.Size.Width; column = end)
            {
                int id = IdAt(picture, column, row);
                for (end = column + 1; end < picture.Size.Width && IdAt(picture, end, row) == id; end++) { }

                if (id != 0)
                {
                    segments[id] = segments.TryGetValue(id, out Segment? earlier)
                        ? earlier.With(column, end, row)
                        : new Segment(id, column, row, end, row + 1, end - column);
                }
            }
        }

        return segments;
    }

    private static int IdAt(PixelBuffer picture, int column, int row)
    {
        int at = ((row * picture.Size.Width) + column) * PixelBuffer.BytesPerPixel;
        return picture.Bytes[at] | (picture.Bytes[at + 1] << 8) | (picture.Bytes[at + 2] << 16);
    }
}
