using System.Text.Json;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Predictions;

/// <summary>The box around a segmentation of COCO results, for predictions that have no bbox of their own.</summary>
internal static class SegmentationBounds
{
    private const int MaxSide = 1 << 16;
    private const string Wrong = "segmentation is neither polygons, [[x, y, x, y, x, y, ...], ...], nor run lengths with size and counts.";

    // A character of a count has 5 bits, of which the highest of the last character is the sign, and a bit that says whether more follow.
    private const int FirstCharacter = 48;
    private const int Bits = 5;
    private const int MoreBit = 0x20;
    private const int SignBit = 0x10;
    private const int MaxCharacters = 7;

    /// <summary>The box: x, y, width and height, pixels; all 0 for a segmentation without pixels.</summary>
    /// <exception cref="DatasetFormatException">It is not a segmentation as COCO defines it.</exception>
    public static double[] Of(JsonElement segmentation) =>
        segmentation.ValueKind switch
        {
            JsonValueKind.Array => OfPolygons(segmentation),
            JsonValueKind.Object => OfRuns(segmentation),
            _ => throw new DatasetFormatException(Wrong),
        };

    private static double[] OfPolygons(JsonElement polygons)
    {
        var x = new List<double>();
        var y = new List<double>();
        foreach (JsonElement polygon in polygons.EnumerateArray())
        {
            if (
                polygon.ValueKind != JsonValueKind.Array
                || polygon.GetArrayLength() % 2 != 0
                || polygon.EnumerateArray().Any(number => number.ValueKind != JsonValueKind.Number)
            )
            {
                throw new DatasetFormatException(Wrong);
            }

            foreach ((int index, JsonElement number) in polygon.EnumerateArray().Index())
            {
                (index % 2 == 0 ? x : y).Add(number.GetDouble());
            }
        }

        return x.Count == 0 ? new double[4] : [x.Min(), y.Min(), x.Max() - x.Min(), y.Max() - y.Min()];
    }

    /// <summary>Runs of pixels by columns, in turn outside and inside.</summary>
    private static double[] OfRuns(JsonElement segmentation)
    {
        var fields = new JsonFields(segmentation);
        double[] size = fields.Numbers("size", 2);
        (double height, double width) = (size[0], size[1]);
        if (!(height is >= 1 and <= MaxSide && width is >= 1 and <= MaxSide))
        {
            throw new DatasetFormatException("the size of segmentation is not height and width in pixels.");
        }

        long rows = (long)height;
        long end = rows * (long)width;
        (long left, long top, long right, long bottom) = (long.MaxValue, long.MaxValue, -1, -1);
        long at = 0;
        bool isInside = false;
        foreach (long count in Counts(segmentation))
        {
            if (count < 0 || at + count > end)
            {
                throw new DatasetFormatException("the counts of segmentation do not fit its size.");
            }

            if (isInside && count > 0)
            {
                long last = at + count - 1;
                bool isOneColumn = at / rows == last / rows;
                (left, right) = (Math.Min(left, at / rows), Math.Max(right, last / rows));
                top = Math.Min(top, isOneColumn ? at % rows : 0);
                bottom = Math.Max(bottom, isOneColumn ? last % rows : rows - 1);
            }

            at += count;
            isInside = !isInside;
        }

        return right < 0 ? new double[4] : [left, top, right + 1 - left, bottom + 1 - top];
    }

    private static IEnumerable<long> Counts(JsonElement segmentation) =>
        !segmentation.TryGetProperty("counts", out JsonElement counts) ? throw new DatasetFormatException(Wrong)
        : counts.ValueKind == JsonValueKind.String ? Unpacked(counts.GetString()!)
        : counts.ValueKind == JsonValueKind.Array
            ? counts
                .EnumerateArray()
                .Select(count => count.ValueKind == JsonValueKind.Number && count.TryGetInt64(out long value) ? value : -1)
        : throw new DatasetFormatException(Wrong);

    /// <summary>The counts of COCO's compressed text: from the fourth on, each is the difference from the one two before it.</summary>
    private static List<long> Unpacked(string text)
    {
        var counts = new List<long>();
        for (int at = 0; at < text.Length; )
        {
            long value = 0;
            bool hasMore = true;
            for (int part = 0; hasMore; part++, at++)
            {
                int bits = at < text.Length ? text[at] - FirstCharacter : -1;
                if (bits is < 0 or > 63 || part == MaxCharacters)
                {
                    throw new DatasetFormatException("the counts of segmentation are not COCO's compressed run lengths.");
                }

                value |= (long)(bits & 0x1F) << (Bits * part);
                hasMore = (bits & MoreBit) != 0;
                if (!hasMore && (bits & SignBit) != 0)
                {
                    value |= -1L << (Bits * (part + 1));
                }
            }

            counts.Add(counts.Count > 2 ? value + counts[^2] : value);
        }

        return counts;
    }
}
