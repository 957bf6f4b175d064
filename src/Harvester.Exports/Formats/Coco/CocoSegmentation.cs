using System.Text.Json;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Coco;

/// <summary>The segmentation of an annotation: run lengths or polygons; empty without a mask.</summary>
internal sealed class CocoSegmentation
{
    private readonly ImageSize _image;
    private readonly IReadOnlyList<int> _runs = [];
    private readonly IReadOnlyList<IReadOnlyList<Vector2D>> _outlines = [];

    /// <summary>The segmentation of an object.</summary>
    /// <param name="kind">The encoding.</param>
    /// <param name="pixels">The object's pixels; null without a mask.</param>
    public CocoSegmentation(SegmentationKind kind, InstancePixels? pixels)
    {
        if (pixels is not null)
        {
            _image = pixels.Map.Image;
            Area = pixels.Area;
            _runs = kind == SegmentationKind.Rle ? MaskRuns.Encode(pixels) : [];
            _outlines = kind == SegmentationKind.Polygon ? pixels.Regions() : [];
        }
    }

    private CocoSegmentation(ImageSize image, IReadOnlyList<int> runs)
    {
        _image = image;
        _runs = runs;
        Area = runs.Where((_, i) => i % 2 == 1).Sum();
    }

    /// <summary>Number of pixels; null without a mask.</summary>
    public int? Area { get; }

    /// <summary>
    /// The segmentation of an ignore region: its visible pixels, or its whole box without a mask. The format encodes crowds by run lengths.
    /// </summary>
    public static CocoSegmentation OfRegion(ExportRegion region, ExportFrame frame) =>
        frame.Mask is null ? new CocoSegmentation(SegmentationKind.Rle, null)
        : region.Label is { } label && frame.PixelsOf(label) is { } pixels ? new CocoSegmentation(SegmentationKind.Rle, pixels)
        : new CocoSegmentation(frame.Mask.Image, RunsOf(region.Box, frame.Mask.Image));

    /// <summary>Writes the segmentation as a JSON value.</summary>
    public void Write(Utf8JsonWriter json)
    {
        if (_runs.Count > 0)
        {
            WriteRuns(json);
            return;
        }

        json.WriteStartArray();
        foreach (IReadOnlyList<Vector2D> outline in _outlines)
        {
            json.WriteStartArray();
            foreach (Vector2D corner in outline)
            {
                json.Value(corner.X, 0);
                json.Value(corner.Y, 0);
            }

            json.WriteEndArray();
        }

        json.WriteEndArray();
    }

    private void WriteRuns(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        json.WriteStartArray("size");
        json.WriteNumberValue(_image.Height);
        json.WriteNumberValue(_image.Width);
        json.WriteEndArray();
        json.WriteStartArray("counts");
        foreach (int count in _runs)
        {
            json.WriteNumberValue(count);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    /// <summary>The pixels that a box touches, as run lengths by column, beginning with the background.</summary>
    private static List<int> RunsOf(Box2D box, ImageSize image)
    {
        (int left, int right) = (Math.Max(0, (int)Math.Floor(box.XMin)), Math.Min(image.Width, (int)Math.Ceiling(box.XMax)));
        (int top, int bottom) = (Math.Max(0, (int)Math.Floor(box.YMin)), Math.Min(image.Height, (int)Math.Ceiling(box.YMax)));
        var runs = new List<int>();
        int end = 0;
        for (int column = left; column < right; column++)
        {
            int begin = (column * image.Height) + top;
            if (begin == end && runs.Count > 0)
            {
                runs[^1] += bottom - top;
            }
            else
            {
                runs.AddRange([begin - end, bottom - top]);
            }

            end = (column * image.Height) + bottom;
        }

        runs.Add((int)image.PixelCount - end);
        return runs;
    }
}
