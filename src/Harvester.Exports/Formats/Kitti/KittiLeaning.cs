using System.Globalization;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// A table, our own addition to the format, of objects that are tilted so much in the camera's frame that their projected upright boxes
/// miss their 2D boxes by more than a limit.
/// </summary>
internal static class KittiLeaning
{
    /// <summary>Upright boxes that miss by at most this are not in the table, pixels.</summary>
    public const double MaxMissPixels = 1;

    private const string File = "training/leaning.csv";
    private const string Header = "file,line,lean_degrees,moved_m,miss_px\n";
    private const string Part = "leaning";
    private const int Columns = 5;

    /// <summary>Adds the row of an object, if it belongs in the table.</summary>
    /// <param name="output">Receives the row.</param>
    /// <param name="file">Name of the label file.</param>
    /// <param name="line">Identifies the object's line in the label file.</param>
    /// <param name="box">The object.</param>
    public static void Add(FrameOutput output, string file, string line, KittiBox box)
    {
        if (box.MissPixels > MaxMissPixels)
        {
            string lean = Numbers.Row(KittiDecimals.Angle, box.LeanDegrees);
            string moved = Numbers.Row(KittiDecimals.Metres, box.MovedMetres);
            output.Part(Part, $"{file},{line},{lean},{moved},{Numbers.Row(KittiDecimals.Pixels, box.MissPixels)}");
        }
    }

    /// <summary>Whether a part is a row of the table.</summary>
    public static bool Is(string part) => part == Part;

    /// <summary>The table.</summary>
    public static AggregateFile Table() => new(File, [AggregateSection.Literal(Header), AggregateSection.Lines(Part)]);

    /// <summary>
    /// Allowed misses of the objects of a label file, pixels, by what identifies their lines; for objects that are not listed, <see
    /// cref="MaxMissPixels"/>.
    /// </summary>
    public static IReadOnlyDictionary<string, double> MissesOf(DatasetContent dataset)
    {
        var misses = new Dictionary<string, double>();
        foreach ((_, string text) in dataset.Lines(File).Skip(1))
        {
            string[] words = text.Split(',');
            if (words.Length == Columns && double.TryParse(words[^1], NumberStyles.Float, CultureInfo.InvariantCulture, out double miss))
            {
                misses[$"{words[0]},{words[1]}"] = miss;
            }
        }

        return misses;
    }
}
