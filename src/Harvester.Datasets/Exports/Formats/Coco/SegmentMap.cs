using System;
using System.Collections.Generic;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;

namespace Harvester.Datasets.Exports.Formats.Coco;

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
    public SegmentMap(InstanceMap mask, Func<int, int> segmentOf)
        : this(Draw(mask, segmentOf))
    {
    }

    /// <summary>The image.</summary>
    public PixelBuffer Picture { get; }

    /// <summary>The segments by id.</summary>
    public IReadOnlyDictionary<int, Segment> Segments { get; }

    private static PixelBuffer Draw(InstanceMap mask, Func<int, int> segmentOf)
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
            picture.Bytes[at] = (byte)segment;
            picture.Bytes[at + 1] = (byte)(segment >> 8);
            picture.Bytes[at + 2] = (byte)(segment >> 16);
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
                for (end = column + 1; end < picture.Size.Width && IdAt(picture, end, row) == id; end++)
                {
                }

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
